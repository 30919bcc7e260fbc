// What a person does with the page: time, observers, effects, events; by mouse, finger and keys.
const kUsualHalf = 0.7, kLeastHalf = 0.1, kMostHalf = 2.5, kLongestStep_s = 0.1, kSpeeds = [0.1, 0.25, 0.5, 1, 2];
const kSlowFrame_ms = 70, kQuickFrame_ms = 25, kLeastScale = 0.3, kStick_px = 90;
const kPushKeys = { w: [0, 1], s: [0, -1], a: [-1, 0], d: [1, 0], arrowup: [0, 1], arrowdown: [0, -1], arrowleft: [-1, 0], arrowright: [1, 0] };

function make(kind, words, name) {
  const made = document.createElement(kind);
  if (words) made.textContent = words;
  if (name) made.className = name;
  return made;
}

class Controls {
  constructor(shown) {
    Object.assign(this, { shown, now_s: shown.frames.from_s, plays: false, speed: 1, running: false, stale: true });
    this.look = { turn: 0, raise: 0, half: kUsualHalf };
    this.effects = null; // as recorded
    this.ghosts = null;
    this.wall = null;
    this.scale = 1;
    this.pushed = new Set();
    this.stick = [0, 0];
    this.pointers = new Map();
    this.build();
    this.listen();
  }

  get about() { return this.shown.about; }
  get watcher() { return this.shown.watcher; }

  stop() { this.running = false; this.plays = false; }

  begin() {
    if (!this.hasLooked) this.lookAtTable();
    this.showPlaying(true);
    if (this.running) return;
    this.running = true;
    this.last_ms = performance.now();
    requestAnimationFrame(guarded(ms => this.frame(ms)));
  }

  seek(display_s) {
    const { frames } = this.shown;
    if (this.game) this.leaveGame();
    this.now_s = Math.min(frames.until_s, Math.max(frames.from_s, display_s));
    if (this.watcher.mode === "drive") this.watcher.walking = false;
    this.stale = true;
  }

  // Turns towards the middle of the table, as it is seen.
  lookAtTable() {
    const view = this.watcher.view(this.now_s, 0, [0, 0, 0]), { axes } = this.about;
    const found = this.shown.engine.ask("seenPoint", [0, 0, 0, ...view.eyes.mono.event, ...view.headFromBoard], 0);
    this.hasLooked = true;
    if (!found.length) return;
    const at = Array.from(found.slice(4, 7)), ahead = V.dot(at, axes.forward), aside = V.dot(at, axes.right);
    this.look.turn = Math.atan2(aside, ahead);
    this.look.raise = Math.atan2(V.dot(at, axes.up), Math.hypot(ahead, aside));
    this.stale = true;
  }

  build() {
    const all = part("controls"), { about } = this;
    this.says = make("p", "", "says");
    this.says.setAttribute("aria-live", "polite");
    this.facts = make("p", "", "facts");
    const head = make("div", "", "head");
    head.append(make("strong", about.title), this.facts, this.says);
    this.bar = make("div", "", "bar");
    this.playButton = this.button(texts.play, texts.play, () => this.showPlaying(!this.plays));
    this.button("‹", texts.before, () => this.stepFrames(-1));
    this.button("›", texts.after, () => this.stepFrames(1));
    this.slider = make("input");
    Object.assign(this.slider, { type: "range", min: this.shown.frames.from_s, max: this.shown.frames.until_s, step: "any", value: this.now_s });
    this.slider.setAttribute("aria-label", texts.time);
    this.slider.addEventListener("input", () => { this.showPlaying(false); this.seek(Number(this.slider.value)); });
    this.clock = make("output", "");
    this.bar.append(this.slider, this.clock);
    this.pace = this.choice(texts.speed, kSpeeds.map(speed => [speed + " ×", speed]), speed => { this.speed = speed; });
    this.pace.select.value = String(kSpeeds.indexOf(1));
    this.bar.append(this.pace);
    if (this.shown.live) this.bar.replaceChildren(this.clock); // its time is that of the room
    else this.tryButton = this.button(texts.tryIt, texts.tryIt, () => (this.game ? this.leaveGame() : this.beginGame()), "key");
    this.menuButton = this.button("☰ " + texts.menu, texts.open, () => this.showMenu(this.menu.hidden));
    this.menu = make("section", "", "menu");
    this.menu.setAttribute("aria-label", texts.menu);
    this.buildMenu();
    this.showMenu(window.innerWidth > 900);
    this.aim = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    this.aim.setAttribute("class", "aim");
    this.aimLine = document.createElementNS("http://www.w3.org/2000/svg", "line");
    this.aim.append(this.aimLine);
    all.append(head, this.aim, this.menu, this.bar);
  }

