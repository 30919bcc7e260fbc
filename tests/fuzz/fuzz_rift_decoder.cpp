// A headset that sends what it likes: reports, each with its length before it. What comes of them goes
// through the orientation filter.

#include <algorithm>

#include "devices/filter/orientation_filter.h"
#include "devices/protocol/rift_decoder.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::span<const std::uint8_t> rest(bytes, size);
  carom::RiftDecoder decoder;
  carom::OrientationFilter filter;
  std::vector<carom::ImuSample> samples;
  double last_s = 0.0;
  while (!rest.empty()) {
    const std::size_t length = std::min<std::size_t>(rest[0], rest.size() - 1);
    samples.clear();
    decoder.decode(rest.subspan(1, length), samples);
    carom::test::expect(samples.size() <= 3, "a report holds three samples at most");
    for (const carom::ImuSample& sample : samples) {
      const glm::dvec3 &w = sample.rate_rad_s, &a = sample.acceleration_m_s2;
      carom::test::expect(glm::dot(w, w) + glm::dot(a, a) < 6.0 * 105.0 * 105.0, "21 bits hold no more");
      filter.update(sample.device_s - last_s, w, a);
      last_s = sample.device_s;
      const glm::dquat& q = filter.orientation();
      carom::test::expect(std::abs(glm::dot(q, q) - 1.0) <= 1e-9, "orientations are unit quaternions");
    }
    rest = rest.subspan(1 + length);
  }
  return 0;
}
