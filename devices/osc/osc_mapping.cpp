#include "devices/osc/osc_mapping.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace carom {
namespace {

constexpr std::array<std::string_view, 8> kWords{"x", "y", "z", "qx", "qy", "qz", "qw", "-"};
constexpr std::size_t kMostValues = 64;
constexpr std::string_view kExpected = ", expected words such as 'x y z qx qy qz qw'";

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument(why + std::string(kExpected));
}

OscValue valueOf(std::string_view word) {
  const auto found = std::find(kWords.begin(), kWords.end(), word);
  if (found == kWords.end()) refuse('\'' + std::string(word) + "' is no value of a pose");
  return static_cast<OscValue>(found - kWords.begin());
}

}  // namespace

std::vector<OscValue> readOscValues(std::string_view words) {
  std::vector<OscValue> values;
  std::array<int, kWords.size()> counts{};
  while (!words.empty()) {
    const std::size_t length = std::min(words.find(' '), words.size());
    if (length > 0) values.push_back(valueOf(words.substr(0, length)));
    if (length > 0) ++counts.at(static_cast<std::size_t>(values.back()));
    words.remove_prefix(std::min(length + 1, words.size()));
  }
  if (values.size() > kMostValues) refuse("there are more than 64 values");
  const int turned = counts[3] + counts[4] + counts[5] + counts[6];
  for (std::size_t i = 0; i + 1 < kWords.size(); ++i) {
    const bool isNeeded = i < 3 || turned > 0;
    if (counts.at(i) > 1) refuse('\'' + std::string(kWords.at(i)) + "' is there twice");
    if (isNeeded && counts.at(i) == 0) refuse('\'' + std::string(kWords.at(i)) + "' is missing");
  }
  return values;
}

}  // namespace carom
