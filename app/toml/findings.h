#pragma once
// The faults and oddities of a file, in as few lines as tell them: a file with one mistake on each of its
// lines would otherwise print more than anybody can read.

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "app/toml/input_file.h"

namespace carom {

/// An error or an unusual value in a file.
struct Finding {
  enum class Kind { warning, error };
  Kind kind = Kind::warning;
  FilePlace at;
  std::string text;
  std::size_t count = 1;  ///< number of findings that this one stands for
};

/// The most lines that are told about one file, without that which counts the others.
inline constexpr std::size_t kMostFindings = 100;

/// Findings in the order in which they were made. Two are alike if their texts differ in numbers and quoted
/// names alone. Of many that are alike only some are kept; the last of these stands for the rest.
class FindingList {
 public:
  /// Adds a finding, unless it is there already with its place and text.
  void add(Finding finding);

  const std::vector<Finding>& all() const { return kept_; }
  bool empty() const { return kept_.empty(); }
  std::size_t size() const { return kept_.size(); }
  const Finding& operator[](std::size_t i) const { return kept_[i]; }
  const Finding& back() const { return kept_.back(); }
  auto begin() const { return kept_.begin(); }
  auto end() const { return kept_.end(); }
  /// Returns whether further findings need no helpful words.
  bool isLong() const { return kept_.size() >= kMostFindings; }

 private:
  struct Alike {
    std::size_t kept = 0, last = 0;  // number of them in kept_; index of the last one
  };
  std::vector<Finding> kept_;
  std::unordered_map<std::uint64_t, Alike> alike_;
  std::unordered_set<std::uint64_t> known_;  // hashes of place and text
};

/// Returns the findings by their places, at most kMostFindings: eight or more that are alike become one, "8
/// walls: …", at the place of the first. If there are more, one more line says how many.
std::vector<Finding> toldOf(std::vector<Finding> findings);

}  // namespace carom
