// A body that spins turns its points about its z, in the leg's frame, by the centre's own time:
//   x(s) = Rot(ω s/c) d0,  d0 = Rot(its angle at the origin) d
// The angle at the origin was folded in double: the rest for a vertex is small.

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
KERNEL vec3 spinStart(LEG leg, vec3 d) { return turnedBy(vec2(leg.spin.y, leg.spin.z), d); }

KERNEL bool isSlowed(LEG leg) { return leg.spinSlows.y != real(0); }

/// The own time nearest to s within which the cloth slows the spin.
KERNEL real withinSlowing(LEG leg, real s) { return min(max(s, leg.spinSlows.z), leg.spinSlows.w); }

/// γβ of the rim at own time s: it falls evenly, is what it was at the turn before that, and ends at 0.
KERNEL real slowedRim(LEG leg, real s) {
  if (s >= leg.spinSlows.w) return real(0);
  return leg.spinSlows.x - leg.spinSlows.y * (withinSlowing(leg, s) - withinSlowing(leg, real(0)));
}

/// ω/c at own time s.
KERNEL real spinRate(LEG leg, real s) {
  if (!isSlowed(leg)) return leg.spin.x;
  real h = slowedRim(leg, s);
  return leg.spin.x * h / sqrt(real(1) + h * h);
}

/// The angle by which it turns from the origin to own time s: with h the rim's γβ and Γ its γ, ∫ h/Γ ds =
/// (s − o)(h_o + h)/(Γ_o + Γ) while it is slowed, which does not cancel.
KERNEL real spinAngle(LEG leg, real s) {
  if (!isSlowed(leg)) return leg.spin.x * s;
  real r = withinSlowing(leg, s);
  real o = withinSlowing(leg, real(0));
  real hO = leg.spinSlows.x;
  real h = slowedRim(leg, s);
  real gammaO = sqrt(real(1) + hO * hO);
  real gamma = sqrt(real(1) + h * h);
  return leg.spin.x * ((r - o) * (hO + h) / (gammaO + gamma) + (s - r) * h / gamma + o * hO / gammaO);
}

/// The velocity, over c, of the point at x at own time s: ω/c ẑ × x.
KERNEL vec3 spinVelocity(LEG leg, vec3 x, real s) { return spinRate(leg, s) * vec3(-x.y, x.x, real(0)); }

/// The vertex's place at own time s.
KERNEL vec3 spinPlace(LEG leg, vec3 d, real s) { return turnedBy(cosSin(spinAngle(leg, s)), spinStart(leg, d)); }

/// A direction that the body carries along (a normal), as it points at an event of this leg.
KERNEL vec3 carriedAlong(LEG leg, vec4 event, vec3 direction) {
  if (leg.spin.w == real(0)) return direction;
  return spinPlace(leg, direction, event.x);
}

/// Where the vertex crosses the past cone of the eye. From where and when the eye sees the point of the
/// axis that is as high, at the distance l and with the turned offset p of the vertex, e = (e_x, e_y)
/// across the axis:
///   g(s) = s + q/(D + l) = 0,  D = sqrt(l² + q) the distance of the vertex,
///   q = p² − 2 (A cos a − B sin a),  a = ω s/c,  A = e·p,  B = e_x p_y − e_y p_x
/// It rises: its slope 1 + ω/c (B cos a + A sin a)/D is 1 − n·w with n towards the eye. So there is one
/// root, and |s| ≤ |p|. Halley's steps; one that would leave the known bounds of the root goes
/// half of the way instead. The bounds must include their ends, or a last step from there would be
/// thrown away.
KERNEL vec4 spinEmission(LEG leg, vec3 d, int steps) {
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
