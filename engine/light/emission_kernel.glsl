// The emission solve, once: this text and the four before it (leg_kernel, spin_kernel, glide_kernel and
// turning_kernel.glsl, in this order) are compiled as GLSL in the vertex shader and as C++ (over GLM) in
// engine/light/emission_kernel.h. The including source provides the types real, vec2, vec3, vec4, mat4, the
// type LEGS by which legs are reached, LEG of one that is only read, KERNEL (the beginning of a function
// definition), INOUT(type) (a parameter that is changed), UNROLLED (what a loop begins with that is to be
// written out), the numbers MAX_PIECES and CATCH_UP_SPEED and, afterwards, the function legAt.
//
// Where: in the rest frame of a leg, its origin at the event at which the body's centre emitted the light
// that the eye receives. Times are lengths (c t, metres) and come first in a vec4: (c t, x, y, z).
//
// Two effects can be switched off (engine/light/switches.h), for whole views:
//   retarded false:   events are taken where a plane of simultaneity through the observation cuts the world
//                     lines, and so is the origin: the board's plane, or the head's. With m the row that
//                     takes an event of this frame to its time in the plane's, the event is where m·(c t, x)
//                     = 0;
//   contracted false: at each board time a vertex is at the centre's place + d: it turns with the centre;
//   both false:       the plane is the board's; then no frame is needed: the leg's is the board's, moved to
//   the
//                     centre.
// Theory: app/doc/physics.md, Emission; Bounce and catching up.

LEG legAt(LEGS legs, int i);

/// Where and when a vertex emitted the light that the eye receives.
struct VertexEmission {
  vec4 event;      // in the frame of `leg`
  int leg;         // in whose frame `event` is given
  bool catchingUp; // on its way from the previous leg to this one
};

/// The vertex's emission if it kept to this leg always.
KERNEL vec4 emissionOnLeg(LEG leg, vec3 d, bool retarded, bool contracted) {
  if (!retarded && !contracted) return vec4(real(0), carriedAlong(leg, vec4(real(0)), d));
  if (leg.spin.w > real(0)) {
    bool uniform_ = !(leg.glide.w > real(0)) && !isSlowed(leg);
    if (contracted && retarded && uniform_) return spinEmission(leg, d, int(leg.spin.w));
    if (contracted) return retarded ? turningEmission(leg, d) : turningMoment(leg, d);
    d = spinStart(leg, d);  // uncontracted, all points have the angle that the centre shows
  }
  if (leg.glide.w > real(0)) {
    real s = retarded ? glideEmission(leg, d, contracted) : glideMoment(leg, d, contracted);
    return glideEvent(leg, d, s, contracted);
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
    LEG leg = legAt(legs, i);
    vec4 onLeg = emissionOnLeg(leg, d, retarded, false);
    if (dot(leg.toBoardTime, onLeg) >= leg.glideTimes.z) {
      emission.event = onLeg;
      emission.leg = i;
    }
  }
  return emission;
}

/// The way of a vertex so far: pieces in the frame of one leg, the oldest first. A piece is straight, or
/// follows the vertex's curve on the leg whose number it has; that of a straight one is −1.
struct VertexPath {
  Piece pieces[MAX_PIECES];
  int curves[MAX_PIECES];
  int count;
};

/// A vertex's way from the leg that it left to its place on the next one, and its rest there.
struct Joining {
  Piece way;
  Piece rest;
};

/// The velocity, over c, of what takes this step in time and space.
KERNEL vec3 velocityOf(vec4 step) { return vec3(step.y, step.z, step.w) / step.x; }

KERNEL bool isCurved(LEG leg) { return leg.spin.w > real(0) || leg.glide.w > real(0); }

/// Where the vertex's curve on `leg` crosses the future cone of the signal.
KERNEL vec4 crossingOnCurve(LEG leg, vec3 d, vec4 signal) {
  if (leg.spin.w > real(0)) return turningEvent(leg, d, turningReached(leg, d, signal, real(1)));
  return glideEvent(leg, d, glideCrossing(leg, d, signal), true);
}

