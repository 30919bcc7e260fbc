// Recorded traces of anything.

#include <sstream>
#include <string>

#include "devices/tracker/trace.h"
#include "engine/text/input_error.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(bytes), size));
  try {
    double last_s = -1e300;
    for (const carom::TrackerSample& sample : carom::readTrace(in, "given.csv")) {
      carom::test::expect(sample.time_s > last_s, "time increases");
      last_s = sample.time_s;
      const glm::dquat& q = sample.pose.orientation;
      carom::test::expect(std::isfinite(glm::length(sample.pose.position_m)), "places are finite");
      carom::test::expect(std::abs(glm::dot(q, q) - 1.0) <= 1e-9, "orientations are unit quaternions");
    }
  } catch (const carom::InputError&) {
  }
  return 0;
}
