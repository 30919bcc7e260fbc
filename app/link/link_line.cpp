#include "app/link/link_line.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "app/link/line_connection.h"
#include "app/link/link_socket.h"
#include "app/link/tls_stream.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr std::size_t kMostNews = 4096;
constexpr std::size_t kMostConnections = 8;
constexpr std::chrono::milliseconds kTick{50};

/// Lets each address call a few times at once, then once a second; says once a minute how many it refused.
class CallGuard {
 public:
  bool admits(const std::string& from, LinkClock::time_point now, const LinkLimits& limits) {
    if (callers_.size() > kMostCallers) callers_.clear();
    Caller& caller =
        callers_.try_emplace(from, Caller{static_cast<double>(limits.unproven), now}).first->second;
    const double passed_s = std::chrono::duration<double>(now - caller.then).count();
    caller.left = std::min(static_cast<double>(limits.unproven), caller.left + passed_s * limits.calls_1_s);
    caller.then = now;
    if (caller.left < 1.0) return false;
    caller.left -= 1.0;
    return true;
  }

  void refused(const std::string& from, const std::string& why, LinkClock::time_point now) {
    ++refused_;
    if (said_ && now - *said_ < std::chrono::minutes(1)) return;
    said_ = now;
    log::warn(refused_ == 1
                  ? fmt::format("link: a call from {} was refused: {}.", from, why)
                  : fmt::format("link: {} calls were refused, the newest from {}: {}.", refused_, from, why));
    refused_ = 0;
  }

 private:
  static constexpr std::size_t kMostCallers = 256;
  struct Caller {
    double left;
    LinkClock::time_point then;
  };
  std::map<std::string, Caller> callers_;
  std::size_t refused_ = 0;
  std::optional<LinkClock::time_point> said_;
};

}  // namespace

class LinkLine::Thread {
 public:
  Thread(const LinkAddress& address, const LinkKey& key, const LinkLimits& limits)
      : address_(address),
        limits_(limits),
        end_(address.listens, key),
        wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    std::signal(SIGPIPE, SIG_IGN);
    if (address.listens) listening_ = listenAt(address);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  ~Thread() {
    thread_.request_stop();
    wake();
  }
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  void wake() const {
    const std::uint64_t one = 1;
    if (write(*wake_, &one, sizeof one) < 0) return;  // it is awake already
  }

  // ------------------------------------------------------------ called by frames
  void take(std::vector<LineNews>& news) {
    const std::scoped_lock hold(shared_.mutex);
    std::move(shared_.news.begin(), shared_.news.end(), std::back_inserter(news));
    shared_.news.clear();
  }
  void give(std::uint64_t connection, const LinkMessage& message, bool isLast = false) {
    {
      const std::scoped_lock hold(shared_.mutex);
      if (!shared_.known.contains(connection)) return;  // it is over
      Outgoing& outgoing = shared_.outgoing[connection];
      append(message, outgoing.bytes);
      outgoing.isLast = outgoing.isLast || isLast;
    }
    wake();
  }
  void givePresent(std::uint64_t connection, const LinkPresent& present) {
    {
      const std::scoped_lock hold(shared_.mutex);
      if (!shared_.known.contains(connection)) return;
      Outgoing& outgoing = shared_.outgoing[connection];
      outgoing.present.clear();
      append(present, outgoing.present);
    }
    wake();
  }
  RoundTrip roundTrip(std::uint64_t connection) const {
    const std::scoped_lock hold(shared_.mutex);
    const auto found = shared_.known.find(connection);
    return found == shared_.known.end() ? RoundTrip{} : found->second.roundTrip;
  }
  LineTraffic traffic() const {
    const std::scoped_lock hold(shared_.mutex);
    LineTraffic all = shared_.past;
    for (const auto& [number, known] : shared_.known) {
      all.sentBytes += known.traffic.sentBytes;
      all.receivedBytes += known.traffic.receivedBytes;
    }
    return all;
  }
  std::uint16_t port() const { return listening_ ? portOf(listening_) : address_.port; }