/// An event of the previous leg's frame, in the frame of `leg`.
KERNEL vec4 fromPreviousLeg(LEG leg, vec4 event) { return leg.originInThis + leg.fromPrevious * event; }

/// The inverse: of a Lorentz transform Λ it is η Λᵀ η.
KERNEL vec4 toPreviousLeg(LEG leg, vec4 event) {
  vec4 here = event - leg.originInThis;
  vec4 there = vec4(here.x, -here.y, -here.z, -here.w) * leg.fromPrevious;
  return vec4(there.x, -there.y, -there.z, -there.w);
}

/// Where the latest piece crosses the future cone of the signal; both are in the frame of leg `i`.
KERNEL vec4 crossingOfLatest(LEGS legs, int i, INOUT(VertexPath) path, vec3 d, vec4 signal) {
  int curve = path.curves[path.count - 1];
  if (curve < 0) return crossingOf(path.pieces[path.count - 1], signal);
  for (int k = i; k > curve; --k) signal = toPreviousLeg(legAt(legs, k), signal);
  vec4 a = crossingOnCurve(legAt(legs, curve), d, signal);
  for (int k = curve + 1; k <= i; ++k) a = fromPreviousLeg(legAt(legs, k), a);
  return a;
}

/// A: the event at which the vertex leaves leg `i`, where the signal crosses the latest piece that had
/// begun by then. Later pieces are dropped: a signal that comes out of turn cuts an earlier piece. The first
/// piece has no beginning.
KERNEL vec4 leaveLeg(LEGS legs, int i, INOUT(VertexPath) path, vec3 d, vec4 signal) {
  vec4 a = crossingOfLatest(legs, i, path, d, signal);
  while (path.count > 1 && a.x < path.pieces[path.count - 1].start.x) {
    path.count = path.count - 1;
    a = crossingOfLatest(legs, i, path, d, signal);
  }
  return a;
}

/// Takes the pieces from the previous leg's frame into the frame of `leg`.
KERNEL void enterFrame(INOUT(VertexPath) path, LEG leg) {
  for (int k = 0; k < path.count; ++k) {
    path.pieces[k].velocity = velocityOf(leg.fromPrevious * vec4(real(1), path.pieces[k].velocity));
    path.pieces[k].start = fromPreviousLeg(leg, path.pieces[k].start);
  }
}

/// B: from event A straight to the vertex's place on `leg`, at catchUpSpeed in its frame.
KERNEL Joining joinLeg(LEG leg, vec3 d, vec4 a) {
  vec3 gap = d - vec3(a.y, a.z, a.w);
  real gapLength = length(gap);
  Joining joining;
  joining.way.start = a;
  joining.way.velocity = gapLength > real(0) ? gap * (catchUpSpeed() / gapLength) : vec3(real(0));
  joining.rest.start = vec4(a.x + gapLength / catchUpSpeed(), d);
  joining.rest.velocity = vec3(real(0));
  bool curved = false;
  if (leg.spin.w > real(0)) {
    joining.rest.start = turningEvent(leg, d, turningReached(leg, d, a, turningCatchUpSpeed(leg, d)));
    curved = true;
  } else if (leg.glide.w > real(0)) {
    joining.rest.start = glideEvent(leg, d, glideJoining(leg, d, a), true);
    curved = true;
  }
  vec4 step = joining.rest.start - a;
  if (curved) joining.way.velocity = step.x > real(0) ? velocityOf(step) : vec3(real(0));
  return joining;
}

/// Adds the two pieces of a joining of leg `i`. Without room for them, forgets the two oldest: no signal
/// reaches that far back.
KERNEL void addJoining(INOUT(VertexPath) path, Joining joining, LEG leg, int i) {
  if (path.count > MAX_PIECES - 2) {
    for (int k = 2; k < path.count; ++k) {
      path.pieces[k - 2] = path.pieces[k];
      path.curves[k - 2] = path.curves[k];
    }
    path.count = path.count - 2;
  }
  path.pieces[path.count] = joining.way;
  path.curves[path.count] = -1;
  path.pieces[path.count + 1] = joining.rest;
  path.curves[path.count + 1] = isCurved(leg) ? i : -1;
  path.count = path.count + 2;
}

