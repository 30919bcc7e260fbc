// A Polhemus tracker that sends what it likes. The first byte says what it is (bit 0) and in what portions
// the rest comes.

#include <algorithm>

#include "devices/protocol/polhemus_decoder.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  std::span<const std::uint8_t> rest(bytes + 1, size - 1);
  const std::size_t portion = bytes[0] < 2 ? 1024 : bytes[0] / 2;
  carom::PolhemusDecoder decoder((bytes[0] & 1) != 0 ? carom::PolhemusFormat::fastrak
                                                     : carom::PolhemusFormat::liberty);
  std::vector<carom::Reading> readings;
  while (!rest.empty()) {
    const std::size_t count = std::min(portion, rest.size());
    readings.clear();
    decoder.decode(rest.first(count), readings);
    carom::test::expectSound(readings);
    carom::test::expect(readings.size() <= 1 + count / 32, "no record is shorter than 32 bytes");
    rest = rest.subspan(count);
  }
  return 0;
}
