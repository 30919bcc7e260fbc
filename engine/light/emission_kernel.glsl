// The emission solve, once: this text is compiled as GLSL in the vertex shader and as C++ (over GLM) in
// engine/light/emission_kernel.h. Whoever includes it provides the types real, vec2, vec3, vec4, mat4, the
// type LEGS by which legs are reached, KERNEL (what a function definition begins with), UNROLLED (what a
// loop begins with that is to be written out), the numbers MAX_PIECES and CATCH_UP_SPEED and, afterwards,
// the function legAt.
//
// Where: in the rest frame of a leg, its origin at the event at which the body's centre emitted the light
// that the eye receives. Times are lengths (c t, metres) and come first in a vec4: (c t, x, y, z).
//
// Two effects can be switched off (engine/light/switches.h), for whole views:
//   retarded false:   events are taken where a plane of simultaneity through the observation cuts the world
//                     lines, and so is the origin: the board's plane, or the head's. With m the row that takes
//                     an event of this frame to its time in the plane's, the event is where m·(c t, x) = 0;
//   contracted false: at each board time a vertex is at the centre's place + d: it turns with the centre;
//   both false:       the plane is the board's; then no frame is needed: the leg's is the board's, moved to the
//                     centre.

/// One leg of one body as one eye sees it; made in double, once a body, leg and eye. What bounds each number is
/// said behind it, for float: D, how far away the body is seen (as far as it can have gone from there, on a leg
/// that it has left); S, how long all its points take to join a leg (WorldLine::settled_s). None grows with the
/// age of the game.
struct LegView {
  vec3 eye;            // e: the eye's place (it is there at c t = l0); γ D
  real distance;       // l0 = |e|
  vec3 seenCentre;     // the centre's emission event from the eye, in the head frame: a straight light ray; γ_head D
  real boardTime;      // the same emission, c (t − t_o) in the board frame; D
  vec4 toSeenX;        // rows of M: the head-frame place of an event of this frame, from seenCentre; γ_head γ
  vec4 toSeenY;
  vec4 toSeenZ;
  vec4 toBoardTime;    // row that gives the board time of an event, from boardTime; γ
  vec4 signalInPrevious; // the event whose signal ends the previous leg, in the previous leg's frame; γ (D + c S)
  vec4 originInThis;   // the previous leg's origin, in this frame; γ (D + c S)
  mat4 fromPrevious;   // displacements of the previous leg's frame, in this one; γ of the two
  vec4 glide;          // under friction: direction of motion on the board, then deceleration/c² (1/m); 0: none
  vec4 glideTimes;     // u at the turn, u at the origin; board c t from the origin to the turn (of every leg but the
                       // first straight one), to rest. While it glides, u/a; the first leg of a body at rest is straight
  vec4 toMoment;       // m: row that gives the time of an event in the frame whose moment is shown, from the origin; γ_head γ
  vec4 spin;           // of a body that turns about its z: ω/c (1/m), cos and sin of its angle at the origin, the
                       // number of steps that find an emission; all 0 of a body that never turns
};

LegView legAt(LEGS legs, int i);

/// A straight piece of a vertex's world line, from `start` on.
struct Piece {
  vec4 start;
  vec3 velocity;
};

/// Where and when a vertex emitted the light that the eye receives.
struct VertexEmission {
  vec4 event;      // in the frame of `leg`
  int leg;         // in whose frame `event` is given
  bool catchingUp; // on its way from the previous leg to this one
};

/// δℓ = |e − d| − l0, the vertex's extra distance, without cancellation: q = |e − d|² − l0² = d·(d − 2e).
KERNEL real extraDistance(LegView leg, vec3 d) {
  real q = dot(d, d - real(2) * leg.eye);
  return q / (sqrt(max(leg.distance * leg.distance + q, real(0))) + leg.distance);
}

/// Is event a at or after the signal: c (t_a − t_n) ≥ |x_a − x_n| ?
KERNEL bool reachedBy(vec4 signal, vec4 a) {
  return a.x - signal.x >= length(vec3(a.y - signal.y, a.z - signal.z, a.w - signal.w));
}

KERNEL vec4 along(Piece piece, real s) { return piece.start + s * vec4(real(1), piece.velocity); }

