// A SpaceMouse that sends what it likes: reports, each with its length before it.

#include <algorithm>

#include "devices/protocol/spacemouse_decoder.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::span<const std::uint8_t> rest(bytes, size);
  carom::SpaceMouseDecoder decoder;
  std::vector<carom::Reading> readings;
  while (!rest.empty()) {
    const std::size_t length = std::min<std::size_t>(rest[0], rest.size() - 1);
    decoder.decode(rest.subspan(1, length), readings);
    rest = rest.subspan(1 + length);
  }
  carom::test::expectSound(readings);
  double values[6 + 48] = {};  // what each axis and button was last told to be
  decoder.release(readings);
  for (const carom::Reading& reading : readings) {
    const bool axis = reading.kind == carom::Reading::Kind::axis;
    carom::test::expect(reading.index < (axis ? 6 : 48), "there are 6 axes and 48 buttons");
    values[reading.index + (axis ? 0 : 6)] = reading.value;
  }
  for (const double value : values) carom::test::expect(value == 0.0, "let go, everything is zero");
  return 0;
}
