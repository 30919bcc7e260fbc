// Try it: the same physics goes on from the present moment, in the hands of whoever looks. A stroke starts at the eye and
// travels to its puck at the speed of light; what is seen of it comes back no faster.
const kMostU = 3, kPull_u_m = 2.5, kGrip_px = 44, kAhead_s = 1;

function setupNumbers(about, strokes) {
  const { game } = about, numbers = game.board ? [1, ...game.board] : [0, 0, 0];
  numbers.push(...game.rules.map(endless), game.pucks.length);
  for (const puck of game.pucks) {
    const name = new TextEncoder().encode(puck.name);
    numbers.push(...puck.numbers, puck.outline_m.length, ...puck.outline_m.flat(), name.length, ...name);
  }
  numbers.push(strokes.length, ...strokes.flat(), game.flashes.length, ...game.flashes.flat());
  return numbers;
}

function eventsOf(numbers) {
  const events = [];
  let at = 0;
  for (let left = numbers[at++]; left > 0; --left) {
    const event = { number: numbers[at], kind: numbers[at + 1], cushion: numbers[at + 2],
      at: Array.from(numbers.slice(at + 3, at + 7)), turns: [] };
    let turns = numbers[at + 7];
    for (at += 8; turns > 0; --turns, at += 8)
      event.turns.push({ puck: numbers[at], event: Array.from(numbers.slice(at + 1, at + 5)),
        beta: [numbers[at + 5], numbers[at + 6]], properTime_s: numbers[at + 7] });
    event.pucks = event.turns.map(turn => turn.puck + 1);
    events.push(event);
  }
  return events;
}

// The strokes of the scenario, and these; played from the beginning. A stroke has nine numbers: puck, time, whether the hand's
// place is given, that place, momentum, offset.
function playedAnew(about, engine, until_s, strokes) {
  engine.call("beginGame", setupNumbers(about, [...about.game.strokes.slice(0, about.game.strokesOfScenario), ...strokes]));
  engine.call("playTo", [], until_s);
  return eventsOf(engine.ask("gameEvents", []));
}

class OwnGame {
  constructor(shown, view) {
    this.about = shown.about;
    this.engine = shown.engine;
    this.shown = shown;
    const t_s = view.eyes.mono.event[0];
    shown.known.begin();
    this.engine.call("beginGame", setupNumbers(this.about, this.about.game.strokes.filter(stroke => stroke[1] <= t_s)));
    this.engine.call("beginWalk", [...view.eyes.mono.event, ...shown.watcher.roomWith([0, 0, 0]), 0, 0, 0], view.own_s);
    this.like = view;
    this.playTo(t_s);
  }

  playTo(t_s) {
    this.engine.call("playTo", [], t_s + kAhead_s);
    this.engine.ask("takeChanges", []);
  }

  // Lives on for so long, with this push, and returns what is seen then.
  view(dt_s, push) {
    if (dt_s > 0) this.engine.call("walk", [0, 0, 0, 0, 0, 0, ...push], dt_s);
    const seen = this.engine.ask("walkView", [0, 0, 0]), event = Array.from(seen.slice(16, 20));
    this.playTo(event[0]);
    const eye = { event, inRoom: [0, 0, 0], seenFrom: [0, 0, 0] };
    return { ...this.like, eyes: { left: eye, right: eye, mono: eye }, fade: 0, phase: 0, own_s: seen[44],
      headFromBoard: seen.slice(0, 16), boardFromRoom: seen.slice(28, 44) };
  }

  events() { return eventsOf(this.engine.ask("gameEvents", [])); }

  // Pulls a puck from its seen place to a place of the cloth, and lets go: the farther, the harder.
  strike(body, view, from_m, to_m) {
    const way = V.less(from_m, to_m).slice(0, 2), pulled_m = Math.hypot(...way);
    if (!(pulled_m > 0.01)) return false;
    const u = Math.min(kMostU, kPull_u_m * pulled_m), mass_kg = this.about.game.pucks[body - 1].numbers[2];
    const momentum = V.times(way, (u * mass_kg * this.about.lightSpeed_m_s) / pulled_m);
    const [t_s, ...place] = view.eyes.mono.event;
    this.engine.call("strikePuck", [body - 1, t_s, 1, ...place, ...momentum, 0]);
    this.engine.ask("takeChanges", []);
    return true;
  }
}

// The place of a body's centre as it is seen, in the head's frame; null where it is not.
function centreFromEye(engine, body, view) {
  const found = engine.ask("seenPoint", [0, 0, 0, ...view.eyes.mono.event, ...view.headFromBoard], body);
  return found.length ? { onBoard: Array.from(found.slice(1, 4)), fromEye: Array.from(found.slice(4, 7)) } : null;
}

// Where a ray of sight (head's frame) meets the plane at this height over the cloth; null if it does not.
function onCloth(view, ray, height_m) {
  const way = transformed(inverse(view.headFromBoard), [-V.length(ray), ...ray]).slice(1), eye = view.eyes.mono.event.slice(1);
  const share = (height_m - eye[2]) / way[2];
  return share > 0 && share < 1000 ? V.add(Array.from(eye), V.times(way, share)) : null;
}