/// Where a piece (continued both ways) crosses the future cone of the signal: s = |X + w s|, X its place from
/// the signal at the time of the signal. A sum of squares under the root: exact where the piece attends the signal.
KERNEL vec4 crossingOf(Piece piece, vec4 signal) {
  real T = piece.start.x - signal.x;
  vec3 w = piece.velocity;
  vec3 X = vec3(piece.start.y - signal.y, piece.start.z - signal.z, piece.start.w - signal.w) - T * w;
  real b = dot(w, X);
  real a = real(1) - dot(w, w);
  real root = sqrt(b * b + a * dot(X, X));
  real s = b < real(0) ? dot(X, X) / (root - b) : (b + root) / a;
  return along(piece, s - T);
}

/// Where a piece crosses the past cone of the eye: T − s = |X − w s|, the retarded root.
KERNEL vec4 emissionOn(Piece piece, LegView leg) {
  real T = leg.distance - piece.start.x;
  vec3 X = leg.eye - vec3(piece.start.y, piece.start.z, piece.start.w);
  vec3 w = piece.velocity;
  real b = T - dot(w, X);
  real a = real(1) - dot(w, w);
  real distance = length(X);
  real product = (T - distance) * (T + distance);
  real root = sqrt(max(b * b - a * product, real(0)));
  return along(piece, product / (b + root));
}

/// Where a piece crosses the plane of the moment that is shown: m·(start + s (1, w)) = 0. What is slower than
/// light crosses it once, upwards: m·(1, w) > 0.
KERNEL vec4 momentOn(Piece piece, LegView leg) {
  real now = dot(leg.toMoment, piece.start);
  return along(piece, -now / dot(leg.toMoment, vec4(real(1), piece.velocity)));
}

/// L(v)⁻¹ d = d + u (u·d)/(γ+1): what rests there has on the board the uncontracted offset d.
KERNEL vec3 stretched(LegView leg, vec3 d) {
  vec3 u = vec3(leg.toBoardTime.y, leg.toBoardTime.z, leg.toBoardTime.w);
  return d + u * (dot(u, d) / (leg.toBoardTime.x + real(1)));
}

/// The speed at which a vertex catches up with its outgoing leg, in the rest frame of that leg (at its turn).
KERNEL real catchUpSpeed() { return real(CATCH_UP_SPEED); }

// A body that spins turns its points about its z, in the leg's frame, by the centre's own time:
//   x(s) = Rot(ω s/c) d0,  d0 = Rot(its angle at the origin) d
// The angle at the origin was folded in double: what is left for a vertex is small.

/// cos a and sin a, |a| ≤ 1.2, within 1e-8.
KERNEL vec2 cosSinNear(real a) {
  real z = a * a;
  real c = real(1.0 / 720.0) - z * (real(1.0 / 40320.0) - z * real(1.0 / 3628800.0));
  real s = real(1.0 / 5040.0) - z * (real(1.0 / 362880.0) - z * real(1.0 / 39916800.0));
  c = real(1) - z * (real(0.5) - z * (real(1.0 / 24.0) - z * c));
  s = real(1) - z * (real(1.0 / 6.0) - z * (real(1.0 / 120.0) - z * s));
  return vec2(c, a * s);
}

/// cos a and sin a of any angle: of a quarter of what whole turns leave, doubled twice.
KERNEL vec2 cosSin(real a) {
  real turns = a * real(0.15915494309189535);
  vec2 q = cosSinNear((turns - floor(turns + real(0.5))) * real(1.5707963267948966));
  real sin2 = real(2) * q.x * q.y;
  real cos2 = real(1) - real(2) * q.y * q.y;
  return vec2(real(1) - real(2) * sin2 * sin2, real(2) * cos2 * sin2);
}

/// Rot(a) d, of (cos a, sin a).
KERNEL vec3 turnedBy(vec2 a, vec3 d) { return vec3(a.x * d.x - a.y * d.y, a.y * d.x + a.x * d.y, d.z); }

/// d0: where the vertex is when the leg's time is 0.
KERNEL vec3 spinStart(LegView leg, vec3 d) { return turnedBy(vec2(leg.spin.y, leg.spin.z), d); }

/// The velocity, over c, of what is at x: ω/c ẑ × x.
KERNEL vec3 spinVelocity(LegView leg, vec3 x) { return leg.spin.x * vec3(-x.y, x.x, real(0)); }

