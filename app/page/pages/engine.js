// The engine: what was compiled for browsers from the program's own sources (app/page/engine). Numbers go to and fro
// in one array of its memory.
function bytesOf(letters) {
  const packed = atob(letters), bytes = new Uint8Array(packed.length);
  for (let i = 0; i < packed.length; ++i) bytes[i] = packed.charCodeAt(i);
  return bytes;
}

async function unpacked(bytes, kind) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(kind));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Returns the letters of a part of the page; null if it was cut off on its way.
function lettersIn(id) {
  const part = document.getElementById(id);
  const letters = part ? part.textContent : "";
  return part && letters.length === Number(part.dataset.length) ? letters : null;
}

class Engine {
  static async load(letters) {
    const none = new Proxy({}, { get: () => () => 0 });
    const bytes = await unpacked(bytesOf(letters), "gzip");
    const made = await WebAssembly.instantiate(bytes, { wasi_snapshot_preview1: none });
    return new Engine(made.instance.exports);
  }

  constructor(functions) {
    this.functions = functions;
    functions._initialize();
  }

  // Calls a function with these numbers in the array, and returns its own value.
  call(name, numbers, ...values) {
    if (numbers.length) {
      const at = this.functions.give(numbers.length);
      new Float64Array(this.functions.memory.buffer, at, numbers.length).set(numbers);
    }
    return this.functions[name](...values);
  }

  // The same; returns the numbers that it leaves in the array.
  ask(name, numbers, ...values) {
    this.call(name, numbers, ...values);
    const count = this.functions.answerCount();
    return new Float64Array(this.functions.memory.buffer, this.functions.answered(), count).slice();
  }

  // What the eye at this event sees of all bodies: their legs for the graphics card, and of each body where they begin,
  // their number, and c (t - t_o) from when on it exists.
  look(event, headFromBoard, effects, moment) {
    const ranges = this.ask("look", [...event, ...headFromBoard], effects, moment);
    const count = this.functions.legCount() * 68;
    const legs = new Float32Array(this.functions.memory.buffer, this.functions.legs(), count).slice();
    return { ranges, legs };
  }

  frames(headFromBoard, effects, moment) {
    const numbers = this.ask("frames", headFromBoard, effects, moment);
    return {
      drawnFromSeen: numbers.slice(0, 16),
      boardFromDrawn: numbers.slice(16, 32),
      headOnBoard: numbers.slice(32, 36),
      exposure: numbers.slice(36, 39),
    };
  }

  colours() {
    return new Float32Array(this.functions.memory.buffer, this.functions.colourTexels(), 4 * 1024 * 9).slice();
  }
}
