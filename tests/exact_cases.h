#pragma once
// The exact cases of tests/data/cases: inputs and results that were computed with 50 digits from first
// principles, each with the tolerance that the rounding of its inputs leaves. tests/data/README.md names the
// sources.

#include <fstream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "places.h"

namespace carom::test {

/// Returns the cases of a file of tests/data/cases. Throws if it cannot be read or holds none.
inline nlohmann::json exactCases(const std::string& file) {
  const std::string path = std::string(CAROM_TESTS_DIR "/data/cases/") + file;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  nlohmann::json cases = nlohmann::json::parse(in).at("cases");
  if (cases.empty()) throw std::runtime_error("no cases in " + path);
  return cases;
}

}  // namespace carom::test
