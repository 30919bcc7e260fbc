// Scenario files of anything.

#include "app/scenario/scenario.h"
#include "engine/text/input_error.h"
#include "fuzz/file_of.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    carom::readScenario(carom::test::fileOf(bytes, size));
  } catch (const carom::InputError&) {
  }
  return 0;
}
