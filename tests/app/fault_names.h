#pragma once
// The names of the cases of a parameterised test.

#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace carom::test {

/// Returns what a case is named as: the letters and digits of what is wrong in it.
inline constexpr auto nameOfFault = [](const auto& tested) {
  std::string name = tested.param.what;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
};

}  // namespace carom::test
