#pragma once
// The thread of a class's server (app/class_server/class_server.h) and its connections, with Beast.

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "app/class_server/class_pages.h"
#include "app/class_server/class_server_options.h"
#include "app/class_server/mailbox.h"
#include "app/classroom/classroom.h"
#include "app/classroom/take_codes.h"

namespace carom {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using beast::error_code;
using SteadyClock = std::chrono::steady_clock;
using Id = Classroom::Id;

inline double secondsOf(SteadyClock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// How many messages a phone may still send: as many as the time since then allows, up to a burst.
class Allowance {
 public:
  explicit Allowance(const ClassLimits& limits) : limits_(limits), left_(limits.burst) {}

  /// Takes one message; returns whether it was allowed.
  bool take(double now_s) {
    left_ = std::min(limits_.burst, left_ + (now_s - then_s_) * limits_.messages_1_s);
    then_s_ = now_s;
    left_ -= 1.0;
    return left_ >= 0.0;
  }

 private:
  const ClassLimits& limits_;
  double left_, then_s_ = secondsOf(SteadyClock::now());
};

constexpr std::size_t kMostWishes = 64, kMostVotes = 4 * Classroom::kMostPhones, kMostViews = 16;

/// All of it that runs in the thread.
class ClassHost {
 public:
  ClassHost(const ClassServerOptions& options, const std::optional<ClassLeft>& left);
  ~ClassHost();
  ClassHost(const ClassHost&) = delete;
  ClassHost& operator=(const ClassHost&) = delete;

  class Connection;
  void begin();
  asio::io_context& io() { return io_; }
  Classroom& room() { return room_; }
  const ClassLimits& limits() const { return options_.limits; }
  const ClassPages& pages() const { return pages_; }
  const ClassServerOptions& options() const { return options_; }

  /// Returns whether a request names this server, and comes from one of its own pages if it says from where.
  bool isOurs(beast::string_view host) const {
    return std::find(hosts_.begin(), hosts_.end(), host) != hosts_.end();
  }
  bool isOurPage(beast::string_view origin) const {
    return origin.empty() || (origin.starts_with("http://") && isOurs(origin.substr(7)));
  }

  void received(Connection& from, const std::optional<PhoneMessage>& message);
  void ended(Id id);
  /// Hands on what the class has decided, and tells everybody when it has come to another phase.
  void settle();

  /// Keeps a page and offers it on the walls for a while.
  void offer(const std::string& code, std::string page);
  TakeCodes& codes() { return codes_; }
  /// Returns all that is known of the game.
  std::shared_ptr<const std::string> whole();

  /// What the class has for the frames.
  struct Outbox {
    Mailbox<LessonWish> wishes{kMostWishes};
    Mailbox<ClassVote> votes{kMostVotes};
    Mailbox<ClassView> views{kMostViews};
  };
  Outbox& outbox() { return outbox_; }

 private:
  void accept();
  void admit(tcp::socket&& socket);
  bool makeRoom();
  void tick();
  void tellAll();
  void tellFollowers();
  ClassView view() const;

  ClassServerOptions options_;
  Outbox outbox_;
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  struct Timers {
    asio::steady_timer ticks, retry, news;
  };
  Timers timers_{asio::steady_timer(io_), asio::steady_timer(io_), asio::steady_timer(io_)};
  ClassPages pages_;
  std::vector<std::string> hosts_;
  Classroom room_;
  std::map<Id, std::shared_ptr<Connection>> connections_;
  Id newest_ = 0;
  struct Shown {
    ClassView view;
    int ticksAgo = 0;
  };
  Shown shown_;  ///< as it was last handed on
  TakeCodes codes_;
  std::shared_ptr<const std::string> whole_;  ///< as of the last news; null: not asked for since
  std::jthread thread_;
};

/// One connection: a request, and a WebSocket if it asks for that.
class ClassHost::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(ClassHost& host, Id id, tcp::socket&& socket, const std::string& from)
      : address(from), host_(host), id_(id), stream_(std::move(socket)), allowance_(host.limits()) {
    host_.room().connect(id, from);
  }

  Id id() const { return id_; }
  /// Returns whether it has not said who it is, and since when it has said nothing.
  bool isNobody() const { return !isFollower_ && !host_.room().isIn(id_); }
  bool isFollower() const { return isFollower_ && isOpen_; }
  SteadyClock::time_point heard() const { return heard_; }

  void begin();
  /// Tells it how things stand now; if the last telling is still under way, afterwards.
  void tell();
  /// Sends a follower the news; if it has not read the last ones yet, all that is known when it has.
  void follow(const std::shared_ptr<const std::string>& news);
  /// Ends it without a word.
  void drop();

  const std::string address;

 private:
  void answer();
  bool answerPages(beast::string_view path);
  void answerStudy(beast::string_view target, beast::string_view path);
  void respond(http::status status, const char* type = "text/plain", const std::string& body = "");
  void respondPage(const std::string& page);
  void say(http::status status, const char* words);
  void openSocket();
  void send();
  void read();
  void take(std::size_t bytes);
  void close(websocket::close_code why);
  void end() {
    isOpen_ = false;
    host_.ended(id_);
  }

  ClassHost& host_;
  Id id_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{2 * 8192};
  std::optional<http::request_parser<http::string_body>> parser_;
  http::response<http::string_body> response_;
  std::optional<websocket::stream<beast::tcp_stream>> socket_;
  Allowance allowance_;
  SteadyClock::time_point heard_ = SteadyClock::now();
  std::string told_;
  bool isOpen_ = false, isTelling_ = false, tellsAgain_ = false;
  bool isFollower_ = false, hasGap_ = true;                ///< it has not been sent all
  std::deque<std::shared_ptr<const std::string>> unsent_;  ///< to a follower; the first is under way
};

}  // namespace carom
