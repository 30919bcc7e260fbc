// A vertex of a body that spins, on any leg: straight or gliding, its spin uniform or slowed by the cloth. It
// is found by the centre's time σ, own time on a straight leg, board time on a glide, both from the origin:
//   straight   its event is (σ, d'),  d' = Rot(angle at σ) d0
//   glide      d' as the centre's own clock says at σ; simultaneous with the centre in the centre's momentary
//   rest
//              frame, it is at board time s = σ + u(σ) (d'·n) where glideEvent has it
// On a straight leg that a glide's formulas describe both are the same.

/// asinh x; of small x without loss.
KERNEL real rapidityOf(real x) {
  real a = max(x, -x);
  real z = a * a;
  if (a < real(0.1)) return x * (real(1) - z * (real(1.0 / 6.0) - z * (real(3.0 / 40.0) - z * real(15.0 / 336.0))));
  real value = log(a + sqrt(real(1) + z));
  return x < real(0) ? -value : value;
}

/// The centre's own time from the origin to board time s: (η_o − η)/a while it glides, the difference of the
/// rapidities as one arcsine.
KERNEL real glideOwnTime(LEG leg, real s) {
  real r = withinGlide(leg, s);
  real o = withinGlide(leg, real(0));
  real uO = leg.glideTimes.y;
  real u = glideU(leg, s);
  real gammaO = gammaOf(uO);
  real gamma = gammaOf(u);
  real lost = leg.glide.w * (r - o) * (uO + u) / max(uO * gamma + u * gammaO, real(1e-30));
  return rapidityOf(lost) / leg.glide.w + (s - r) / gamma + o / gammaO;
}

KERNEL real turningOwnTime(LEG leg, real sigma) {
  return leg.glide.w > real(0) ? glideOwnTime(leg, sigma) : sigma;
}

KERNEL vec4 turningEvent(LEG leg, vec3 d, real sigma) {
  vec3 x = spinPlace(leg, d, turningOwnTime(leg, sigma));
  if (!(leg.glide.w > real(0))) return vec4(sigma, x);
  real along_x = dot(x, vec3(leg.glide.x, leg.glide.y, leg.glide.z));
  return glideEvent(leg, x, sigma + glideU(leg, sigma) * along_x, true);
}

/// How the event moves with σ.
KERNEL vec4 turningFlow(LEG leg, vec3 d, real sigma) {
  real own = turningOwnTime(leg, sigma);
  vec3 x = spinPlace(leg, d, own);
  vec3 w = spinVelocity(leg, x, own);
  if (!(leg.glide.w > real(0))) return vec4(real(1), w);
  vec3 n = vec3(leg.glide.x, leg.glide.y, leg.glide.z);
  real u = glideU(leg, sigma);
  w = w / gammaOf(u);
  bool gliding = sigma > leg.glideTimes.z && sigma < leg.glideTimes.w;
  real s = sigma + u * dot(x, n);
  real flow = real(1) + u * dot(w, n) - (gliding ? leg.glide.w * dot(x, n) : real(0));
  real along_w = dot(w, n);
  real place = along_w / gammaOf(glideU(leg, s));
  real uO = leg.glideTimes.y;
  return glideFlow(leg, x, s, true) * flow + vec4(-uO * place, w + n * (gammaOf(uO) * place - along_w));
}

/// The number of steps of the searches below: Newton's; one that would leave the known bounds of the root
/// goes half of the way instead.
KERNEL int turningSteps() { return 14; }

/// The bounds of σ − s for whatever is simultaneous with the centre at s in any frame, or reaches it by
/// light.
KERNEL real turningSpread(LEG leg, vec3 d) {
  real u = max(leg.glideTimes.x, leg.glideTimes.y);
  real stretch = leg.glide.w > real(0) ? real(2) * (gammaOf(u) + u) : real(1);
  return length(d) * stretch * real(1.00001);
}

