// Recordings of anything, calibrated: rests, tips and corners are found or refused, and are always sound.

#include <sstream>
#include <string>

#include "app/calibration/corner_fit.h"
#include "app/calibration/rig_lines.h"
#include "app/calibration/tip_fit.h"
#include "devices/calibration/rests.h"
#include "devices/tracker/trace.h"
#include "engine/text/input_error.h"
#include "fuzz/expect.h"

using carom::test::expect;

namespace {

void calibrate(const std::vector<carom::TrackerSample>& samples) {
  const carom::TipFit tip = carom::fitTip(samples);
  if (tip.fault.empty())
    expect(std::isfinite(tip.fit.tip_m.x + tip.fit.tip_m.y + tip.fit.tip_m.z), "a tip is a place");
  // Two samples make a rest here, so that small inputs have several.
  const auto rests = carom::restsOf(samples, glm::dvec3(0.0), {.radius_m = 0.005, .least_s = 1e-6});
  std::vector<carom::Touch> touches;
  double end_s = -1e300;
  for (const carom::Rest& rest : rests) {
    expect(rest.begin_s >= end_s && rest.end_s > rest.begin_s, "rests follow each other");
    expect(rest.samples > 0 && rest.spread_m <= 0.03, "a rest is small");
    expect(std::abs(glm::length(rest.pose.orientation) - 1.0) < 1e-9, "a rest has an orientation");
    end_s = rest.end_s;
    const auto number = static_cast<double>(touches.size());
    if (touches.size() < 12) {
      touches.push_back({{"corner", {}, {number, number * number, 1.0}, {0, 0, 1}}, rest.at_m, rest.at_m});
    }
  }
  const carom::CornerFit fit = carom::fitCorners(touches);
  if (!fit.faults.empty()) return;
  const glm::dvec3 at_m = fit.fit.aFromB.position_m;
  expect(std::isfinite(at_m.x + at_m.y + at_m.z), "a tracker has a place");
  expect(std::abs(glm::length(fit.fit.aFromB.orientation) - 1.0) < 1e-9, "and an orientation");
  carom::poseLine("room_from_tracker", fit.fit.aFromB, 1.0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(bytes), size));
  try {
    calibrate(carom::readTrace(in, "given.csv"));
  } catch (const carom::InputError&) {
  }
  return 0;
}
