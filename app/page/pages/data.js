// The visit as the page holds it: frames, what becomes known of the game in each of them, meshes.
class Content {
  static async load(letters) {
    return new Content(await unpacked(bytesOf(letters), "deflate"));
  }

  constructor(bytes) {
    const length = new DataView(bytes.buffer).getUint32(0, true);
    this.about = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
    this.bulk = bytes.subarray(4 + length);
  }

  // A column of numbers: all first bytes, then all second ones and so on, each number with that before it taken out.
  column(of) {
    const kinds = { f64: Float64Array, f32: Float32Array, i16: Int16Array, u32: Uint32Array, u8: Uint8Array };
    const numbers = new kinds[of.kind](of.count), size = numbers.BYTES_PER_ELEMENT;
    const bytes = new Uint8Array(numbers.buffer);
    for (let plane = 0, from = of.at; plane < size; ++plane)
      for (let i = 0; i < of.count; ++i) bytes[i * size + plane] = this.bulk[from++];
    if (of.kind === "f64" || of.kind === "f32") {
      for (let i = size; i < bytes.length; ++i) bytes[i] ^= bytes[i - size];
    } else {
      for (let i = 1; i < of.count; ++i) numbers[i] += numbers[i - 1];
    }
    return numbers;
  }

  // Rows that lie in one column, the first numbers of all of them first.
  rows(of) {
    const column = this.column(of), width = of.rows ? of.count / of.rows : 0;
    return Array.from({ length: of.rows }, (_, row) =>
      Float64Array.from({ length: width }, (__, i) => column[i * of.rows + row]));
  }
}

const endless = value => (value === "endless" ? Infinity : value);

// The frames of a visit. Those between are made from the two beside them.
class Frames {
  constructor(content) {
    const { about } = content;
    this.rows = content.rows(about.frames.numbers);
    this.states = content.column(about.frames.states);
    this.numbers = this.rows.map(row => row[0]);
  }

  get count() { return this.rows.length; }
  get from_s() { return this.rows[0][1]; }
  get until_s() { return this.rows[this.count - 1][1]; }

  // The last frame that was shown by this time.
  at(display_s) {
    let low = 0, high = this.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.rows[middle][1] <= display_s) low = middle; else high = middle - 1;
    }
    return low;
  }

  statesAt(place) { return this.states.subarray(4 * place, 4 * place + 4); }

  state(place, row) {
    const eye = at => ({ event: row.slice(at, at + 4), inRoom: row.slice(at + 4, at + 7), seenFrom: row.slice(at + 7, at + 10) });
    const state = this.statesAt(place);
    return {
      place, number: row[0], display_s: row[1], own_s: row[2], fade: row[3],
      eyes: { left: eye(4), right: eye(14), mono: eye(24) },
      headFromBoard: row.slice(34, 50), boardFromRoom: row.slice(50, 66),
      effects: state[0], views: state[1], beside: state[2], phase: state[3],
    };
  }

  stored(place) { return this.state(place, this.rows[place]); }

  // A moment between frames: the eyes' events go along straight lines from one to the next, which are timelike where both are
  // on one world line.
  between(display_s) {
    const place = this.at(display_s), row = this.rows[place], next = this.rows[Math.min(place + 1, this.count - 1)];
    const span_s = next[1] - row[1];
    const share = span_s > 0 ? Math.min(1, Math.max(0, (display_s - row[1]) / span_s)) : 0;
    const mixed = row.map((value, i) => (i === 0 ? value : value + share * (next[i] - value)));
    // Mixed transforms are none: of each the nearest boost and rotation that is one.
    for (const at of [34, 50]) mixed.set(nearestLorentz(mixed.slice(at, at + 16)), at);
    return this.state(place, mixed);
  }
}

// The game as it becomes known: the engine's world lines, for any frame of the visit.
class Known {
  constructor(content, engine) {
    this.engine = engine;
    this.about = content.about;
    this.changes = content.rows(this.about.changes.changes);
    this.knots = content.rows(this.about.changes.knots);
    this.at = -1;
  }

  begin() {
    this.engine.call("beginVisit", [], this.about.lightSpeed_m_s);
    this.about.bodies.forEach((body, number) => {
      const [first, ...rest] = body.knots;
      this.engine.call("addBody", first, Math.max(body.reach_m, endless(body.radius_m)),
        body.appears_s === null ? -Infinity : body.appears_s);
      for (const knot of rest) this.engine.call("appendKnot", knot, number);
    });
    this.change = this.knot = 0;
    this.at = -1;
  }

  // Brings the world lines to what is known in a frame, from its place.
  goTo(place) {
    if (place < this.at || this.at < 0) this.begin();
    for (; this.change < this.changes.length && this.changes[this.change][0] <= place; ++this.change) {
      const [, cut_s, count] = this.changes[this.change];
      if (cut_s < 1e299) this.engine.call("truncatePucks", [], this.about.pucks, cut_s);
      for (let i = 0; i < count; ++i, ++this.knot) {
        const row = this.knots[this.knot];
        this.engine.call("appendKnot", row.subarray(0, 17), row[17]);
      }
    }
    this.at = place;
  }

  goToEnd() { this.goTo(Number.MAX_SAFE_INTEGER); }
}
