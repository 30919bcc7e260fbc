// Room files of all programs, told apart by their content: what can be read is judged, too.

#include "app/room_formats/room_kind.h"
#include "fuzz/file_of.h"
#include "fuzz/sound_room.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    carom::test::expectSound(carom::readForeignRoom(carom::test::fileOf(bytes, size)));
  } catch (const carom::InputError&) {
  }
  return 0;
}
