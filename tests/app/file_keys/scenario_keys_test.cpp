// The reader of scenarios reads the keys that are declared for them.
#include "app/file_keys/scenario_keys.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/file_keys/declared_keys.h"
#include "app/scenario/scenario.h"

namespace carom {
namespace {

using test::compare;
using test::Variant;

TEST(FileKey, ReaderOfScenariosReadsTheDeclaredKeys) {
  const Variant seenClock{.leftOut = {}, .more = {{"lesson.stopwatch", "clock = 'seen'"}}};
  const auto read = [](const std::filesystem::path& file) { readScenario(file); };
  compare(scenarioKeys(), read, {{}, seenClock});
}

}  // namespace
}  // namespace carom