/// Where the vertex crosses the past cone of the eye: t + (|e − x| − l0) = 0.
KERNEL vec4 turningEmission(LEG leg, vec3 d) {
  real after = turningSpread(leg, d);
  real before = -after;
  vec3 d0 = spinStart(leg, d);
  real s = -extraDistance(leg, d0);
  vec4 event = turningEvent(leg, d, s);
  for (int i = 0; i < turningSteps(); ++i) {
    vec3 x = vec3(event.y, event.z, event.w);
    vec4 flow = turningFlow(leg, d, s);
    vec3 toEye = leg.eye - x;
    real g = event.x + extraDistance(leg, x);
    real slope = flow.x - dot(vec3(flow.y, flow.z, flow.w), toEye) / max(length(toEye), real(1e-6));
    before = g > real(0) ? before : s;
    after = g > real(0) ? s : after;
    real next = s - g / slope;
    bool inside = (next >= before) && (next <= after);
    s = inside ? next : real(0.5) * (before + after);
    event = turningEvent(leg, d, s);
  }
  return event;
}

/// Where it crosses the plane of the moment that is shown: m·(t, x) = 0.
KERNEL vec4 turningMoment(LEG leg, vec3 d) {
  real after = turningSpread(leg, d);
  real before = -after;
  real s = real(0);
  vec4 event = turningEvent(leg, d, s);
  for (int i = 0; i < turningSteps(); ++i) {
    real g = dot(leg.toMoment, event);
    before = g > real(0) ? before : s;
    after = g > real(0) ? s : after;
    real next = s - g / dot(leg.toMoment, turningFlow(leg, d, s));
    bool inside = (next >= before) && (next <= after);
    s = inside ? next : real(0.5) * (before + after);
    event = turningEvent(leg, d, s);
  }
  return event;
}

/// A displacement of this frame in the frame of the leg's turn.
KERNEL vec4 inTurnFrame(LEG leg, vec4 way) {
  if (!(leg.glide.w > real(0))) return way;
  vec3 n = vec3(leg.glide.x, leg.glide.y, leg.glide.z);
  real u = leg.glideTimes.x * gammaOf(leg.glideTimes.y) - leg.glideTimes.y * gammaOf(leg.glideTimes.x);
  real gamma = gammaOf(u);
  vec3 x = vec3(way.y, way.z, way.w);
  return vec4(gamma * way.x - u * dot(x, n), x + n * ((gamma - real(1)) * dot(x, n) - u * way.x));
}

/// When the vertex is as far from an earlier event as what left there at `speed` has come, in the frame of
/// the turn: speed (t − t_from) = |x − x_from|. That rises where no point of the body is as fast. Returns σ.
KERNEL real turningReached(LEG leg, vec3 d, vec4 from, real speed) {
  bool glides = leg.glide.w > real(0);
  // Counted from the earlier event, which may lie far back.
  real since = glides ? dot(leg.toBoardTime, from) : from.x;
  vec4 there = inTurnFrame(leg, turningEvent(leg, d, since) - from);
  RootSearch root;
  root.at = length(vec3(there.y, there.z, there.w)) / speed;
  root.before = glides ? -turningSpread(leg, d) : real(0);
  root.after =
      glides ? noBound() : (length(d) + length(vec3(from.y, from.z, from.w))) / speed * real(1.00001);
  root.step = noBound();
  root.ended = false;
  for (int i = 0; i < boundedSteps() && !root.ended; ++i) {
    vec4 way = inTurnFrame(leg, turningEvent(leg, d, since + root.at) - from);
    vec4 flow = inTurnFrame(leg, turningFlow(leg, d, since + root.at));
    vec3 x = vec3(way.y, way.z, way.w);
    real distance = length(x);
    real g = speed * way.x - distance;
    real slope = speed * flow.x - dot(vec3(flow.y, flow.z, flow.w), x) / max(distance, real(1e-9));
    advance(root, g, slope);
  }
  return since + root.at;
}

/// The speed at which a vertex catches up with a leg on which it goes round, while friction may leave it
/// behind.
KERNEL real turningCatchUpSpeed(LEG leg, vec3 d) {
  real turn = isSlowed(leg) ? leg.spinSlows.z : real(0);
  real around = length(spinVelocity(leg, d, turn));
  real back = leg.glide.w > real(0) ? glideFallsBack(leg) : real(0);
  return fasterThan((around + back) / (real(1) + around * back));
}