/// The vertex's event at the leg's time s.
KERNEL vec4 spinEvent(LegView leg, vec3 d, real s) {
  return vec4(s, turnedBy(cosSin(leg.spin.x * s), spinStart(leg, d)));
}

/// A direction that the body carries along (a normal), as it points at an event of this leg.
KERNEL vec3 carriedAlong(LegView leg, vec4 event, vec3 direction) {
  if (leg.spin.w == real(0)) return direction;
  return turnedBy(cosSin(leg.spin.x * event.x), spinStart(leg, direction));
}

/// Where the vertex crosses the past cone of the eye. From where and when the eye sees the point of the
/// axis that is as high, at the distance l and with the turned offset p of the vertex, e = (e_x, e_y)
/// across the axis:
///   g(s) = s + q/(D + l) = 0,  D = sqrt(l² + q) the distance of the vertex,
///   q = p² − 2 (A cos a − B sin a),  a = ω s/c,  A = e·p,  B = e_x p_y − e_y p_x
/// It rises: its slope 1 + ω/c (B cos a + A sin a)/D is 1 − n·w with n towards the eye. So there is one
/// root, and |s| ≤ |p|. Halley's steps; one that would leave what is known to be before and after the root
/// goes half of the way instead. What is known has to hold its ends, or a last step from there would be
/// thrown away.
KERNEL vec4 spinEmission(LegView leg, vec3 d, int steps) {
  vec3 height = vec3(real(0), real(0), d.z);
  real higher = extraDistance(leg, height);
  real l = leg.distance + higher;
  real omega = leg.spin.x;
  vec3 p = turnedBy(cosSin(-omega * higher), spinStart(leg, vec3(d.x, d.y, real(0))));
  real A = leg.eye.x * p.x + leg.eye.y * p.y;
  real B = leg.eye.x * p.y - leg.eye.y * p.x;
  real pp = dot(p, p);
  real after = sqrt(pp) * real(1.00001);
  real before = -after;
  real q = pp - real(2) * A;
  real s = -q / (sqrt(max(l * l + q, real(0))) + l);  // as if it did not spin
  vec2 t = cosSinNear(omega * s);
  UNROLLED
  for (int i = 0; i < steps; ++i) {
    real towards = A * t.x - B * t.y;
    q = pp - real(2) * towards;
    real D = max(sqrt(max(l * l + q, real(0))), real(1e-9));
    real g = s + q / (D + l);
    real w = omega * (B * t.x + A * t.y);
    real slope = real(1) + w / D;
    real bend = (omega * omega * towards - w * w / D) / D;
    before = g > real(0) ? before : s;
    after = g > real(0) ? s : after;
    real next = s - g * slope / (slope * slope - real(0.5) * g * bend);
    bool inside = (next >= before) && (next <= after);
    s = inside ? next : real(0.5) * (before + after);
    t = cosSinNear(omega * s);
  }
  return vec4(s - higher, turnedBy(t, p) + height);
}

/// The number of steps of the searches below: they are Newton's, and few vertices need them.
KERNEL int spinSearchSteps() { return 12; }

/// Where it crosses the plane of the moment that is shown: m·(s, x(s)) = 0, which rises: what is slower
/// than light crosses it once, within |d| of the centre.
KERNEL real spinMoment(LegView leg, vec3 d) {
  vec3 d0 = spinStart(leg, d);
  vec3 row = vec3(leg.toMoment.y, leg.toMoment.z, leg.toMoment.w);
  real after = length(d) * real(1.00001);
  real before = -after;
  real s = -dot(row, d0) / leg.toMoment.x;
  for (int i = 0; i < spinSearchSteps(); ++i) {
    vec3 x = turnedBy(cosSin(leg.spin.x * s), d0);
    real g = leg.toMoment.x * s + dot(row, x);
    before = g > real(0) ? before : s;
    after = g > real(0) ? s : after;
    real next = s - g / (leg.toMoment.x + dot(row, spinVelocity(leg, x)));
    bool inside = (next >= before) && (next <= after);
    s = inside ? next : real(0.5) * (before + after);
  }
  return s;
}