 private:
  /// What frames have for a connection.
  struct Outgoing {
    std::vector<std::uint8_t> bytes, present;
    bool isLast = false;
  };
  /// What frames may know of one.
  struct Known {
    RoundTrip roundTrip;
    LineTraffic traffic;
  };

  void run(const std::stop_token& stop);
  void wait();
  void accept(LinkClock::time_point now);
  void call(LinkClock::time_point now);
  void failed(const std::string& why, LinkClock::time_point now);
  void serve(LineConnection& connection, LinkClock::time_point now);
  void moveOutgoing();
  void clearEnded(LinkClock::time_point now);
  void put(LineNews news);
  void open(int socket, std::string with, LinkClock::time_point now) {
    connections_.push_back(std::make_unique<LineConnection>(++newest_, end_, socket, std::move(with), now));
  }

  LinkAddress address_;
  LinkLimits limits_;
  TlsEnd end_;
  LinkSocket wake_, listening_;
  struct Calling {
    LinkSocket socket;
    LinkClock::time_point againAt{}, since{};
    std::size_t attempt = 0;
    std::string saidFailure;
  } calling_;
  CallGuard guard_;
  std::vector<std::unique_ptr<LineConnection>> connections_;
  std::uint64_t newest_ = 0;

  /// What both threads use, under the mutex.
  struct Shared {
    mutable std::mutex mutex;
    std::vector<LineNews> news;
    std::map<std::uint64_t, Outgoing> outgoing;
    std::map<std::uint64_t, Known> known;
    LineTraffic past;  ///< of connections that are over
  } shared_;

  std::jthread thread_;  // last, because it uses the rest
};

void LinkLine::Thread::put(LineNews news) {
  const std::scoped_lock hold(shared_.mutex);
  if (std::holds_alternative<LinkPresent>(news.message)) {
    std::erase_if(shared_.news, [&](const LineNews& older) {
      return older.connection == news.connection && std::holds_alternative<LinkPresent>(older.message);
    });
  }
  shared_.news.push_back(std::move(news));
}

void LinkLine::Thread::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    wait();
    const auto now = LinkClock::now();
    if (listening_) accept(now);
    if (!address_.listens) call(now);
    moveOutgoing();
    for (const auto& connection : connections_) serve(*connection, now);
    clearEnded(now);
  }
  moveOutgoing();
  for (const auto& connection : connections_) connection->write(limits_);
}

/// Waits until there is something to do, or for a tick.
void LinkLine::Thread::wait() {
  std::vector<pollfd> waits{{*wake_, POLLIN, 0}};
  if (listening_) waits.push_back({*listening_, POLLIN, 0});
  if (calling_.socket) waits.push_back({*calling_.socket, POLLOUT, 0});
  for (const auto& connection : connections_) {
    const bool writes = connection->isProven() && connection->wantsToWrite();
    waits.push_back({connection->socket(), static_cast<short>(writes ? POLLIN | POLLOUT : POLLIN), 0});
  }
  poll(waits.data(), waits.size(), static_cast<int>(kTick.count()));
  std::uint64_t woken = 0;
  if (read(*wake_, &woken, sizeof woken) < 0) return;  // it was something else
}

void LinkLine::Thread::accept(LinkClock::time_point now) {
  while (std::optional<Called> called = nextCaller(listening_)) {
    const auto unproven = std::count_if(connections_.begin(), connections_.end(),
                                        [](const auto& connection) { return !connection->isProven(); });
    const bool isFull =
        static_cast<std::size_t>(unproven) >= limits_.unproven || connections_.size() >= kMostConnections;
    if (isFull || !guard_.admits(called->from, now, limits_)) {
      guard_.refused(called->from, isFull ? "too many calls at once" : "it calls too often", now);
      continue;
    }
    open(called->socket.release(), called->from, now);
  }
}

void LinkLine::Thread::failed(const std::string& why, LinkClock::time_point now) {
  calling_.socket.reset();
  ++calling_.attempt;
  calling_.againAt = now + limits_.callAgain;
  if (why == calling_.saidFailure) return;
  calling_.saidFailure = why;
  log::note(fmt::format("link: {} does not answer: {}. It is called again.", address_.text(), why));
}