  button(sign, words, work, name) {
    const made = make("button", sign, name);
    made.title = words;
    made.setAttribute("aria-label", words);
    made.addEventListener("click", guarded(work));
    this.bar.append(made);
    return made;
  }

  choice(words, options, work) {
    const label = make("label", words + " ", "choice"), select = make("select");
    options.forEach(([name], i) => { const option = make("option", name); option.value = i; select.append(option); });
    select.addEventListener("change", guarded(() => { work(options[Number(select.value)][1]); this.stale = true; }));
    label.append(select);
    label.select = select;
    return label;
  }

  check(words, isOn, work) {
    const label = make("label", "", "check"), box = make("input");
    Object.assign(box, { type: "checkbox", checked: isOn });
    box.addEventListener("change", guarded(() => { work(box.checked); this.stale = true; }));
    label.append(box, make("span", words));
    this.menu.append(label);
    return box;
  }

  buildMenu() {
    const { about } = this, first = this.shown.frames.stored(0), names = about.bodies.slice(1, 1 + about.pucks).map(body => body.name);
    const observers = [[texts.recorded, ["recorded"]], [texts.stand, ["stand"]],
      ...names.map((name, i) => [fill(texts.ride, name), ["ride", i + 1]]), [texts.drive, ["drive"]]];
    this.observers = this.choice(texts.observer, observers, ([mode, of]) => this.chooseObserver(mode, of));
    this.menu.append(this.observers);
    const walls = [[texts.free, null], ...about.walls.map(wall => [fill(texts.wall, wall.name), wall])];
    if (about.walls.length) this.menu.append(this.choice(texts.look, walls, wall => { this.wall = wall; }));
    this.menu.append(make("h2", texts.effects));
    ["retardation", "contraction", "aberration"].forEach((name, i) =>
      this.check(texts[name], (first.effects >> i) & 1, isOn => {
        const bits = this.effects === null ? this.view.effects : this.effects;
        this.effects = isOn ? bits | (1 << i) : bits & ~(1 << i);
      }));
    this.menu.append(make("h2", texts.ghosts));
    ["boardNow", "myNow"].forEach((name, i) =>
      this.check(texts[name], (first.views >> i) & 1, isOn => {
        const bits = this.ghosts === null ? this.view.views & 3 : this.ghosts;
        this.ghosts = isOn ? bits | (1 << i) : bits & ~(1 << i);
      }));
    this.menu.append(make("h2", texts.events));
    this.list = make("ol", "", "events");
    this.menu.append(make("p", texts.order, "facts"), this.list);
  }

  showMenu(isShown) {
    this.menu.hidden = !isShown;
    this.menuButton.setAttribute("aria-expanded", String(isShown));
  }

  showPlaying(plays) {
    if (plays && !this.game && !this.shown.live && this.now_s >= this.shown.frames.until_s) this.seek(this.shown.frames.from_s);
    this.plays = plays;
    this.playButton.textContent = this.playButton.title = plays ? texts.pause : texts.play;
    this.playButton.setAttribute("aria-label", this.playButton.title);
    this.stale = true;
  }

  stepFrames(by) {
    const { frames } = this.shown, place = Math.min(frames.count - 1, Math.max(0, frames.at(this.now_s) + by));
    this.showPlaying(false);
    this.seek(frames.rows[place][1]);
  }

  chooseObserver(mode, of) {
    if (this.game) this.leaveGame();
    this.watcher.choose(mode, of);
    this.lookAtTable();
    if (mode === "ride") this.look.raise = -0.1;
  }

  watchAs(wanted) {
    this.stale = true;
    return this.watcher.set(wanted);
  }

  beginGame() {
    this.game = new OwnGame(this.shown, this.view);
    this.sayTry(texts.back);
    this.showPlaying(true);
  }

  sayTry(words) {
    this.tryButton.textContent = this.tryButton.title = words;
    this.tryButton.setAttribute("aria-label", words);
  }

  leaveGame() {
    this.game = null;
    this.sayTry(texts.tryIt);
    this.watcher.walking = false;
    this.shown.known.begin();
    this.stale = true;
  }

