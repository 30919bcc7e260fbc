// Datagrams of anything, as of a sender of Open Sound Control.

#include "devices/osc/osc_decoder.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  carom::OscMapping mapping{.pose = carom::OscPattern("/head/{sensor}", false),
                            .values = carom::readOscValues("x y z qx qy qz qw"),
                            .unit_m = 1.0,
                            .buttons = carom::OscPattern("/b/{sensor}/{n}", true),
                            .axes = carom::OscPattern("/a/{sensor}/{n}", true)};
  carom::OscDecoder decoder(std::move(mapping));
  std::vector<carom::Reading> readings;
  const bool isRead = decoder.decode({bytes, size}, readings);
  carom::test::expect(isRead != !decoder.whyRefused().empty(), "what is refused is explained");
  carom::test::expectSound(readings);
  return 0;
}
