// Recorded hands of anything, and the force that the loop gives them.

#include <cmath>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "devices/force/force_loop.h"
#include "devices/force/recorded_hand.h"
#include "engine/text/input_error.h"
#include "fuzz/expect.h"

namespace {

using carom::test::expect;

/// Plays the first ticks of the trace, as `carom force --positions` does.
void feel(const std::vector<carom::HandRow>& hand) {
  constexpr int kMostTicks = 200;
  const carom::ForceLimits limits;
  carom::ForceLoop loop(limits);
  carom::ForceLaw law;
  law.kind = carom::ForceLaw::Kind::cue;
  law.cue = {0.403, 0.08, 1.0};
  carom::ForceDeviceState device;
  for (int tick = 0; tick < kMostTicks; ++tick) {
    const double now_s = hand.front().time_s + tick * limits.period_s;
    const carom::HandRow row = carom::handAt(hand, now_s);
    device.position_m = row.place_m;
    device.pressed = row.pressed;
    device.time_s = law.posted_s = now_s;
    device.held_n = loop.tick(now_s, device, law).force_n;
    expect(glm::length(device.held_n) <= limits.force_n * (1.0 + 1e-9),
           "the force is what the device can do");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    const std::vector<carom::HandRow> hand = carom::readHandRows(text, "given.csv");
    expect(!hand.empty(), "there is a row");
    for (std::size_t i = 0; i < hand.size(); ++i) {
      expect(i == 0 || hand[i].time_s > hand[i - 1].time_s, "time increases");
      expect(glm::length(hand[i].place_m) <= 2e3, "places are near");
    }
    feel(hand);
  } catch (const carom::InputError&) {
  }
  return 0;
}