  frame(ms) {
    if (!this.running) return;
    requestAnimationFrame(guarded(next => this.frame(next)));
    const passed_ms = ms - this.last_ms, dt_s = Math.min(kLongestStep_s, passed_ms / 1000) * this.speed;
    this.last_ms = ms;
    if (this.picture.gl.isContextLost()) return;
    if (this.plays) this.goOn(dt_s);
    if (!this.plays && !this.stale) return;
    this.adapt(passed_ms);
    this.view = this.game ? this.game.view(this.plays ? dt_s : 0, this.push()) : this.watcher.view(this.now_s, this.plays ? dt_s : 0, this.push());
    this.stale = !this.draw();
    this.tell(ms);
  }

  get picture() { return this.shown.picture; }

  goOn(dt_s) {
    if (this.game) return;
    if (this.shown.live) {
      this.now_s = this.shown.live.now_s();
      return;
    }
    const { until_s } = this.shown.frames;
    this.now_s = Math.min(until_s, this.now_s + dt_s);
    this.slider.value = this.now_s;
    if (this.now_s >= until_s && this.watcher.mode !== "drive") this.showPlaying(false);
  }

  push() {
    const keys = [...this.pushed].map(key => kPushKeys[key]);
    const right = this.stick[0] + keys.reduce((sum, key) => sum + key[0], 0), ahead = this.stick[1] + keys.reduce((sum, key) => sum + key[1], 0);
    if (!right && !ahead) return [0, 0, 0];
    const { axes } = this.about, { turn } = this.look;
    const forward = V.add(V.times(axes.forward, Math.cos(turn)), V.times(axes.right, Math.sin(turn)));
    return V.add(V.times(forward, ahead), V.times(V.cross(forward, axes.up), right));
  }

  // Draws fewer pixels where they take long, and more again where they do not.
  adapt(passed_ms) {
    this.slow = passed_ms > kSlowFrame_ms && passed_ms < 2000 ? (this.slow || 0) + 1 : 0;
    this.quick = passed_ms < kQuickFrame_ms ? (this.quick || 0) + 1 : 0;
    const by = this.slow >= 4 ? 0.75 : this.quick >= 200 ? 1 / 0.75 : 1;
    if (by === 1) return;
    this.scale = Math.min(1, Math.max(kLeastScale, by * this.scale));
    this.slow = this.quick = 0;
  }

  // A picture that rests may take its time.
  get sharpness() { return this.plays || this.pointers.size > 0 ? this.scale : 1; }

  // Returns whether the picture is as it should be; while shaders are compiled it is the one before.
  draw() {
    const { canvas } = this.picture, ratio = Math.min(2, window.devicePixelRatio || 1) * this.sharpness;
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const { view, picture } = this, eye = view.eyes.mono;
    const effects = this.effects === null ? view.effects : (view.effects & 24) | this.effects;
    const ghosts = this.ghosts === null ? view.views : this.ghosts;
    picture.look(eye, view.headFromBoard, effects, ghostsOf(view, eye, ghosts, effects));
    let plan = picture.plan(!this.hasDrawn);
    const isWhole = plan !== null;
    if (!isWhole) {
      picture.look(eye, view.headFromBoard, this.drawnEffects, []);
      plan = picture.plan(true);
    } else {
      this.drawnEffects = effects;
    }
    this.hasDrawn = true;
    const wall = this.watcher.mode === "recorded" && !this.game ? this.wall : null;
    this.clip = (wall && clipOfWall(wall, eye)) || clipOfLook(this.about.axes, { ...this.look, half: this.half }, width / height);
    picture.draw(this.clip, wall ? this.portOf(wall, width, height) : [0, 0, width, height], plan);
    return isWhole;
  }

  portOf(wall, width, height) {
    const aspect = V.length(V.less(wall.lowerRight_m, wall.lowerLeft_m)) / V.length(V.less(wall.upperLeft_m, wall.lowerLeft_m));
    const wide = Math.min(width, Math.round(height * aspect)), high = Math.min(height, Math.round(width / aspect));
    return [(width - wide) >> 1, (height - high) >> 1, wide, high];
  }

  // Returns a number with the sign that the page's language has before decimals.
  written(number, decimals) {
    return (decimals === undefined ? String(number) : number.toFixed(decimals)).replace(".", this.about.point);
  }

