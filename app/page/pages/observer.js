// Who looks: the visitor as recorded, or another observer of the same game. What nobody has recorded nobody sees: an
// observer's past is complete up to the last moment that was known, and there time stops for them.
const kFastest = 0.999, kRideHeight_m = 0.25, kStandHeight_m = 0.95;

class Watcher {
  constructor(content, engine, frames, known) {
    Object.assign(this, { about: content.about, engine, frames, known });
    this.axes = this.about.axes;
    this.walking = false;
    this.choose("recorded");
  }

  // Returns the transform boardFromRoom of a room that moves with this u, with its axes as at the visit's beginning.
  roomWith(u) {
    const start = this.frames.stored(0).boardFromRoom;
    const rest = product(inverse(boost(Array.from(start.slice(1, 4)))), start);
    return product(boost(u), rest);
  }

  choose(mode, of) {
    this.mode = mode;
    this.of = of;
    this.walking = false;
    this.held = "";
    if (mode === "stand" && !this.place_m) this.place_m = [0, -2, kStandHeight_m];
  }

  // What the present observer sees by, at this time of the visit; `dt_s` later than the last, with this push (room axes,
  // up to 1).
  view(display_s, dt_s, push) {
    const recorded = this.frames.between(display_s);
    this.held = "";
    if (this.mode === "recorded") {
      this.known.goTo(recorded.place);
      return recorded;
    }
    this.known.goToEnd();
    if (this.mode === "drive") return this.driven(recorded, dt_s, push);
    const t_s = Math.min(recorded.eyes.mono.event[0], this.about.known_s);
    if (this.mode === "ride") return this.riding(recorded, t_s);
    if (this.mode === "event") {
      this.held = this.of.held;
      return this.viewAt(recorded, this.of.event, this.roomWith(this.of.u));
    }
    return this.viewAt(recorded, [t_s, ...this.place_m], this.roomWith([0, 0, 0]));
  }

  viewAt(like, event, boardFromRoom) {
    if (event[0] > this.about.known_s) {
      event = [this.about.known_s, ...event.slice(1)];
      this.held = "held";
    }
    const eye = { event, inRoom: [0, 0, 0], seenFrom: [0, 0, 0] };
    return { ...like, eyes: { left: eye, right: eye, mono: eye }, headFromBoard: inverse(boardFromRoom), boardFromRoom, fade: 0 };
  }

  riding(recorded, t_s) {
    const motion = this.engine.ask("motionAt", [], this.of, t_s);
    const place = Array.from(motion.slice(1, 4)), u = Array.from(motion.slice(4, 7));
    const view = this.viewAt(recorded, [t_s, place[0], place[1], place[2] + kRideHeight_m], this.roomWith(u));
    return { ...view, own_s: motion[7] };
  }

  driven(recorded, dt_s, push) {
    const { engine } = this;
    if (!this.walking) {
      const eye = recorded.eyes.mono;
      engine.call("beginWalk", [...eye.event, ...this.roomWith([0, 0, 0]), 0, 0, 0], recorded.own_s);
      this.walking = true;
    }
    let seen = engine.ask("walkView", [0, 0, 0]);
    if (seen[16] < this.about.known_s) {
      if (dt_s > 0) engine.call("walk", [0, 0, 0, 0, 0, 0, ...push], dt_s);
      seen = engine.ask("walkView", [0, 0, 0]);
    } else {
      this.held = "held";
    }
    const view = this.viewAt(recorded, Array.from(seen.slice(16, 20)), seen.slice(28, 44));
    return { ...view, own_s: seen[44] };
  }

  // Another observer, by their event and velocity over c.
  set({ beta = [0, 0, 0], position_m, t_s }) {
    let b = beta.map(Number), speed = V.length(b), held = "";
    if (!(speed < kFastest)) {
      b = speed > 0 && Number.isFinite(speed) ? V.times(b, kFastest / speed) : [0, 0, 0];
      speed = V.length(b);
      held = "heldPast";
    }
    const u = V.times(b, 1 / Math.sqrt(1 - speed * speed));
    this.choose("event", { event: [Number(t_s), ...position_m.map(Number)], u, held });
    const view = this.view(this.frames.from_s, 0, [0, 0, 0]);
    return { held: this.held, event: Array.from(view.eyes.mono.event), headFromBoard: Array.from(view.headFromBoard) };
  }
}