/// When the vertex is as far from an earlier event as what left there at `speed` has come: speed (s − t) =
/// |x(s) − x|. That rises where no point of the body is as fast.
KERNEL real spinReached(LegView leg, vec3 d, vec4 from, real speed) {
  vec3 d0 = spinStart(leg, d);
  vec3 source = vec3(from.y, from.z, from.w);
  real before = real(0);  // times are counted from the earlier event, which may lie far back
  real after = (length(d) + length(source)) / speed * real(1.00001);
  real s = length(turnedBy(cosSin(leg.spin.x * from.x), d0) - source) / speed;
  for (int i = 0; i < spinSearchSteps(); ++i) {
    vec3 x = turnedBy(cosSin(leg.spin.x * (from.x + s)), d0);
    vec3 way = x - source;
    real distance = length(way);
    real g = speed * s - distance;
    before = g > real(0) ? before : s;
    after = g > real(0) ? s : after;
    real next = s - g / (speed - dot(spinVelocity(leg, x), way) / max(distance, real(1e-9)));
    bool inside = (next >= before) && (next <= after);
    s = inside ? next : real(0.5) * (before + after);
  }
  return from.x + s;
}

/// The speed at which a vertex catches up with a leg on which it goes round: faster than it does, half way
/// between its own speed and light's if that is more than catchUpSpeed.
KERNEL real spinCatchUpSpeed(LegView leg, vec3 d) {
  return max(catchUpSpeed(), real(0.5) + real(0.5) * length(spinVelocity(leg, d)));
}

// A body under friction has a leg that is no straight line. The frame is then the momentary rest frame at the
// origin, and a vertex is found by its board time s from the origin (c = 1). On the board, along the motion,
//   u = u_o − a s   (before the turn u_turn, after the stop 0)     centre: ∫ u/γ ds     vertex: d∥/γ from it
// (uncontracted: d∥)
// with ∫ u/γ ds from r to o = (γ_o − γ_r)/a = (r − o)(u_o + u_r)/(γ_o + γ_r), which does not cancel.

KERNEL real gammaOf(real u) { return sqrt(real(1) + u * u); }

/// The board time nearest to s within the glide.
KERNEL real withinGlide(LegView leg, real s) { return min(max(s, leg.glideTimes.z), leg.glideTimes.w); }

/// u at board time s: from the origin on, where times are short, and 0 from the stop on.
KERNEL real glideU(LegView leg, real s) {
  if (s >= leg.glideTimes.w) return real(0);
  real since = withinGlide(leg, s) - withinGlide(leg, real(0));
  return max(leg.glideTimes.y - leg.glide.w * since, real(0));
}

