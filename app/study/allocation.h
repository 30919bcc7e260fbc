#pragma once
// Who takes part in which arm, in which order of lessons, with which forms of the tests. All of it follows
// from the seed of the study, the same on every machine.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/study/study.h"

namespace carom {

/// The generator SplitMix64 (G. L. Steele, D. Lea, C. H. Flood 2014): a counter and a mixing function.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// Returns a number below n, at least 1, each equally likely.
  std::uint64_t below(std::uint64_t n);

 private:
  std::uint64_t state_;
};

/// Returns the rows of a Williams square (E. J. Williams 1949) of n lessons, by their indices. Row 0 is
/// 0, 1, n − 1, 2, n − 2, …; row r adds r modulo n. For odd n the same rows follow backwards. Each lesson
/// stands equally often in each place, and follows equally often each other one.
std::vector<std::vector<std::size_t>> williamsRows(std::size_t n);

struct Participant {
  std::size_t number = 0;            ///< from 1
  std::size_t arm = 0;               ///< index of the study's arms
  std::size_t orderRow = 0;          ///< of the Williams square; 0 if the order is fixed
  std::vector<std::size_t> lessons;  ///< indices of the study's lessons, in the order of this participant
  std::array<std::size_t, 3> forms{0, 1, 2};  ///< before, after, delayed: indices of kForms
};

/// Returns all planned participants.
std::vector<Participant> allocate(const Study& study);

/// Returns the allocation with the hash of the study, as JSON.
std::string planJson(const Study& study, const std::vector<Participant>& participants);

}  // namespace carom
