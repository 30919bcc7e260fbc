// Rig files of anything.

#include "app/files/rig.h"
#include "engine/base/input_error.h"
#include "fuzz/file_of.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    carom::readRig(carom::test::fileOf(bytes, size));
  } catch (const carom::InputError&) {
  }
  return 0;
}
