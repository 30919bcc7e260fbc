// A body under friction has a leg that is no straight line. The frame is then the momentary rest frame at the
// origin, and a vertex is found by its board time s from the origin (c = 1). On the board, along the motion,
//   u = u_o − a s   (before the turn u_turn, after the stop 0)     centre: ∫ u/γ ds     vertex: d∥/γ from it
// (uncontracted: d∥)
// with ∫ u/γ ds from r to o = (γ_o − γ_r)/a = (r − o)(u_o + u_r)/(γ_o + γ_r), which does not cancel.
// Theory: app/doc/physics.md, Friction.

KERNEL real gammaOf(real u) { return sqrt(real(1) + u * u); }

/// The board time nearest to s within the glide.
KERNEL real withinGlide(LEG leg, real s) { return min(max(s, leg.glideTimes.z), leg.glideTimes.w); }

/// u at board time s: from the origin on, where times are short, and 0 from the stop on.
KERNEL real glideU(LEG leg, real s) {
  if (s >= leg.glideTimes.w) return real(0);
  real since = withinGlide(leg, s) - withinGlide(leg, real(0));
  return max(leg.glideTimes.y - leg.glide.w * since, real(0));
}

/// The vertex's event at board time s.
KERNEL vec4 glideEvent(LEG leg, vec3 d, real s, bool contracted) {
  vec3 n = vec3(leg.glide.x, leg.glide.y, leg.glide.z);
  real uO = leg.glideTimes.y;
  real gammaO = gammaOf(uO);
  real r = withinGlide(leg, s);
  real o = withinGlide(leg, real(0));
  real u = glideU(leg, s);
  real gamma = gammaOf(u);
  real along_d = dot(d, n);
  real place = (r - o) * (uO + u) / (gammaO + gamma) + (s - r) * u / gamma + o * uO / gammaO +
               along_d / (contracted ? gamma : real(1));
  return vec4(gammaO * s - uO * place, d + n * (gammaO * place - uO * s - along_d));
}

/// How the event moves with s.
KERNEL vec4 glideFlow(LEG leg, vec3 d, real s, bool contracted) {
  vec3 n = vec3(leg.glide.x, leg.glide.y, leg.glide.z);
  real uO = leg.glideTimes.y;
  real u = glideU(leg, s);
  real gamma = gammaOf(u);
  bool gliding = contracted && s > leg.glideTimes.z && s < leg.glideTimes.w;
  real v = u / gamma * (real(1) + (gliding ? leg.glide.w * dot(d, n) / (gamma * gamma) : real(0)));
  return vec4(gammaOf(uO) - uO * v, n * (gammaOf(uO) * v - uO));
}

/// Newton's steps to a root: the functions are nearly straight (R a < 1/2), so few are needed.
KERNEL int glideSteps() { return 8; }

/// A bound of s that is none: no way is that long.
KERNEL real noBound() { return real(1e6); }

/// Where the vertex crosses the past cone of the eye: l0 − t = |e − x|.
KERNEL real glideEmission(LEG leg, vec3 d, bool contracted) {
  real s = dot(leg.toBoardTime, vec4(-extraDistance(leg, d), d));
  for (int i = 0; i < glideSteps(); ++i) {
    vec4 a = glideEvent(leg, d, s, contracted);
    vec4 flow = glideFlow(leg, d, s, contracted);
    vec3 toEye = leg.eye - vec3(a.y, a.z, a.w);
    real distance = max(length(toEye), real(1e-6));
    s = s + (leg.distance - a.x - distance) / (flow.x - dot(vec3(flow.y, flow.z, flow.w), toEye) / distance);
  }
  return s;
}

/// Where it crosses the plane of the moment that is shown: m·a(s) = 0. From where it would if it went
/// straight.
KERNEL real glideMoment(LEG leg, vec3 d, bool contracted) {
  Piece straight;
  straight.start = vec4(real(0), d);
  straight.velocity = vec3(real(0));
  real s = dot(leg.toBoardTime, momentOn(straight, leg));
  for (int i = 0; i < glideSteps(); ++i) {
    s = s - dot(leg.toMoment, glideEvent(leg, d, s, contracted)) / dot(leg.toMoment, glideFlow(leg, d, s, contracted));
  }
  return s;
}

