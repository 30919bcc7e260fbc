// The game while it is played: the page is told what is new, and shows it a little later, so that nothing is guessed.
const kLate_s = 0.1, kRowNumbers = 66, kStates = 4, kKnotNumbers = 17, kRowsKept = 200, kAgain_ms = 1500, kDrift_s = 0.0005;

// The frames that have been told. Of those before the ones that are needed a few seconds stay.
class LiveFrames extends Frames {
  constructor(content) {
    super(content);
    this.told = [this.states];
  }

  statesAt(place) { return this.told[place]; }

  // The frames before are not those of the same course, if the clock has gone back or has paused.
  add(row, states, isAnew) {
    if (isAnew) this.rows = this.told = [];
    this.rows = [...this.rows.slice(-kRowsKept), row];
    this.told = [...this.told.slice(-kRowsKept), states];
  }
}

// What is known of the game: changes wait until the frame that brought them is shown.
class LiveKnown extends Known {
  constructor(content, engine) {
    super(content, engine);
    this.waiting = [];
    this.shown_s = -Infinity;
  }

  anew({ bodies, events, known_s }) {
    bodies.forEach((knots, body) => { this.about.bodies[body].knots = knots; });
    this.about.events = events;
    this.about.known_s = known_s;
    this.waiting = [];
    this.begin();
  }

  // A page that nobody looks at shows no frames: what has waited for long is known without them.
  await(news) {
    this.waiting.push(news);
    while (this.waiting.length > kRowsKept) this.apply(this.waiting.shift());
  }

  goTo() {
    while (this.waiting.length && this.waiting[0].at_s <= this.shown_s) this.apply(this.waiting.shift());
  }

  goToEnd() { this.goTo(); }

  apply({ changes, known_s }) {
    const { about } = this;
    about.known_s = known_s;
    for (const { cut_s, knots, kept, events } of changes) {
      if (cut_s < 1e299) this.engine.call("truncatePucks", [], about.pucks, cut_s);
      for (const { body, knot } of knots) this.engine.call("appendKnot", knot, body);
      about.events = [...about.events.filter(event => event.number < kept), ...events];
    }
  }
}

// Reads a message (app/page/live_game.h).
class Told {
  constructor(bytes) {
    this.numbers = new Float64Array(bytes);
    this.at = 0;
    this.isAnew = this.number() === 1;
    this.game = this.number();
    this.known_s = this.number();
    this.row = this.some(kRowNumbers);
    this.states = Uint32Array.from(this.some(kStates));
    if (this.isAnew) this.bodies = this.list(() => this.list(() => this.some(kKnotNumbers)));
    if (this.isAnew) this.events = this.list(() => this.event());
    else this.changes = this.list(() => this.change());
  }

  number() {
    if (this.at >= this.numbers.length) throw new Error("a message is cut off");
    return this.numbers[this.at++];
  }

  some(count) { return Float64Array.from({ length: count }, () => this.number()); }

  list(one) { return Array.from({ length: this.number() }, one); }

  event() {
    const [number, kind, cushion, ...at] = this.some(7);
    return { number, kind, cushion, at, pucks: this.list(() => this.number()) };
  }

  change() {
    const cut_s = this.number();
    const knots = this.list(() => ({ knot: this.some(kKnotNumbers), body: this.number() }));
    return { cut_s, knots, kept: this.number(), events: this.list(() => this.event()) };
  }
}

class Live {
  constructor(shown) {
    this.shown = shown;
    this.ahead_s = Infinity; // of the page's clock before the session's, and the way of the quickest message
    this.messages = this.wholes = 0;
    this.isThere = false;
    this.connect();
  }

  connect() {
    const socket = new WebSocket(location.href.replace(/^http/, "ws").replace(/#.*/, "") + "/socket");
    socket.binaryType = "arraybuffer";
    socket.onmessage = guarded(({ data }) => this.take(new Told(data)));
    socket.onclose = () => {
      this.isThere = false;
      setTimeout(() => this.connect(), kAgain_ms);
    };
  }

  take(told) {
    const { frames, known } = this.shown, display_s = told.row[1];
    if (told.game !== this.shown.about.live) return this.reload();
    this.isThere = true;
    ++this.messages;
    this.ahead_s = Math.min(this.ahead_s + kDrift_s, performance.now() / 1000 - display_s);
    frames.add(told.row, told.states, told.isAnew);
    if (told.isAnew) {
      ++this.wholes;
      known.anew(told);
    } else {
      known.await({ at_s: display_s, changes: told.changes, known_s: told.known_s });
    }
    return undefined;
  }

  // Another game is played: its page. Not all phones ask at once.
  reload() {
    if (this.reloads) return;
    this.reloads = true;
    setTimeout(() => location.reload(), 2000 * Math.random());
  }

  // The moment that is shown now.
  now_s() {
    const { frames, known } = this.shown, wanted_s = performance.now() / 1000 - this.ahead_s - kLate_s;
    const now_s = Math.min(frames.until_s, Math.max(frames.from_s, wanted_s));
    known.shown_s = now_s;
    return now_s;
  }
}
