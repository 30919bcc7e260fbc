// Datagrams of anything, as of a DTRACK controller; a zero byte parts them.

#include <algorithm>

#include "devices/protocol/dtrack_decoder.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  carom::DtrackDecoder decoder;
  std::vector<carom::Reading> readings;
  for (const std::uint8_t *from = bytes, *end = bytes + size; from != end;) {
    const std::uint8_t* to = std::find(from, end, 0);
    readings.clear();
    decoder.decode({from, to}, readings);
    carom::test::expectSound(readings);
    from = to == end ? end : to + 1;
  }
  return 0;
}
