#include "app/link/link_address.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace carom {
namespace {

void expectAddress(const char* text, bool listens, const char* host, std::uint16_t port) {
  const LinkAddress address = linkAddressOf(text);
  EXPECT_EQ(address.listens, listens) << text;
  EXPECT_EQ(address.host, host) << text;
  EXPECT_EQ(address.port, port) << text;
  const LinkAddress again = linkAddressOf(address.text());
  EXPECT_EQ(again.host, address.host) << text;
  EXPECT_EQ(again.port, address.port) << text;
  EXPECT_EQ(again.listens, address.listens) << text;
}

TEST(LinkAddress, IsReadAsPeopleWriteIt) {
  expectAddress("listen:7314", true, "", 7314);
  expectAddress("listen:127.0.0.1:443", true, "127.0.0.1", 443);
  expectAddress("listen:[::1]:443", true, "::1", 443);
  expectAddress("lyon.example.org", false, "lyon.example.org", 7314);
  expectAddress("lyon.example.org:443", false, "lyon.example.org", 443);
  expectAddress("[2001:db8::1]", false, "2001:db8::1", 7314);
  expectAddress("[2001:db8::1]:99", false, "2001:db8::1", 99);
}

TEST(LinkAddress, RefusesOthers) {
  for (const char* text : {"", ":", "listen:", "listen::7314", "listen:x:y", "lyon:", "lyon:0", "lyon:65536",
                           "lyon:12a", "2001:db8::1", "[::1", "[]:5", "[::1]x", "[::1]:", "listen:[::1]"})
    EXPECT_THROW(linkAddressOf(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace carom
