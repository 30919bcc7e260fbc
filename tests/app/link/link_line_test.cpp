// Lines over real sockets on loopback, and ends that are no lines.
#include "app/link/link_line.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <thread>

#include "app/link/link_socket.h"
#include "app/link/quick_line.h"
#include "app/link/sample_messages.h"
#include "app/link/tls_stream.h"
#include "log_lines.h"

namespace carom::test {
namespace {

using std::chrono::milliseconds;

/// A line and what has come on it.
struct End {
  End(const LinkAddress& address, const LinkKey& its = key(), const LinkLimits& limits = quick())
      : line(address, its, limits) {}

  std::size_t count(LineNews::Kind kind) {
    line.take(news);
    return static_cast<std::size_t>(
        std::count_if(news.begin(), news.end(), [&](const LineNews& one) { return one.kind == kind; }));
  }
  std::string closedWith() {
    line.take(news);
    for (const LineNews& one : news)
      if (one.kind == LineNews::Kind::closed) return one.words;
    return {};
  }
  std::uint64_t newest() {
    line.take(news);
    std::uint64_t number = 0;
    for (const LineNews& one : news)
      if (one.kind == LineNews::Kind::opened) number = one.connection;
    return number;
  }
  template <typename Message>
  std::vector<Message> all() {
    line.take(news);
    std::vector<Message> found;
    for (const LineNews& one : news)
      if (const auto* message = std::get_if<Message>(&one.message);
          message && one.kind == LineNews::Kind::message)
        found.push_back(*message);
    return found;
  }

  LinkLine line;
  std::vector<LineNews> news;
};

LinkAddress listening(const char* host = "127.0.0.1") { return {true, host, 0}; }
LinkAddress to(const LinkLine& line, const char* host = "127.0.0.1") { return {false, host, line.port()}; }

/// An end with the key that does as it likes.
class Stranger {
 public:
  explicit Stranger(std::uint16_t port, const LinkKey& its = key()) : end_(false, its) {
    std::string why;
    LinkSocket socket = callTo({false, "127.0.0.1", port}, 0, why);
    comes([&] { return isAnswered(socket, why).has_value(); });
    stream_ = std::make_unique<TlsStream>(end_, socket.release());
  }
  bool shake() {
    comes([&] { return stream_->shakeHands() != TlsStream::State::shakesHands; }, 3.0);
    return stream_->state() == TlsStream::State::open;
  }
  void write(std::span<const std::uint8_t> bytes) {
    std::size_t written = 0;
    comes([&] {
      std::vector<std::uint8_t> ignored;
      stream_->read(ignored);
      written += stream_->write(bytes.subspan(written));
      return written == bytes.size() || stream_->state() == TlsStream::State::over;
    });
  }

