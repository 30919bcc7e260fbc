#pragma once
// Chooses the vector instructions for which a loop over many vertices is compiled. Each loop is written once,
// inlined into one function per instruction set, and selected at run time. Without fused multiply-adds, all
// sets give the same bits.

/// Placed before a function, compiles it for AVX2 or for AVX-512, on processors of a family that has them.
#if defined(__x86_64__)
#define CAROM_AVX2 [[gnu::target("avx2")]]
#define CAROM_AVX512 [[gnu::target("avx512f,prefer-vector-width=512")]]
#else
#define CAROM_AVX2
#define CAROM_AVX512
#endif

namespace carom {

enum class InstructionSet { baseline, avx2, avx512 };

/// Returns the widest set that this machine has. (The first processors with AVX-512 slow down for it; those
/// since have VBMI2.)
inline InstructionSet bestInstructionSet() {
#if defined(__x86_64__)
  static const InstructionSet best = __builtin_cpu_supports("avx512vbmi2") ? InstructionSet::avx512
                                     : __builtin_cpu_supports("avx2")      ? InstructionSet::avx2
                                                                           : InstructionSet::baseline;
  return best;
#else
  return InstructionSet::baseline;
#endif
}

}  // namespace carom