/// The same as below, of a body with two legs: the first has no beginning, and the vertex leaves it once.
KERNEL VertexEmission emissionAroundTurn(LEGS legs, vec3 d, bool retarded) {
  LEG before = legAt(legs, 0);
  LEG after = legAt(legs, 1);
  vec4 signal = after.signalInPrevious;
  VertexEmission emission;
  emission.event = emissionOnLeg(before, d, retarded, true);
  emission.leg = 0;
  emission.catchingUp = false;
  if (!reachedBy(signal, emission.event)) return emission;
  Piece rest = Piece(vec4(real(0), d), vec3(real(0)));
  vec4 a = isCurved(before) ? crossingOnCurve(before, d, signal) : crossingOf(rest, signal);
  Joining joining = joinLeg(after, d, fromPreviousLeg(after, a));
  emission.event = emissionOnLeg(after, d, retarded, true);
  emission.catchingUp = emission.event.x < joining.rest.start.x;
  if (emission.catchingUp) emission.event = retarded ? emissionOn(joining.way, after) : momentOn(joining.way, after);
  emission.leg = 1;
  return emission;
}

/// The emission event of the vertex at intrinsic offset d of a body that has these legs.
///
/// A vertex keeps to its leg until the signal that ends it, spreading at c, arrives (A), then catches up with
/// its place on the next leg, at catchUpSpeed there (B). A signal that arrives earlier than B cuts that
/// short. So every vertex has a continuous world line slower than light, and exactly one emission event.
KERNEL VertexEmission solveEmission(LEGS legs, int legCount, vec3 d, bool retarded, bool contracted) {
  if (!contracted) return uncontractedEmission(legs, legCount, d, retarded);
  if (legCount == 2) return emissionAroundTurn(legs, d, retarded);
  LEG leg = legAt(legs, 0);
  VertexEmission emission;
  emission.event = emissionOnLeg(leg, d, retarded, true);
  emission.leg = 0;
  emission.catchingUp = false;
  if (legCount == 1) return emission;

  VertexPath path;
  path.pieces[0].start = vec4(real(0), d);
  path.pieces[0].velocity = vec3(real(0));
  path.curves[0] = isCurved(leg) ? 0 : -1;
  path.count = 1;
  vec4 here = emission.event;  // the same event, in the frame of the leg at hand
  for (int i = 1; i < legCount; ++i) {
    LEG next = legAt(legs, i);
    bool reached = reachedBy(next.signalInPrevious, here);
    vec4 a = leaveLeg(legs, i - 1, path, d, next.signalInPrevious);
    enterFrame(path, next);
    here = fromPreviousLeg(next, here);
    // Kept by name, too: Mesa 22 loses the pieces when they are read back from the array.
    Joining joining = joinLeg(next, d, fromPreviousLeg(next, a));
    addJoining(path, joining, next, i);
    if (reached) {
      emission.event = emissionOnLeg(next, d, retarded, true);
      emission.catchingUp = emission.event.x < joining.rest.start.x;
      if (emission.catchingUp) emission.event = retarded ? emissionOn(joining.way, next) : momentOn(joining.way, next);
      emission.leg = i;
      here = emission.event;
    }
  }
  return emission;
}

/// The emission event seen from the eye, in the head frame: along it comes the straight ray that walls draw.
KERNEL vec3 seenFromEye(LEG leg, vec4 event) {
  return leg.seenCentre + vec3(dot(leg.toSeenX, event), dot(leg.toSeenY, event), dot(leg.toSeenZ, event));
}

/// Distance that the light travels in the leg's rest frame: the eye receives at c t = l0.
KERNEL real distanceInBody(LEG leg, vec4 event) { return leg.distance - event.x; }

/// c (t − t_o): how long ago the light left, in board time (negative).
KERNEL real boardTimeOf(LEG leg, vec4 event) { return leg.boardTime + dot(leg.toBoardTime, event); }

/// A place from the eye, taken for where light that arrives now comes from, (−|x|, x), in another frame.
KERNEL vec3 rayThrough(mat4 otherFromThis, vec3 x) {
  vec4 ray = otherFromThis * vec4(-length(x), x);
  return vec3(ray.y, ray.z, ray.w);
}
