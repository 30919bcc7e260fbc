// The Polhemus transport with the real libusb, against captured traffic: every transfer that it makes, of
// that kind and length and in that order, or the replay stands still.

#include <gtest/gtest.h>

#include <cstring>

#include "devices/polhemus_box.h"
#include "devices/usb/polhemus_tracker.h"
#include "devices/usb_capture.h"
#include "devices/witness.h"

namespace carom {
namespace {

using test::UsbCapture;
using test::Witness;

constexpr std::uint8_t kOut = 0x02, kIn = 0x82;

/// Record `frame` of a station that stands at (frame, 0, 0) cm.
std::string record(std::uint32_t frame) {
  std::string bytes("LY\1C \0\x28\0", 8);
  const auto append = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  append(std::uint32_t{1000 + 4 * frame});
  append(frame);
  append(std::uint32_t{0});
  for (const float number : {static_cast<float>(frame), 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F}) append(number);
  return bytes;
}

void setUp(UsbCapture& capture) {
  capture.out(kOut, "\r");
  capture.out(kOut, "P\r");
  capture.wait(kIn, 1024);  // what it had to say before
  capture.came(kIn, "01  12.3   4.5   6.7   0.0   0.0   0.0\r\n");
  capture.wait(kIn, 1024);
  capture.gaveUp();
  for (const char* command : {"F1\r", "U1\r", "O*,8,9,11,3,7\r", "X0,1,0,0\r", "Y0,1,0,0\r"}) {
    capture.out(kOut, command);
  }
  capture.wait(kIn, 1024);
  capture.gaveUp();
  capture.out(kOut, "C\r");
  for (int i = 0; i < 8; ++i) capture.wait(kIn, 64);
}

TEST(PolhemusCapture, ShortPacketsErrorsAndUnplugging) {
  const auto path =
      std::filesystem::temp_directory_path() / ("carom-" + std::to_string(getpid()) + "-liberty.pcap");
  UsbCapture capture(path);
  setUp(capture);
  const auto came = [&](const std::string& bytes, int status = 0) {
    capture.came(kIn, bytes, status);
    capture.wait(kIn, 64);
  };
  std::string stream;
  for (std::uint32_t frame = 0; frame < 40; ++frame) stream += record(frame);
  for (std::size_t at = 0, i = 0; at < stream.size(); ++i) {  // full, short and empty packets
    const std::size_t size =
        std::min((std::array<std::size_t, 6>{64, 32, 1, 64, 0, 47})[i % 6], stream.size() - at);
    came(stream.substr(at, size));
    at += size;
  }
  came({}, -71);  // EPROTO: and the record that it should have brought is gone
  came(record(41).substr(0, 20));
  came({}, -75);  // EOVERFLOW: the rest of it, too
  came(record(42));
  while (capture.waiting() > 0) capture.came(kIn, {}, -108);  // ESHUTDOWN
  capture.close();

  test::MockedKernel kernel;
  kernel.plugIn(test::PolhemusBox::description({}));
  kernel.replay(test::PolhemusBox::kSystemPath, path);
  {
    const Witness witness(polhemusTransport({0x0f44, 0xff12, {}}));
    ASSERT_TRUE(witness.until(
        [&] { return witness.told("disconnected: Polhemus LIBERTY (0f44:ff12): it was unplugged"); }));
    const std::vector<Reading> readings = witness.readings();
    ASSERT_EQ(readings.size(), 41u);
    for (std::size_t i = 0; i < 41; ++i) {
      const double frame = i < 40 ? static_cast<double>(i) : 42.0;
      EXPECT_NEAR(readings[i].pose.position_m.x, 0.01 * frame, 1e-9);
      EXPECT_NEAR(readings[i].device_s, 1.0 + 0.004 * frame, 1e-9);
    }
    EXPECT_EQ(witness.count("refused"), 2u + 1u);  // two transfers, and the record whose rest is missing
    EXPECT_EQ(witness.count("missed 2"), 1u);
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace carom