 private:
  TlsEnd end_;
  std::unique_ptr<TlsStream> stream_;
};

class LinkLineOver : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Addresses, LinkLineOver, testing::Values("127.0.0.1", "::1"));

TEST_P(LinkLineOver, CarriesMessagesBothWays) {
  End host(listening(GetParam()));
  End joiner(to(host.line, GetParam()));
  ASSERT_TRUE(comes([&] { return host.newest() == 1 && joiner.newest() == 1; }));
  for (std::uint32_t i = 0; i < 100; ++i) host.line.send(1, sampleStroke(i));
  joiner.line.send(1, LinkDigest{7, 8});
  EXPECT_TRUE(
      comes([&] { return joiner.all<LinkStroke>().size() == 100 && host.all<LinkDigest>().size() == 1; }));
  const auto strokes = joiner.all<LinkStroke>();
  for (std::uint32_t i = 0; i < strokes.size(); ++i) EXPECT_EQ(strokes[i].told.number, i);
  EXPECT_TRUE(
      comes([&] { return joiner.line.roundTrip(1).count >= 10 && host.line.roundTrip(1).count >= 10; }));
  EXPECT_LT(joiner.line.roundTrip(1).least_s, 0.2);
  EXPECT_GT(joiner.line.roundTrip(1).least_s, 0.0);
}

// As many messages in all as may come at once: the line's thread may send every one of these presents.
TEST(LinkLine, TheNewestPresentAndEveryStrokeArrive) {
  End host(listening());
  End joiner(to(host.line));
  ASSERT_TRUE(comes([&] { return host.newest() == 1 && joiner.newest() == 1; }));
  LinkPresent present = samplePresent();
  for (std::uint32_t i = 1; i <= 150; ++i) {
    present.present.number = i;
    if (i % 5 == 0) host.line.send(1, sampleStroke(i / 5));
    host.line.present(1, present);
  }
  ASSERT_TRUE(comes([&] {
    const auto presents = joiner.all<LinkPresent>();
    return !presents.empty() && presents.back().present.number == 150;
  })) << joiner.closedWith();
  EXPECT_EQ(joiner.all<LinkStroke>().size(), 30U);
  EXPECT_EQ(joiner.closedWith(), "");
}

TEST(LinkLine, TakesNoOtherKey) {
  End host(listening());
  End joiner(to(host.line), LinkKey::random());
  std::this_thread::sleep_for(milliseconds(600));
  EXPECT_EQ(host.newest(), 0U);
  EXPECT_EQ(joiner.newest(), 0U);
  End right(to(host.line));
  EXPECT_TRUE(comes([&] { return right.newest() == 1; }));
}

TEST(LinkLine, WhoSpeaksSomethingElseIsNotLetIn) {
  End host(listening());
  std::string why;
  LinkSocket browser = callTo({false, "127.0.0.1", host.line.port()}, 0, why);
  ASSERT_TRUE(comes([&] { return isAnswered(browser, why).value_or(false); }));
  const std::string asks = "GET / HTTP/1.1\r\nHost: here\r\n\r\n";
  ASSERT_GT(write(*browser, asks.data(), asks.size()), 0);
  char answer[100];
  EXPECT_TRUE(comes([&] {
    const ssize_t size = read(*browser, answer, sizeof answer);
    return size == 0 || (size < 0 && errno == ECONNRESET);
  })) << "the line does not hang up";
  End right(to(host.line));
  EXPECT_TRUE(comes([&] { return right.newest() == 1; }));
}

TEST(LinkLine, WhoStopsInTheMiddleOfAMessageIsNamed) {
  End host(listening());
  Stranger stranger(host.line.port());
  ASSERT_TRUE(stranger.shake());
  const auto bytes = bytesOf(sampleStroke(3));
  stranger.write(std::span(bytes).first(bytes.size() / 2));
  EXPECT_TRUE(comes([&] { return host.closedWith() == "it stopped in the middle of a message"; }));
}

TEST(LinkLine, WhoFloodsIsNamed) {
  End host(listening());
  Stranger stranger(host.line.port());
  ASSERT_TRUE(stranger.shake());
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t i = 0; i < 2000; ++i) append(LinkDigest{i, i}, bytes);
  stranger.write(bytes);
  EXPECT_TRUE(comes([&] { return host.closedWith() == "it sent more than a room that plays"; }));
  EXPECT_LT(host.news.size(), 300U);
}

TEST(LinkLine, WhoSendsWhatIsNoMessageIsNamed) {
  End host(listening());
  Stranger stranger(host.line.port());
  ASSERT_TRUE(stranger.shake());
  stranger.write(std::vector<std::uint8_t>(40, 0xff));
  EXPECT_TRUE(comes([&] { return host.closedWith().starts_with("it sent a message of kind 65535"); }));
}

TEST(LinkLine, CallsUntilSomebodyAnswers) {
  std::uint16_t port = 0;
  {
    const LinkSocket free = listenAt({true, "127.0.0.1", 0});
    port = portOf(free);
  }
  End joiner({false, "127.0.0.1", port});
  std::this_thread::sleep_for(milliseconds(200));
  EXPECT_EQ(joiner.newest(), 0U);
  End host({true, "127.0.0.1", port});
  EXPECT_TRUE(comes([&] { return joiner.newest() == 1; }));
}

