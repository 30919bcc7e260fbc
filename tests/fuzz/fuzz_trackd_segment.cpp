// Shared memory in which there is anything, read as trackd's.

#include <stdexcept>

#include "devices/protocol/trackd_segment.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::vector<carom::Reading> readings;
  try {
    const carom::TrackdSensors sensors = carom::readTrackdSensors({bytes, size});
    for (std::size_t i = 0; i < sensors.count; ++i) {
      const auto sensor = carom::readTrackdSensor(carom::copyTrackdSensor({bytes, size}, sensors, i), 0.3048);
      if (sensor) readings.emplace_back().pose = sensor->pose;
    }
  } catch (const std::runtime_error&) {  // it is none
  }
  carom::TrackdWand wand;
  try {
    carom::readTrackdWand({bytes, size}, wand);
  } catch (const std::runtime_error&) {
  }
  for (const std::int32_t button : wand.buttons) readings.emplace_back().value = button;
  for (const float axis : wand.axes) readings.emplace_back().value = static_cast<double>(axis);
  carom::test::expectSound(readings);
  return 0;
}
