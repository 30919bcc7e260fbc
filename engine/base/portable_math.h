#pragma once
// Elementary functions that give the same bits on every machine: the C library's differ between CPUs by a
// rounding, which would make two nodes of a cluster, or a session and its replay, drift apart. They use
// + − × ÷ and sqrt alone, which IEEE 754 fixes.

namespace carom {

/// ln x of a positive, finite x; within 2 units in the last place.
double portableLog(double x);

/// asinh x = sign(x) ln(|x| + sqrt(1 + x²)), for rapidities; within 4 units in the last place.
double portableAsinh(double x);

}  // namespace carom