/// The vertex's event at board time s.
KERNEL vec4 glideEvent(LegView leg, vec3 d, real s, bool contracted) {
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
KERNEL vec4 glideFlow(LegView leg, vec3 d, real s, bool contracted) {
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

/// Where the vertex crosses the past cone of the eye: l0 − t = |e − x|.
KERNEL real glideEmission(LegView leg, vec3 d, bool contracted) {
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

/// Where it crosses the plane of the moment that is shown: m·a(s) = 0. From where it would if it went straight.
KERNEL real glideMoment(LegView leg, vec3 d, bool contracted) {
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
KERNEL real glideCrossing(LegView leg, vec3 d, vec4 signal) {
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

/// Where one that set out at `start` at catchUpSpeed in the frame of the turn meets it. What is ahead of it there
/// grows with s, but hardly where friction has slowed the leg much: a step that would leave what is known to be
/// before and after the meeting goes half of the way instead.
KERNEL real glideJoining(LegView leg, vec3 d, vec4 start) {
  vec3 n = vec3(leg.glide.x, leg.glide.y, leg.glide.z);
  // u of the turn's rest frame in this one
  real u = leg.glideTimes.x * gammaOf(leg.glideTimes.y) - leg.glideTimes.y * gammaOf(leg.glideTimes.x);
  real gamma = gammaOf(u);
  real gap = length(d - vec3(start.y, start.z, start.w));
  real s = dot(leg.toBoardTime, vec4(start.x + gap / catchUpSpeed(), d));
  real before = dot(leg.toBoardTime, start);
  real after = before + real(1e6);  // no way is that long
  for (int i = 0; i < glideSteps() + 4; ++i) {
    vec4 way = glideEvent(leg, d, s, true) - start;
    vec4 flow = glideFlow(leg, d, s, true);
    vec3 x = vec3(way.y, way.z, way.w);
    vec3 f = vec3(flow.y, flow.z, flow.w);
    vec3 xTurn = x + n * ((gamma - real(1)) * dot(x, n) - u * way.x);
    vec3 fTurn = f + n * ((gamma - real(1)) * dot(f, n) - u * flow.x);
    real length_ = length(xTurn);
    real value = catchUpSpeed() * (gamma * way.x - u * dot(x, n)) - length_;
    real slope = catchUpSpeed() * (gamma * flow.x - u * dot(f, n)) - dot(fTurn, xTurn) / max(length_, real(1e-9));
    if (value < real(0)) before = s;
    else after = s;
    real nearer = s - value / slope;
    if (!(nearer > before)) nearer = real(0.5) * (before + s);
    if (!(nearer < after)) nearer = real(0.5) * (after + s);
    s = nearer;
  }
  return s;
}

/// The vertex's emission if it kept to this leg always.
KERNEL vec4 emissionOnLeg(LegView leg, vec3 d, bool retarded, bool contracted) {
  if (!retarded && !contracted) return vec4(real(0), carriedAlong(leg, vec4(real(0)), d));
  if (leg.glide.w > real(0)) {
    real s = retarded ? glideEmission(leg, d, contracted) : glideMoment(leg, d, contracted);
    return glideEvent(leg, d, s, contracted);
  }
  if (leg.spin.w > real(0)) {
    if (contracted && retarded) return spinEmission(leg, d, int(leg.spin.w));
    if (contracted) return spinEvent(leg, d, spinMoment(leg, d));
    d = spinStart(leg, d);  // uncontracted, all points have the angle that the centre shows
  }
  vec3 place = contracted ? d : stretched(leg, d);
  if (!retarded) return momentOn(Piece(vec4(real(0), place), vec3(real(0))), leg);
  return vec4(-extraDistance(leg, place), place);
}

/// Uncontracted, all points of a body turn with its centre: the emission on the latest leg that has begun by
/// then. World lines are continuous and slower than light, so this is the only one.
KERNEL VertexEmission uncontractedEmission(LEGS legs, int legCount, vec3 d, bool retarded) {
  VertexEmission emission;
  emission.event = emissionOnLeg(legAt(legs, 0), d, retarded, false);
  emission.leg = 0;
  emission.catchingUp = false;
  for (int i = 1; i < legCount; ++i) {
    LegView leg = legAt(legs, i);
    vec4 onLeg = emissionOnLeg(leg, d, retarded, false);
    if (dot(leg.toBoardTime, onLeg) >= leg.glideTimes.z) {
      emission.event = onLeg;
      emission.leg = i;
    }
  }
  return emission;
}

/// The emission event of the vertex at intrinsic offset d of a body that has these legs.
///
/// A vertex keeps to its leg until the signal that ends it, spreading at c, arrives (A), then catches up with
/// its place on the next leg, at catchUpSpeed there (B). A signal that arrives earlier than B cuts that short.
/// So every vertex has a continuous world line slower than light, and exactly one emission event.
KERNEL VertexEmission solveEmission(LEGS legs, int legCount, vec3 d, bool retarded, bool contracted) {
  if (!contracted) return uncontractedEmission(legs, legCount, d, retarded);
  LegView leg = legAt(legs, 0);
  VertexEmission emission;
  emission.event = emissionOnLeg(leg, d, retarded, true);
  emission.leg = 0;
  emission.catchingUp = false;
  if (legCount == 1) return emission;

  vec4 here = emission.event;  // the same event, in the frame of the leg at hand
  Piece pieces[MAX_PIECES];
  pieces[0].start = vec4(real(0), d);
  pieces[0].velocity = vec3(real(0));
  int count = 1;
  for (int i = 1; i < legCount; ++i) {
    LegView next = legAt(legs, i);
    bool reached = reachedBy(next.signalInPrevious, here);

    // A: the latest piece that the signal crosses after its start; the first piece has no start.
    vec4 a = crossingOf(pieces[count - 1], next.signalInPrevious);
    if (leg.glide.w > real(0)) {
      // What lies behind A is from now on its chord: only a signal that comes out of turn could tell.
      real s = glideCrossing(leg, d, next.signalInPrevious);
      vec4 flow = glideFlow(leg, d, s, true);
      a = glideEvent(leg, d, s, true);
      if (count > 1 && a.x > pieces[count - 1].start.x) flow = a - pieces[count - 1].start;
      if (count == 1) pieces[0].start = a;
      pieces[count - 1].velocity = vec3(flow.y, flow.z, flow.w) / flow.x;
    }
    if (leg.spin.w > real(0)) {  // likewise
      a = spinEvent(leg, d, spinReached(leg, d, next.signalInPrevious, real(1)));
      vec3 velocity = spinVelocity(leg, vec3(a.y, a.z, a.w));
      vec4 chord = a - pieces[count - 1].start;
      if (count > 1 && chord.x > real(0)) velocity = vec3(chord.y, chord.z, chord.w) / chord.x;
      if (count == 1) pieces[0].start = a;
      pieces[count - 1].velocity = velocity;
    }
    while (count > 1 && a.x < pieces[count - 1].start.x) {
      count = count - 1;
      a = crossingOf(pieces[count - 1], next.signalInPrevious);
    }

    // Everything into the frame of the next leg.
    for (int k = 0; k < count; ++k) {
      vec4 flow = next.fromPrevious * vec4(real(1), pieces[k].velocity);
      pieces[k].start = next.originInThis + next.fromPrevious * pieces[k].start;
      pieces[k].velocity = vec3(flow.y, flow.z, flow.w) / flow.x;
    }
    a = next.originInThis + next.fromPrevious * a;
    here = next.originInThis + next.fromPrevious * here;

    // From A straight to the vertex's place on the next leg: B.
    vec3 gap = d - vec3(a.y, a.z, a.w);
    real gapLength = length(gap);
    if (count > MAX_PIECES - 2) {  // forget the oldest pieces: no signal can reach back that far
      for (int k = 2; k < count; ++k) pieces[k - 2] = pieces[k];
      count = count - 2;
    }
    // Kept by name as well: Mesa 22 loses them when they are read back from the array.
    Piece way;
    way.start = a;
    way.velocity = gapLength > real(0) ? gap * (catchUpSpeed() / gapLength) : vec3(real(0));
    Piece rest;
    rest.start = vec4(a.x + gapLength / catchUpSpeed(), d);
    rest.velocity = vec3(real(0));
    if (next.glide.w > real(0)) {
      rest.start = glideEvent(next, d, glideJoining(next, d, a), true);
      vec4 step = rest.start - a;
      way.velocity = step.x > real(0) ? vec3(step.y, step.z, step.w) / step.x : vec3(real(0));
    }
    if (next.spin.w > real(0)) {
      rest.start = spinEvent(next, d, spinReached(next, d, a, spinCatchUpSpeed(next, d)));
      vec4 step = rest.start - a;
      way.velocity = step.x > real(0) ? vec3(step.y, step.z, step.w) / step.x : vec3(real(0));
    }
    pieces[count] = way;
    pieces[count + 1] = rest;
    count = count + 2;

    if (reached) {
      vec4 onLeg = emissionOnLeg(next, d, retarded, true);
      emission.catchingUp = onLeg.x < rest.start.x;
      emission.event = onLeg;
      if (emission.catchingUp) emission.event = retarded ? emissionOn(way, next) : momentOn(way, next);
      emission.leg = i;
      here = emission.event;
    }
    leg = next;
  }
  return emission;
}

/// The emission event seen from the eye, in the head frame: along it comes the straight ray that walls draw.
KERNEL vec3 seenFromEye(LegView leg, vec4 event) {
  return leg.seenCentre + vec3(dot(leg.toSeenX, event), dot(leg.toSeenY, event), dot(leg.toSeenZ, event));
}

/// Distance that the light travels in the leg's rest frame: the eye receives at c t = l0.
KERNEL real distanceInBody(LegView leg, vec4 event) { return leg.distance - event.x; }

/// c (t − t_o): how long ago the light left, in board time (negative).
KERNEL real boardTimeOf(LegView leg, vec4 event) { return leg.boardTime + dot(leg.toBoardTime, event); }

/// A place from the eye, taken for where light that arrives now comes from, (−|x|, x), in another frame.
KERNEL vec3 rayThrough(mat4 otherFromThis, vec3 x) {
  vec4 ray = otherFromThis * vec4(-length(x), x);
  return vec3(ray.y, ray.z, ray.w);
}