/// Where it crosses the future cone of the signal: t − t_n = |x − x_n|.
KERNEL real glideCrossing(LEG leg, vec3 d, vec4 signal) {
  real s = dot(leg.toBoardTime, vec4(signal.x + length(d - vec3(signal.y, signal.z, signal.w)), d));
  for (int i = 0; i < glideSteps(); ++i) {
    vec4 a = glideEvent(leg, d, s, true);
    vec4 flow = glideFlow(leg, d, s, true);
    vec3 fromSignal = vec3(a.y - signal.y, a.z - signal.z, a.w - signal.w);
    real distance = max(length(fromSignal), real(1e-6));
    s = s - (a.x - signal.x - distance) / (flow.x - dot(vec3(flow.y, flow.z, flow.w), fromSignal) / distance);
  }
  return s;
}

/// A search for a root between two bounds that ends by itself.
struct RootSearch {
  real at, before, after;
  real step;  // the latest
  bool ended;
};

/// The most steps; hardly any search takes ten.
KERNEL int boundedSteps() { return 40; }

/// Takes the value and the slope where the search is. Goes on by Newton's step if that stays between the
/// bounds and is at most half of the one before, else to their middle; while none is known after it, as far
/// again as it has come. It ends where it has been.
KERNEL void advance(INOUT(RootSearch) root, real value, real slope) {
  if (value > real(0)) root.after = root.at;
  else root.before = root.at;
  real step = -value / slope;
  real next = root.at + step;
  bool nears = max(step, -step) <= real(0.5) * root.step;
  if (!(next >= root.before && next <= root.after && nears)) {
    bool bounded = root.after < noBound();
    next = bounded ? real(0.5) * (root.before + root.after) : root.at + max(root.at - root.before, real(1));
    step = bounded ? root.after - root.before : noBound();
  }
  root.step = max(step, -step);
  root.ended = next == root.before || next == root.after;
  root.at = next;
}

/// The speed at which a vertex catches up with a leg on which its place is this fast at most, in the rest
/// frame of the turn.
KERNEL real fasterThan(real speed) { return max(catchUpSpeed(), real(0.5) + real(0.5) * speed); }

/// The speed that friction gives the leg in the rest frame of its turn, in the end.
KERNEL real glideFallsBack(LEG leg) { return leg.glideTimes.x / gammaOf(leg.glideTimes.x); }

/// Where one that set out at `start` to catch up meets it. Its lead in the frame of the turn grows with s.
KERNEL real glideJoining(LEG leg, vec3 d, vec4 start) {
  vec3 n = vec3(leg.glide.x, leg.glide.y, leg.glide.z);
  // u of the turn's rest frame in this one
  real u = leg.glideTimes.x * gammaOf(leg.glideTimes.y) - leg.glideTimes.y * gammaOf(leg.glideTimes.x);
  real gamma = gammaOf(u);
  real gap = length(d - vec3(start.y, start.z, start.w));
  real speed = fasterThan(glideFallsBack(leg));
  RootSearch root;
  root.at = dot(leg.toBoardTime, vec4(start.x + gap / speed, d));
  root.before = dot(leg.toBoardTime, start);
  root.after = noBound();
  root.step = noBound();
  root.ended = false;
  for (int i = 0; i < boundedSteps() && !root.ended; ++i) {
    vec4 way = glideEvent(leg, d, root.at, true) - start;
    vec4 flow = glideFlow(leg, d, root.at, true);
    vec3 x = vec3(way.y, way.z, way.w);
    vec3 f = vec3(flow.y, flow.z, flow.w);
    vec3 xTurn = x + n * ((gamma - real(1)) * dot(x, n) - u * way.x);
    vec3 fTurn = f + n * ((gamma - real(1)) * dot(f, n) - u * flow.x);
    real length_ = length(xTurn);
    real value = speed * (gamma * way.x - u * dot(x, n)) - length_;
    real slope = speed * (gamma * flow.x - u * dot(f, n)) - dot(fTurn, xTurn) / max(length_, real(1e-9));
    advance(root, value, slope);
  }
  return root.at;
}
