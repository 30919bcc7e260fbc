// The beginning, what links and tests ask for, and what happens when something fails.
const texts = {};
const part = id => document.getElementById(id);
const fill = (words, ...values) => words.replace(/\{\}/g, () => values.shift());

function sorry(name) {
  document.body.classList.remove("ready");
  part("sorry").textContent = texts[name] || part("sorry").dataset[name] || name;
  part("sorry").hidden = false;
  document.title = "failed";
}

// Whatever fails is said, and the still picture stays.
function guarded(work) {
  return (...values) => {
    try {
      return work(...values);
    } catch (error) {
      console.error(error);
      sorry(error instanceof WebAssembly.RuntimeError ? "trapped" : "failed");
      throw error;
    }
  };
}

function asked() {
  const wants = {};
  for (const one of location.hash.slice(1).split("&")) {
    const [name, value = ""] = one.split("=");
    if (name) wants[name] = decodeURIComponent(value);
  }
  return wants;
}

class Shown {
  constructor(content, engine) {
    this.content = content;
    this.about = content.about;
    this.engine = engine;
    const isLive = Number.isInteger(this.about.live);
    this.frames = isLive ? new LiveFrames(content) : new Frames(content);
    this.known = isLive ? new LiveKnown(content, engine) : new Known(content, engine);
    this.known.begin();
    this.picture = new Picture(part("picture"), content, engine);
    this.watcher = new Watcher(content, engine, this.frames, this.known);
    this.live = isLive ? new Live(this) : null;
  }

  // Draws a stored frame as a wall's picture, in its pixels.
  drawWall(number, name, eyeName) {
    const place = this.frames.numbers.indexOf(number), wall = this.about.walls.find(one => one.name === name);
    if (place < 0 || !wall) return sorry("nothing");
    this.known.goTo(place);
    const frame = this.frames.stored(place), { canvas } = this.picture;
    [canvas.width, canvas.height] = wall.pixels;
    canvas.style.width = wall.pixels[0] + "px";
    canvas.style.height = wall.pixels[1] + "px";
    this.drawParts(frame, frame.eyes[eyeName] || frame.eyes.mono, wall);
    document.title = "ready";
  }

  // A wall that is split shows its right half with other effects.
  drawParts(frame, eye, wall) {
    const [width, height] = wall.pixels, isSplit = (frame.views >> 5) & 1, middle = isSplit ? width >> 1 : width;
    this.drawColumns(frame, eye, wall, 0, middle, frame.effects);
    if (!isSplit) return;
    this.drawColumns(frame, eye, wall, middle, width, frame.beside);
    const { gl } = this.picture;
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor((width >> 1) - 1, 0, 3, height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.disable(gl.SCISSOR_TEST);
  }

  drawColumns(frame, eye, wall, from, to, effects) {
    const clip = clipOfWall(columnsOf(wall, from, to), eye);
    if (!clip) return;
    this.picture.look(eye, frame.headFromBoard, effects, ghostsOf(frame, eye, frame.views, effects));
    this.picture.draw(clip, [from, 0, to - from, wall.pixels[1]], this.picture.plan(true));
  }

  // The eye of a stored frame, or of the observer who was set.
  eyeOf(number, name) {
    const place = this.frames.numbers.indexOf(number);
    const view = place < 0 ? this.watcher.view(this.frames.from_s, 0, [0, 0, 0]) : this.frames.stored(place);
    if (place >= 0) this.known.goTo(place);
    return { view, eye: view.eyes[name] || view.eyes.mono };
  }

  // The functions for tests and links.
  functions() {
    return {
      frames: () => this.frames.numbers.slice(),
      seen: (number, eyeName, body, places) => {
        const { view, eye } = this.eyeOf(number, eyeName);
        this.picture.look(eye, view.headFromBoard, view.effects, []);
        return this.picture.solve(body, places);
      },
      // The kernel of the shaders in double.
      twin: (number, eyeName, body, places) => {
        const { view, eye } = this.eyeOf(number, eyeName);
        this.engine.look(eye.event, view.headFromBoard, view.effects, 0);
        const found = this.engine.ask("seenPlaces", places.flat(), body, places.length);
        return places.map((_, i) => (Number.isNaN(found[4 * i]) ? null : Array.from(found.slice(4 * i, 4 * i + 3))));
      },
      // By each place's whole world line.
      engine: (number, eyeName, body, places) => {
        const { view, eye } = this.eyeOf(number, eyeName);
        return places.map(place => {
          const found = this.engine.ask("seenPoint", [...place, ...eye.event, ...view.headFromBoard], body);
          return found.length ? Array.from(found.slice(4, 7)) : null;
        });
      },
      // Plays the page's game anew with these strokes besides its own, and returns all its events.
      play: (until_s, strokes) => playedAnew(this.about, this.engine, until_s, strokes),
      // Compiles variants of the shaders that this page can ask for, by default all, and returns their number.
      programs: (keys = Object.keys(this.about.shaders.variants)) => {
        for (const key of keys) this.picture.program(key, true);
        return keys.length;
      },
      body: name => this.about.bodies.findIndex((one, i) => i > 0 && one.name === name),
      about: () => this.about,
      // Of a page that follows a game: how often it was told, and how often all anew.
      told: () => this.live && { messages: this.live.messages, wholes: this.live.wholes },
    };
  }
}

// The ghosts of a moment: both at that of the point between the eyes.
function ghostsOf(frame, eye, views, effects) {
  const ghosts = [];
  if (views & 1 && effects & 1) ghosts.push({ moment: 1, event: [frame.eyes.mono.event[0], ...eye.event.slice(1)] });
  if (views & 2) ghosts.push({ moment: 2, event: eye.event });
  return ghosts;
}

async function start() {
  const letters = lettersIn("visit"), engine = lettersIn("engine");
  if (!letters || !engine) return sorry("cut");
  const [content, made] = await Promise.all([Content.load(letters), Engine.load(engine)]);
  Object.assign(texts, content.about.texts);
  const shown = new Shown(content, made);
  if (!shown.picture.isThere) return sorry("noWebgl");
  window.carom = shown.functions();
  for (const [name, work] of Object.entries(window.carom)) window.carom[name] = guarded(work);
  document.body.classList.add("ready");
  const controls = new Controls(shown);
  window.carom.where = guarded(body => controls.where(body));
  window.carom.observer = guarded(wanted => controls.watchAs(wanted));
  const follow = guarded(() => {
    const wants = asked();
    document.body.classList.toggle("bare", "bare" in wants);
    if ("frame" in wants) {
      controls.stop();
      document.title = "drawing";
      return shown.drawWall(Number(wants.frame), wants.wall, wants.eye);
    }
    if ("t" in wants) controls.seek(Number(wants.t));
    controls.begin();
    document.title = content.about.title;
    return undefined;
  });
  window.addEventListener("hashchange", follow);
  follow();
}

document.addEventListener("DOMContentLoaded", () => start().catch(error => {
  console.error(error);
  sorry(error instanceof WebAssembly.RuntimeError ? "trapped" : "cut");
}));
