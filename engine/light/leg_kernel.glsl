// One leg of a world line as one eye sees it, and what moves straight in its rest frame: the first text of
// the emission solve (engine/light/emission_kernel.glsl says where these coordinates lie).

/// One leg of one body as one eye sees it; made in double, once a body, leg and eye. What bounds each number
/// is said behind it, for float: D, how far away the body is seen (as far as it can have gone from there, on
/// a leg that it has left); S, how long all its points take to join a leg (WorldLine::settled_s). None grows
/// with the age of the game.
struct LegView {
  vec3 eye;            // e: the eye's place (it is there at c t = l0); γ D
  real distance;       // l0 = |e|
  vec3 seenCentre;     // the centre's emission event from the eye, in the head frame: a straight
                       // light ray; γ_head D
  real boardTime;      // the same emission, c (t − t_o) in the board frame; D
  vec4 toSeenX;        // rows of M: the head-frame place of an event of this frame, from seenCentre; γ_head γ
  vec4 toSeenY;
  vec4 toSeenZ;
  vec4 toBoardTime;    // row that gives the board time of an event, from boardTime; γ
  vec4 signalInPrevious; // the event whose signal ends the previous leg, in the previous leg's frame;
                         // γ (D + c S)
  vec4 originInThis;   // the previous leg's origin, in this frame; γ (D + c S)
  mat4 fromPrevious;   // displacements of the previous leg's frame, in this one; γ of the two
  vec4 glide;          // under friction: direction of motion on the board, then deceleration/c² (1/m);
                       // 0: none
  vec4 glideTimes;     // u at the turn, u at the origin; board c t from the origin to the turn (of every leg
                       // but the first straight one), to rest. While it glides, u/a; the first leg of a
                       // body at rest is straight
  vec4 toMoment;       // m: row that gives the time of an event in the frame whose moment is shown, from the
                       // origin; γ_head γ
  vec4 spin;           // of a body that turns about its z: ω/c (1/m), cos and sin of its angle at the origin,
                       // the number of steps that find an emission; all 0 of a body that never turns
  vec4 spinSlows;      // of a spin that the cloth slows: γβ of the rim at the origin, by how much it falls in
                       // a metre of own time, own time from the origin to the turn, to rest; spin.x
                       // is then 1/R. 0: uniform
};

/// A straight piece of a vertex's world line, from `start` on.
struct Piece {
  vec4 start;
  vec3 velocity;
};

/// δℓ = |e − d| − l0, the vertex's extra distance, without cancellation: q = |e − d|² − l0² = d·(d − 2e).
KERNEL real extraDistance(LEG leg, vec3 d) {
  real q = dot(d, d - real(2) * leg.eye);
  return q / (sqrt(max(leg.distance * leg.distance + q, real(0))) + leg.distance);
}

/// Is event a at or after the signal: c (t_a − t_n) ≥ |x_a − x_n| ?
KERNEL bool reachedBy(vec4 signal, vec4 a) {
  return a.x - signal.x >= length(vec3(a.y - signal.y, a.z - signal.z, a.w - signal.w));
}

KERNEL vec4 along(Piece piece, real s) { return piece.start + s * vec4(real(1), piece.velocity); }

/// Where a piece (continued both ways) crosses the future cone of the signal: s = |X + w s|, X its place from
/// the signal at the time of the signal. A sum of squares under the root: exact where the piece attends the
/// signal.
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
KERNEL vec4 emissionOn(Piece piece, LEG leg) {
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

/// Where a piece crosses the plane of the moment that is shown: m·(start + s (1, w)) = 0. Anything slower
/// than light crosses it once, upwards: m·(1, w) > 0.
KERNEL vec4 momentOn(Piece piece, LEG leg) {
  real now = dot(leg.toMoment, piece.start);
  return along(piece, -now / dot(leg.toMoment, vec4(real(1), piece.velocity)));
}

/// L(v)⁻¹ d = d + u (u·d)/(γ+1): what rests there has on the board the uncontracted offset d.
KERNEL vec3 stretched(LEG leg, vec3 d) {
  vec3 u = vec3(leg.toBoardTime.y, leg.toBoardTime.z, leg.toBoardTime.w);
  return d + u * (dot(u, d) / (leg.toBoardTime.x + real(1)));
}

/// The speed at which a vertex catches up with its outgoing leg, in the rest frame of that leg (at its turn).
KERNEL real catchUpSpeed() { return real(CATCH_UP_SPEED); }
