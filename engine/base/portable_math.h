#pragma once
// Elementary functions that give the same bits on every machine: the C library's differ between CPUs by a
// rounding, which would make two nodes of a cluster, or a session and its replay, drift apart. They use
// + − × ÷ and sqrt alone, which IEEE 754 fixes.

namespace carom {

/// ln x of a positive, finite x; within 2 units in the last place.
double portableLog(double x);

/// asinh x = sign(x) ln(|x| + sqrt(1 + x²)), for rapidities; within 4 units in the last place.
double portableAsinh(double x);

struct SinCos {
  double sin, cos;
};

/// Returns sin x and cos x of an angle up to 10⁶ rad, each within 1 unit in the last place. Of larger angles
/// it first takes whole turns of the double that is nearest to 2π, an error below half a unit in the last
/// place of x.
SinCos portableSinCos(double x);

/// Returns asin x of −1 ≤ x ≤ 1; within 2 units in the last place. NaN beyond.
double portableAsin(double x);

}  // namespace carom
