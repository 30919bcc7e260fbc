// Addresses, and datagrams within this machine.
#include "devices/network/socket.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "devices/tracker/retry.h"

namespace carom {
namespace {

constexpr std::uint32_t kHere = 0x7f000001;  // 127.0.0.1
constexpr std::chrono::seconds kLong{5};

TEST(Socket, AddressesAreFourNumbers) {
  EXPECT_EQ(ipv4Of("192.168.1.5"), 0xc0a80105U);
  EXPECT_EQ(ipv4Of("0.0.0.0"), 0U);
  for (const char* const wrong : {"", "localhost", "1.2.3", "1.2.3.4.5", "1.2.3.256", "1.2.3.4 ", "::1"})
    EXPECT_FALSE(ipv4Of(wrong)) << wrong;
  EXPECT_TRUE((Ipv4{0xe0000001U, 1}.isGroup()));
  EXPECT_TRUE((Ipv4{0xefffffffU, 1}.isGroup()));
  EXPECT_FALSE((Ipv4{0xdfffffffU, 1}.isGroup()));
  EXPECT_FALSE((Ipv4{0xf0000000U, 1}.isGroup()));
  EXPECT_EQ(toString(Endpoint{"cave-1", 3883}), "cave-1:3883");
  const Ipv4 found = resolve({"10.0.0.7", 5000}, {});
  EXPECT_EQ(found.address, 0x0a000007U);
  EXPECT_EQ(found.port, 5000);
}

TEST(Socket, DatagramsComeWholeWithTheirSender) {
  Socket one = Socket::boundTo({kHere, 0}), other = Socket::boundTo({kHere, 0});
  ASSERT_NE(one.localPort(), 0);
  ASSERT_NE(one.localPort(), other.localPort());
  std::array<std::uint8_t, 64> bytes{};
  EXPECT_FALSE(one.receive(bytes)) << "nothing has come";
  EXPECT_FALSE(waitReadable({&one, &other}, std::chrono::milliseconds(0)));
  const std::vector<std::uint8_t> first{1, 2, 3}, second{4};
  other.send(first, {kHere, one.localPort()});
  other.send(second, {kHere, one.localPort()});
  ASSERT_TRUE(waitReadable({&one, nullptr}, kLong));
  Ipv4 from;
  ASSERT_EQ(one.receive(bytes, &from), first.size());
  EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + 3), first);
  EXPECT_EQ(from.address, kHere);
  EXPECT_EQ(from.port, other.localPort());
  ASSERT_TRUE(waitReadable({&one}, kLong));
  EXPECT_EQ(one.receive(bytes), second.size());
  EXPECT_FALSE(one.receive(bytes));
}

TEST(Socket, APortThatIsTakenNeedsHelp) {
  const Socket holds = Socket::boundTo({kHere, 0});
  try {
    Socket::boundTo({kHere, holds.localPort()});
    ADD_FAILURE() << "it was given twice";
  } catch (const NeedsHelp& refusal) {
    const std::string words = refusal.what();
    EXPECT_TRUE(words.starts_with("cannot listen at 127.0.0.1:" + std::to_string(holds.localPort())))
        << words;
    EXPECT_NE(words.find("another program listens there"), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace carom
