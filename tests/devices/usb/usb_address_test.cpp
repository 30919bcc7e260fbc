#include "devices/usb/usb_address.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(UsbAddress, IsReadAndWritten) {
  const auto address = parseUsbAddress("0f44:ff12");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->vendor, 0x0f44);
  EXPECT_EQ(address->product, 0xff12);
  EXPECT_EQ(address->serial, "");
  EXPECT_EQ(toString(*address), "0f44:ff12");
  const auto one = parseUsbAddress("2833:1:A:1 b");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->product, 1);
  EXPECT_EQ(one->serial, "A:1 b");
  EXPECT_EQ(toString(*one), "2833:0001:A:1 b");
}

TEST(UsbAddress, NothingElseIs) {
  for (const char* text : {"", ":", "0f44", "0f44:", ":ff12", "0f44:ff12:", "0x44:ff12", "10f44:ff12",
                           "0f44:ff1g", "-1:2", " 0f44:ff12", "0f44:ff12 "}) {
    EXPECT_FALSE(parseUsbAddress(text)) << text;
  }
}

}  // namespace
}  // namespace carom