  // Says what is to be said, some times a second.
  tell(ms) {
    if (ms - (this.told_ms || -1000) < 150 && this.plays) return;
    this.told_ms = ms;
    const { view, about } = this, u = Array.from(inverse(view.headFromBoard).slice(1, 4)), speed = V.length(u) / Math.hypot(1, V.length(u));
    this.facts.textContent = fill(texts.light, this.written(about.lightSpeed_m_s)) + " · " +
      fill(texts.clock, this.written(view.own_s, 1), this.written(view.eyes.mono.event[0], 1), this.written(speed, 2));
    this.says.textContent = this.words();
    this.clock.textContent = this.written(this.game ? view.own_s : this.now_s - this.shown.frames.from_s, 1) + " s";
    this.tellEvents(u);
  }

  words() {
    const { view, about, watcher } = this, { live } = this.shown;
    if (live && !live.isThere) return texts.away;
    if (live && watcher.held === "held") return texts.liveHeld;
    if (watcher.held && !this.game) return texts[watcher.held];
    if (this.game) return texts.tryHow;
    if (watcher.mode === "drive") return texts.driveHow;
    if (watcher.mode === "stand") return texts.standHow;
    if (about.lesson && view.phase) {
      const { title, question, todo, notice, number } = about.lesson;
      return title + ": " + [null, question, todo + " " + notice, number][view.phase];
    }
    const caption = about.captions.find(one => view.own_s >= one.from_s && view.own_s < one.from_s + one.for_s);
    return caption ? fill(texts.told, caption.text) : live ? texts.lookHow : texts.lookHow + " " + texts.playOn;
  }

  // The events so far, each with its place in the order of the present observer: by their own frame's time.
  tellEvents(u) {
    const { view, about } = this, events = this.game ? this.game.events() : about.events, now = view.eyes.mono.event;
    const past = events.filter(event => about.lightSpeed_m_s * (now[0] - event.at[0]) >= V.length(V.less(event.at.slice(1), now.slice(1))));
    const own = past.map(event => transformed(inverse(boost(u)), [about.lightSpeed_m_s * event.at[0], ...event.at.slice(1)])[0]);
    const order = own.map(time => 1 + own.filter(other => other < time).length);
    const lines = past.map((event, i) => fill(texts.event, this.nameOf(event), this.written(event.at[0], 3), order[i]));
    const text = lines.join("\n");
    if (text === this.toldEvents) return;
    this.toldEvents = text;
    this.list.replaceChildren(...lines.slice(-40).reverse().map(line => make("li", line)));
  }

  nameOf(event) {
    const names = event.pucks.map(body => this.about.bodies[body].name);
    const words = [texts.puckPuck, texts.puckCushion, texts.stroke, texts.flash, texts.jam][event.kind] || "";
    return fill(words, ...names);
  }