// A listener that takes the call and says nothing, and a host without a name.
TEST(LinkLine, SilenceAndHostsWithoutANameAreCalledAgain) {
  const LinkSocket silent = listenAt({true, "127.0.0.1", 0});
  End joiner({false, "127.0.0.1", portOf(silent)});
  std::size_t calls = 0;
  std::vector<Called> called;
  EXPECT_TRUE(comes([&] {
    if (auto next = nextCaller(silent)) called.push_back(std::move(*next));
    calls = called.size();
    return calls >= 2;
  }));
  End lost({false, "no-such-host.invalid", 7314});
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_EQ(lost.newest(), 0U);
}

/// Returns what is said of a call that nobody answers as another room does.
std::string saidOf(
    const LinkAddress& address, const std::function<void()>& meanwhile = [] {}) {
  const LogLines lines;
  End lost(address);
  comes([&] {
    meanwhile();
    return !lines.said().empty();
  });
  EXPECT_EQ(lost.newest(), 0U);
  return lines.said().empty() ? "" : lines.said()[0];
}

TEST(LinkLine, SaysWhyNobodyAnswers) {
  const auto expect = [](const std::string& said, const std::string& host, const char* why) {
    EXPECT_TRUE(said.starts_with("link: " + host)) << said;
    EXPECT_NE(said.find(" does not answer: " + std::string(why)), std::string::npos) << said;
    EXPECT_TRUE(said.ends_with("It is called again.")) << said;
  };
  expect(saidOf({false, "no-such-host.invalid", 7314}), "no-such-host.invalid:7314", "");
  std::uint16_t port = 0;
  {
    const LinkSocket free = listenAt({true, "127.0.0.1", 0});
    port = portOf(free);
  }
  expect(saidOf({false, "127.0.0.1", port}), "127.0.0.1", "Connection refused");
  const LinkSocket silent = listenAt({true, "127.0.0.1", 0});
  expect(saidOf({false, "127.0.0.1", portOf(silent)}), "127.0.0.1", "it has not proven the key in time");
  const LinkSocket speaks = listenAt({true, "127.0.0.1", 0});
  std::vector<Called> called;
  const std::string greets = "SSH-2.0-OpenSSH_9.2\r\n";
  const auto greet = [&] {
    if (auto next = nextCaller(speaks)) called.push_back(std::move(*next));
    for (const Called& one : called)
      if (send(*one.socket, greets.data(), greets.size(), MSG_NOSIGNAL) < 0) continue;
  };
  expect(saidOf({false, "127.0.0.1", portOf(speaks)}, greet), "127.0.0.1", "it has not proven the key.");
}

TEST(LinkLine, ABrokenLineIsCalledAgain) {
  End host(listening());
  End joiner(to(host.line));
  ASSERT_TRUE(comes([&] { return host.newest() == 1 && joiner.newest() == 1; }));
  host.line.close(1, "another game");
  EXPECT_TRUE(comes([&] { return joiner.newest() == 2 && host.newest() == 2; }));
  ASSERT_EQ(joiner.all<LinkBye>().size(), 1U);
  EXPECT_EQ(joiner.all<LinkBye>()[0].reason, "another game");
  host.line.send(1, LinkDigest{1, 1});  // to one that is over
  joiner.line.send(2, LinkDigest{2, 2});
  EXPECT_TRUE(comes([&] { return host.all<LinkDigest>().size() == 1; }));
}

TEST(LinkLine, TooManyUnprovenCallsAreRefused) {
  LinkLimits limits = quick();
  limits.unproven = 2;
  End host(listening(), key(), limits);
  std::vector<LinkSocket> calls;
  std::string why;
  for (int i = 0; i < 20; ++i) calls.push_back(callTo({false, "127.0.0.1", host.line.port()}, 0, why));
  std::size_t over = 0;
  EXPECT_TRUE(comes([&] {
    over = 0;
    for (const LinkSocket& call : calls) {
      char byte = 0;
      over += recv(*call, &byte, 1, MSG_PEEK) == 0 ? 1 : 0;
    }
    return over >= 18;
  }));
}

TEST(LinkLine, APortThatIsTakenIsNamed) {
  End host(listening());
  try {
    End second({true, "127.0.0.1", host.line.port()});
    FAIL() << "it listens twice";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("another program has that port"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace carom::test
