// Lines of anything, as of survive-cli. The first byte says how they are cut, and whether there are names.

#include <algorithm>

#include "devices/protocol/survive_decoder.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t piece = 1 + bytes[0];
  carom::SurviveDecoder decoder(bytes[0] % 2 == 0 ? std::vector<std::string>{"T20", "WM0"}
                                                  : std::vector<std::string>{});
  std::vector<carom::Reading> readings;
  for (std::size_t at = 1; at < size; at += piece)
    decoder.decode({bytes + at, std::min(piece, size - at)}, readings);
  carom::test::expectSound(readings);
  carom::test::expect((decoder.refused() > 0) == !decoder.whyRefused().empty(),
                      "what is refused is explained");
  return 0;
}