  listen() {
    const { canvas } = this.picture;
    canvas.addEventListener("pointerdown", guarded(event => this.press(event)));
    canvas.addEventListener("pointermove", guarded(event => this.drag(event)));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, guarded(event => this.release(event)));
    canvas.addEventListener("wheel", event => { event.preventDefault(); this.zoom(Math.exp(0.001 * event.deltaY)); }, { passive: false });
    canvas.addEventListener("webglcontextlost", event => { event.preventDefault(); this.says.textContent = texts.lost; });
    canvas.addEventListener("webglcontextrestored", guarded(() => { this.picture.begin(); this.hasDrawn = false; this.stale = true; }));
    window.addEventListener("resize", () => { this.stale = true; });
    window.addEventListener("blur", () => this.pushed.clear());
    window.addEventListener("keydown", guarded(event => this.key(event)));
    window.addEventListener("keyup", event => this.pushed.delete(event.key.toLowerCase()));
  }

  key(event) {
    if (event.target.closest("button, input, select") || event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.toLowerCase();
    const moves = this.game || this.watcher.mode === "drive" || this.watcher.mode === "stand";
    if (key === " ") this.showPlaying(!this.plays);
    else if (key in kPushKeys && moves) this.pushByKey(key);
    else if (key === "arrowleft") this.stepFrames(-1);
    else if (key === "arrowright") this.stepFrames(1);
    else if (key === "h") this.showMenu(this.menu.hidden);
    else return;
    event.preventDefault();
  }

  pushByKey(key) {
    if (this.watcher.mode !== "stand" || this.game) return this.pushed.add(key);
    this.pushed.add(key);
    const way = this.push(), view = transformed(this.watcher.roomWith([0, 0, 0]), [0, ...way]).slice(1);
    this.pushed.delete(key);
    this.watcher.place_m = V.add(this.watcher.place_m, V.times(view, 0.1));
    this.stale = true;
    return undefined;
  }

  zoom(by) {
    this.look.half = Math.min(kMostHalf, Math.max(kLeastHalf, this.look.half * by));
    this.stale = true;
  }

  // The half of the picture's height, as a tangent; that of its shorter side is what is looked by.
  get half() {
    const { clientWidth, clientHeight } = this.picture.canvas;
    return this.look.half * Math.max(1, clientHeight / Math.max(1, clientWidth));
  }

  // The ray of sight through a point of the window, in the head's frame.
  ray(event) {
    const { canvas } = this.picture, { look, about } = this, aspect = canvas.clientWidth / canvas.clientHeight;
    const x = ((2 * event.clientX) / canvas.clientWidth - 1) * this.half * aspect, y = (1 - (2 * event.clientY) / canvas.clientHeight) * this.half;
    const { right, up, forward } = about.axes;
    const level = V.add(V.times(forward, Math.cos(look.turn)), V.times(right, Math.sin(look.turn)));
    const ahead = V.add(V.times(level, Math.cos(look.raise)), V.times(up, Math.sin(look.raise))), side = V.unit(V.cross(level, up));
    return V.add(ahead, V.add(V.times(side, x), V.times(V.cross(side, ahead), y)));
  }

  // Where a place from the eye is in the window.
  pixelOf(fromEye) {
    const at = transformed(this.clip, [...fromEye, 1]), { canvas } = this.picture;
    return at[3] > 0 ? [(0.5 + (0.5 * at[0]) / at[3]) * canvas.clientWidth, (0.5 - (0.5 * at[1]) / at[3]) * canvas.clientHeight] : null;
  }

  press(event) {
    const { canvas } = this.picture;
    canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, event);
    this.held = this.game ? this.puckAt(event) : null;
    const isDriving = this.game || this.watcher.mode === "drive";
    this.steers = !this.held && isDriving && event.clientX < 2 * kStick_px && event.clientY > canvas.clientHeight - 4 * kStick_px ? event : null;
  }

  // A body's centre, and where it is seen in the window; null where it is not, and before the first picture.
  where(body) {
    if (!this.clip) return null;
    const centre = centreFromEye(this.shown.engine, body, this.view), at = centre && this.pixelOf(centre.fromEye);
    return at ? { body, at, ...centre } : null;
  }

  // The puck that is nearest to the pointer, within a finger's reach.
  puckAt(event) {
    const away = ({ at }) => Math.hypot(at[0] - event.clientX, at[1] - event.clientY);
    const pucks = Array.from({ length: this.about.pucks }, (_, i) => this.where(1 + i)).filter(Boolean);
    pucks.sort((a, b) => away(a) - away(b));
    return pucks.length && away(pucks[0]) < kGrip_px ? pucks[0] : null;
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    if (this.held) this.showAim(event);
    else if (this.steers) this.stick = [(event.clientX - this.steers.clientX) / kStick_px, (this.steers.clientY - event.clientY) / kStick_px];
    else if (this.pointers.size === 2) this.pinch(event, before);
    else this.turn(event, before);
    this.pointers.set(event.pointerId, event);
  }

  turn(event, before) {
    const perPixel = (2 * this.half) / this.picture.canvas.clientHeight;
    this.look.turn -= (event.clientX - before.clientX) * perPixel;
    this.look.raise = Math.min(1.5, Math.max(-1.5, this.look.raise + (event.clientY - before.clientY) * perPixel));
    this.stale = true;
  }

  pinch(event, before) {
    const other = [...this.pointers.values()].find(one => one.pointerId !== event.pointerId);
    const apart = at => Math.max(10, Math.hypot(at.clientX - other.clientX, at.clientY - other.clientY));
    this.zoom(apart(before) / apart(event));
  }

  showAim(event) {
    const [x, y] = this.held.at;
    for (const [name, value] of Object.entries({ x1: x, y1: y, x2: event.clientX, y2: event.clientY })) this.aimLine.setAttribute(name, value);
    this.aim.classList.add("shown");
  }

  release(event) {
    this.pointers.delete(event.pointerId);
    this.aim.classList.remove("shown");
    if (this.held && this.game && event.type === "pointerup") {
      const to = onCloth(this.view, this.ray(event), this.held.onBoard[2]);
      if (to) this.game.strike(this.held.body, this.view, this.held.onBoard, to);
    }
    this.held = this.steers = null;
    this.stick = [0, 0];
    this.stale = true;
  }
}
