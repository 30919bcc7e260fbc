#pragma once
// Chooses the vector instructions for which a loop over many vertices is compiled. Each loop is written once,
// inlined into one function per instruction set, and selected at run time. Without fused multiply-adds, all
// sets give the same bits.

/// Placed before a function, compiles it for AVX2, on processors of a family that has it.
#if defined(__x86_64__)
#define CAROM_AVX2 [[gnu::target("avx2")]]
#else
#define CAROM_AVX2
#endif

namespace carom {

enum class InstructionSet { baseline, avx2 };

/// Returns the widest set that this machine has. (AVX-512 would gain a tenth on meshes in cache and nothing
/// beyond: square roots, divisions and memory bound these loops, and are no faster there.)
inline InstructionSet bestInstructionSet() {
#if defined(__x86_64__)
  static const bool avx2 = __builtin_cpu_supports("avx2");
  return avx2 ? InstructionSet::avx2 : InstructionSet::baseline;
#else
  return InstructionSet::baseline;
#endif
}

}  // namespace carom
