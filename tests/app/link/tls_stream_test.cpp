// TLS by a shared key: all bytes arrive in their order, and without the key nothing opens.
#include "app/link/tls_stream.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <random>

#include "app/link/quick_line.h"

namespace carom::test {
namespace {

// 10⁴ first flights: noise, and true ones with changed bits or cut short. None proves the key.
TEST(LinkLine, NoBrokenHandshakeProvesTheKey) {
  const LinkKey its = key();
  TlsEnd listens(true, its), calls(false, its);
  std::mt19937 random(1);
  std::size_t through = 0;
  for (int i = 0; i < 10000; ++i) {
    int pair[2], flight[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, pair), 0);
    std::vector<std::uint8_t> bytes(1 + random() % 600);
    if (i % 2 == 1) {
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    } else {
      ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, flight), 0);
      TlsStream caller(calls, flight[0]);
      caller.shakeHands();
      bytes.resize(2048);
      const ssize_t size = read(flight[1], bytes.data(), bytes.size());
      close(flight[1]);
      bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(1, size)));
      for (unsigned k = 0; k < 1 + random() % 3; ++k) {
        std::uint8_t& byte = bytes[random() % bytes.size()];
        byte = static_cast<std::uint8_t>(byte ^ (1U << random() % 8));
      }
      if (random() % 4 == 0) bytes.resize(1 + random() % bytes.size());
    }
    TlsStream called(listens, pair[0]);
    ASSERT_GT(write(pair[1], bytes.data(), bytes.size()), 0);
    for (int turn = 0; turn < 3; ++turn) through += called.shakeHands() == TlsStream::State::open ? 1 : 0;
    close(pair[1]);
  }
  EXPECT_EQ(through, 0U);
}

/// Two streams whose bytes pass through the test on their way.
struct Streams {
  explicit Streams(const LinkKey& callers = key()) : calls(false, callers) {
    for (auto* ends : {&near, &far}) EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, *ends), 0);
    caller = std::make_unique<TlsStream>(calls, near[0]);
    called = std::make_unique<TlsStream>(listens, far[0]);
  }
  ~Streams() {
    close(near[1]);
    close(far[1]);
  }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  /// Carries what has been sent; of the bytes to the called end, one is changed. Returns how many there were.
  std::size_t carry(std::optional<std::size_t> changed = {}) {
    std::size_t carried = 0;
    for (const auto& [from, to] : {std::pair(near[1], far[1]), std::pair(far[1], near[1])}) {
      std::uint8_t bytes[4096];
      const ssize_t size = read(from, bytes, sizeof bytes);
      if (size <= 0) continue;
      if (changed && from == near[1]) bytes[*changed % static_cast<std::size_t>(size)] ^= 1;
      EXPECT_EQ(write(to, bytes, static_cast<std::size_t>(size)), size);
      carried += static_cast<std::size_t>(size);
    }
    return carried;
  }
  void shake() {
    for (int turn = 0; turn < 20; ++turn) {
      caller->shakeHands();
      called->shakeHands();
      carry();
    }
  }

  TlsEnd listens{true, key()}, calls;
  int near[2] = {-1, -1}, far[2] = {-1, -1};
  std::unique_ptr<TlsStream> caller, called;
};

TEST(TlsStream, AllBytesArriveInTheirOrderBothWays) {
  Streams streams;
  streams.shake();
  ASSERT_EQ(streams.caller->state(), TlsStream::State::open);
  ASSERT_EQ(streams.called->state(), TlsStream::State::open);
  std::mt19937 random(3);
  for (const bool isBack : {false, true}) {
    TlsStream& from = isBack ? *streams.called : *streams.caller;
    TlsStream& to = isBack ? *streams.caller : *streams.called;
    std::vector<std::uint8_t> sent(500000), arrived;
    for (auto& byte : sent) byte = static_cast<std::uint8_t>(random());
    for (std::size_t written = 0, turn = 0; arrived.size() < sent.size() && turn < 10000; ++turn) {
      written += from.write(std::span(sent).subspan(written));
      streams.carry();
      to.read(arrived);
    }
    EXPECT_TRUE(arrived == sent) << arrived.size() << " bytes";
  }
  streams.caller->close();
  while (streams.carry() > 0) {
  }
  std::vector<std::uint8_t> more;
  EXPECT_EQ(streams.called->read(more), TlsStream::State::over);
  EXPECT_TRUE(more.empty());
}

TEST(TlsStream, WithAnotherKeyNothingOpens) {
  Streams streams(LinkKey::random());
  streams.shake();
  EXPECT_EQ(streams.called->state(), TlsStream::State::over);
  EXPECT_NE(streams.caller->state(), TlsStream::State::open);
  const std::vector<std::uint8_t> bytes(10);
  EXPECT_EQ(streams.called->write(bytes), 0U);
}

TEST(TlsStream, AByteThatIsChangedOnTheWayEndsIt) {
  const std::string said = "a present of a room";
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(said.data()), said.size());
  for (const std::size_t changed : {0U, 7U, 12U, 30U}) {
    SCOPED_TRACE(changed);
    Streams streams;
    streams.shake();
    std::vector<std::uint8_t> arrived;
    ASSERT_EQ(streams.caller->write(bytes), bytes.size());
    streams.carry();
    ASSERT_EQ(streams.called->read(arrived), TlsStream::State::open);
    ASSERT_EQ(arrived.size(), bytes.size());
    ASSERT_EQ(streams.caller->write(bytes), bytes.size());
    streams.carry(changed);
    EXPECT_EQ(streams.called->read(arrived), TlsStream::State::over);
    EXPECT_EQ(arrived.size(), bytes.size()) << "nothing of it is taken";
  }
}

}  // namespace
}  // namespace carom::test
