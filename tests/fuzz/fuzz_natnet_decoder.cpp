// A NatNet server that says what it likes. Bytes 0 and 1 are the version that it gave before.

#include <array>

#include "devices/protocol/natnet_decoder.h"
#include "fuzz/expect.h"

namespace {

/// What a server of that version says of itself, with a clock of 10 MHz.
std::array<std::uint8_t, 276> greeting(std::uint8_t major, std::uint8_t minor) {
  std::array<std::uint8_t, 276> bytes{1, 0, 272 & 0xff, 272 >> 8};
  bytes[4 + 260] = major;
  bytes[4 + 261] = minor;
  bytes[4 + 264] = 0x80;
  bytes[4 + 265] = 0x96;
  bytes[4 + 266] = 0x98;
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size < 2) return 0;
  carom::NatnetDecoder decoder;
  std::vector<carom::Reading> readings;
  decoder.decode(greeting(bytes[0], bytes[1]), readings);
  decoder.decode({bytes + 2, size - 2}, readings);
  carom::test::expectSound(readings);
  return 0;
}
