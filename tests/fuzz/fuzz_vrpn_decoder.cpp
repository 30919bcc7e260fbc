// A VRPN connection that sends what it likes. The first byte says in what portions the rest comes.

#include <algorithm>
#include <stdexcept>

#include "devices/protocol/vrpn_decoder.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  std::span<const std::uint8_t> rest(bytes + 1, size - 1);
  const std::size_t portion = bytes[0] == 0 ? carom::VrpnDecoder::kMostBytes : bytes[0];
  carom::VrpnDecoder decoder("Head");
  std::vector<carom::Reading> readings;
  try {
    while (!rest.empty()) {
      const std::size_t count = std::min(portion, rest.size());
      readings.clear();
      decoder.decode(rest.first(count), readings);
      carom::test::expectSound(readings);
      rest = rest.subspan(count);
    }
  } catch (const std::runtime_error&) {  // it hangs up
  }
  return 0;
}
