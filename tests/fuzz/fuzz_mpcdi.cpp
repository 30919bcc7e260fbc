// MPCDI files of anything: what can be read is judged, too.

#include "app/room_formats/mpcdi_file.h"
#include "fuzz/file_of.h"
#include "fuzz/sound_room.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    carom::test::expectSound(carom::readMpcdi(carom::test::fileOf(bytes, size)));
  } catch (const carom::InputError&) {
  }
  return 0;
}