/// Calls the other room where there is no connection.
void LinkLine::Thread::call(LinkClock::time_point now) {
  if (!connections_.empty()) return;
  std::string why;
  if (!calling_.socket) {
    if (now < calling_.againAt) return;
    calling_.since = now;
    calling_.socket = callTo(address_, calling_.attempt, why);
    if (!calling_.socket) return failed(why, LinkClock::now());
  }
  const std::optional<bool> isThere = isAnswered(calling_.socket, why);
  if (!isThere && now - calling_.since > limits_.handshake) return failed("it is silent", now);
  if (!isThere) return;
  if (!*isThere) return failed(why, now);
  open(calling_.socket.release(), address_.text(), now);
}

void LinkLine::Thread::serve(LineConnection& connection, LinkClock::time_point now) {
  const bool isOpened = connection.read(now, [&](LinkMessage& message) {
    put({LineNews::Kind::message, connection.number(), now, std::move(message), {}});
  });
  if (isOpened) {
    calling_.saidFailure.clear();
    {
      const std::scoped_lock hold(shared_.mutex);
      shared_.known[connection.number()];
    }
    put({LineNews::Kind::opened, connection.number(), now, {}, connection.with()});
  }
  if (!connection.isOver()) connection.look(now, limits_, !address_.listens);
  connection.write(limits_);
  const std::scoped_lock hold(shared_.mutex);
  if (const auto found = shared_.known.find(connection.number()); found != shared_.known.end())
    found->second = {connection.roundTrip(), connection.traffic()};
  if (shared_.news.size() > kMostNews) connection.end("it sent more than is taken here");
}

void LinkLine::Thread::moveOutgoing() {
  const std::scoped_lock hold(shared_.mutex);
  for (const auto& connection : connections_) {
    const auto found = shared_.outgoing.find(connection->number());
    if (found == shared_.outgoing.end()) continue;
    Outgoing& outgoing = found->second;
    connection->add(outgoing.bytes, limits_);
    outgoing.bytes.clear();
    if (!outgoing.present.empty()) connection->setPresent(outgoing.present);
    outgoing.present.clear();
    if (outgoing.isLast) connection->closeAfter();
  }
}

void LinkLine::Thread::clearEnded(LinkClock::time_point now) {
  for (const auto& connection : connections_) {
    if (!connection->isOver()) continue;
    if (connection->isProven()) {
      put({LineNews::Kind::closed, connection->number(), now, {}, connection->ended()});
    } else if (address_.listens) {
      guard_.refused(connection->with(), connection->ended(), now);
    } else {
      failed(connection->ended(), now);
    }
    calling_.againAt = std::max(calling_.againAt,
                                now + (connection->isProven() ? limits_.callAgain / 4 : limits_.callAgain));
    const std::scoped_lock hold(shared_.mutex);
    shared_.outgoing.erase(connection->number());
    shared_.past.sentBytes += connection->traffic().sentBytes;
    shared_.past.receivedBytes += connection->traffic().receivedBytes;
    shared_.known.erase(connection->number());
  }
  std::erase_if(connections_, [](const auto& connection) { return connection->isOver(); });
}

LinkLine::LinkLine(const LinkAddress& address, const LinkKey& key, const LinkLimits& limits)
    : thread_(std::make_unique<Thread>(address, key, limits)) {}
LinkLine::~LinkLine() = default;

void LinkLine::take(std::vector<LineNews>& news) { thread_->take(news); }
void LinkLine::send(std::uint64_t connection, const LinkMessage& message) {
  thread_->give(connection, message);
}
void LinkLine::present(std::uint64_t connection, const LinkPresent& present) {
  thread_->givePresent(connection, present);
}
void LinkLine::close(std::uint64_t connection, const std::string& reason) {
  constexpr bool kIsLast = true;
  thread_->give(connection, LinkBye{reason}, kIsLast);
}
RoundTrip LinkLine::roundTrip(std::uint64_t connection) const { return thread_->roundTrip(connection); }
LineTraffic LinkLine::traffic() const { return thread_->traffic(); }
std::uint16_t LinkLine::port() const { return thread_->port(); }

}  // namespace carom
