#include "app/classroom/class_server.h"

#include <sys/random.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "app/classroom/class_pages.h"
#include "app/study/form_fields.h"
#include "engine/base/log.h"

namespace carom {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using beast::error_code;
using SteadyClock = std::chrono::steady_clock;
using Id = Classroom::Id;

constexpr std::chrono::milliseconds kTick{100}, kRetry{1000};
constexpr int kTicksBetweenCounts = 5;  // while a vote is open, phones hear of its count twice a second
constexpr int kNice = 10;               // frames come first
constexpr std::size_t kMostWishes = 64, kMostVotes = 4 * Classroom::kMostPhones, kMostViews = 16;

/// The page may load and reach what this server has, nothing else, and no other page may frame it.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data:; "
    "frame-ancestors 'none'; base-uri 'none'";

/// Returns 128 bits from the operating system, as hexadecimal digits.
std::string newToken() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the operating system gave no random numbers");
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

double secondsOf(SteadyClock::time_point time) {
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

}  // namespace

/// All of it that runs in the thread.
class ClassServer::Host {
 public:
  Host(const ClassServerOptions& options, const std::optional<ClassLeft>& left);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

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

  ClassServerOptions options_;
  Outbox outbox_;
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  asio::steady_timer ticks_{io_}, retry_{io_};
  ClassPages pages_;
  std::vector<std::string> hosts_;
  Classroom room_;
  std::map<Id, std::shared_ptr<Connection>> connections_;
  Id newest_ = 0;
  int sinceCount_ = 0;
  ClassView shown_;  ///< as it was last handed on
  std::jthread thread_;
};

/// One connection: a request, and a WebSocket if it asks for that.
class ClassServer::Host::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Host& host, Id id, tcp::socket&& socket, const std::string& from)
      : address(from), host_(host), id_(id), stream_(std::move(socket)), allowance_(host.limits()) {
    host_.room().connect(id, from);
  }

  Id id() const { return id_; }
  /// Returns whether it has not said who it is, and since when it has said nothing.
  bool isNobody() const { return !host_.room().isIn(id_); }
  SteadyClock::time_point heard() const { return heard_; }

  void begin() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(host_.limits().requestBytes));
    parser_->body_limit(host_.options().studyPage ? kMostFormBytes : 0);
    stream_.expires_after(host_.limits().request);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](error_code failed, std::size_t) {
      failed ? self->end() : self->answer();
    });
  }

  /// Tells it how things stand now; if the last telling is still under way, afterwards.
  void tell() {
    if (!socket_ || !isOpen_) return;
    if (isTelling_) {
      tellsAgain_ = true;
      return;
    }
    isTelling_ = true;
    tellsAgain_ = false;
    told_ = host_.room().messageFor(id_);
    socket_->text(true);
    socket_->async_write(asio::buffer(told_), [self = shared_from_this()](error_code failed, std::size_t) {
      self->isTelling_ = false;
      if (failed) return self->end();
      if (self->tellsAgain_) self->tell();
    });
  }

  /// Ends it without a word.
  void drop() {
    error_code ignored;
    (socket_ ? beast::get_lowest_layer(*socket_) : stream_).socket().close(ignored);
    end();
  }

  const std::string address;

 private:
  void answer();
  void answerStudy(beast::string_view target, beast::string_view path);
  void respond(http::status status, const char* type = "text/plain", const std::string& body = "");
  void openSocket();
  void read();
  void take(std::size_t bytes);
  void close(websocket::close_code why);
  void end() {
    isOpen_ = false;
    host_.ended(id_);
  }

  Host& host_;
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
};

void ClassServer::Host::Connection::answer() {
  const auto& request = parser_->get();
  const beast::string_view target = request.target(), path = target.substr(0, target.find('?'));
  if (!host_.isOurs(request[http::field::host])) return respond(http::status::misdirected_request);
  if (host_.options().studyPage) return answerStudy(target, path);
  if (path == "/socket") {
    if (!websocket::is_upgrade(request)) return respond(http::status::upgrade_required);
    return host_.isOurPage(request[http::field::origin]) ? openSocket() : respond(http::status::forbidden);
  }
  const ClassPages& pages = host_.pages();
  if (request.method() != http::verb::get) return respond(http::status::method_not_allowed);
  if (path == "/" || path == "/teacher")
    return respond(http::status::ok, "text/html; charset=utf-8", pages.page);
  if (path == "/class.css") return respond(http::status::ok, "text/css; charset=utf-8", pages.style);
  if (path == "/class.js") return respond(http::status::ok, "text/javascript; charset=utf-8", pages.script);
  respond(http::status::not_found);
}

/// Answers a request for a page of a study: by itself, or with a form that one of its own pages sends.
void ClassServer::Host::Connection::answerStudy(beast::string_view target, beast::string_view path) {
  const auto& request = parser_->get();
  const bool isForm = request.method() == http::verb::post;
  if (!isForm && request.method() != http::verb::get) return respond(http::status::method_not_allowed);
  if (isForm && (path != "/study" || !host_.isOurPage(request[http::field::origin])))
    return respond(http::status::forbidden);
  if (path == "/study.css")
    return respond(http::status::ok, "text/css; charset=utf-8", host_.options().studyStyle);
  if (path != "/" && path != "/study") return respond(http::status::not_found);
  if (isForm) {  // the page that follows is asked for by itself: going back or reloading sends nothing again
    response_.set(http::field::location, host_.options().studyForm(request.body()));
    return respond(http::status::see_other);
  }
  const beast::string_view query = target.substr(std::min(path.size() + 1, target.size()));
  respond(http::status::ok, "text/html; charset=utf-8",
          host_.options().studyPage({query.data(), query.size()}));
}

void ClassServer::Host::Connection::respond(http::status status, const char* type, const std::string& body) {
  response_.result(status);
  response_.set(http::field::content_type, type);
  response_.set(http::field::cache_control, "no-store");
  response_.set("Content-Security-Policy", kPolicy);
  response_.set("X-Content-Type-Options", "nosniff");
  // Under "no-referrer" a browser sends a form of ours with the origin "null", which isOurPage refuses.
  response_.set("Referrer-Policy", "same-origin");
  response_.keep_alive(false);
  response_.body() = body;
  response_.prepare_payload();
  stream_.expires_after(host_.limits().request);
  http::async_write(stream_, response_, [self = shared_from_this()](error_code, std::size_t) {
    error_code ignored;
    self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    self->end();
  });
}

void ClassServer::Host::Connection::openSocket() {
  stream_.expires_never();  // the WebSocket has times of its own
  socket_.emplace(std::move(stream_));
  socket_->set_option(websocket::stream_base::timeout{host_.limits().request, host_.limits().silence, true});
  socket_->read_message_max(kMostMessageBytes);
  socket_->async_accept(parser_->get(), [self = shared_from_this()](error_code failed) {
    if (failed) return self->end();
    self->isOpen_ = true;
    self->heard_ = SteadyClock::now();
    self->buffer_.clear();
    self->read();
  });
}

void ClassServer::Host::Connection::read() {
  socket_->async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t bytes) {
    failed ? self->end() : self->take(bytes);
  });
}

/// Takes a message of this size.
void ClassServer::Host::Connection::take(std::size_t bytes) {
  heard_ = SteadyClock::now();
  if (!allowance_.take(secondsOf(heard_))) return drop();  // who floods would not hear why
  if (!socket_->got_text()) return close(websocket::close_code::unknown_data);
  const std::string_view words(static_cast<const char*>(buffer_.data().data()), bytes);
  host_.received(*this, phoneMessageOf(words));
  buffer_.consume(buffer_.size());
  read();
}

void ClassServer::Host::Connection::close(websocket::close_code why) {
  isOpen_ = false;
  socket_->async_close(why, [self = shared_from_this()](error_code) { self->end(); });
}

ClassServer::Host::Host(const ClassServerOptions& options, const std::optional<ClassLeft>& left)
    : options_(options), room_({"", options.word, options.pin}, newToken) {
  error_code failed;
  const asio::ip::address address = asio::ip::make_address(options.address, failed);
  if (failed)
    throw std::runtime_error(fmt::format(
        "class: '{}' is no address, expected one in numbers: --class-address 192.168.1.20", options.address));
  tcp::endpoint at(address, options.port);
  acceptor_.open(at.protocol(), failed);
  if (!failed) acceptor_.set_option(asio::socket_base::reuse_address(true), failed);
  if (!failed) acceptor_.bind(at, failed);
  if (!failed) acceptor_.listen(asio::socket_base::max_listen_connections, failed);
  if (failed == asio::error::address_in_use)
    throw std::runtime_error(
        fmt::format("class: port {} of {} is taken by another program, expected a free one: --class-port",
                    options.port, options.address));
  if (failed)
    throw std::runtime_error(
        fmt::format("class: port {} of {}: {}, expected an address of this computer: --class-address",
                    options.port, options.address, failed.message()));
  at = acceptor_.local_endpoint();
  const std::string host = address.is_v6() ? "[" + address.to_string() + "]" : address.to_string();
  hosts_.push_back(fmt::format("{}:{}", host, at.port()));
  if (at.port() == 80) hosts_.push_back(host);
  if (address.is_loopback()) hosts_.push_back(fmt::format("localhost:{}", at.port()));
  room_.invite(fmt::format("http://{}/", hosts_.front()));
  pages_ = classPages(options.word);
  if (left) room_.resume(*left);
}

void ClassServer::Host::begin() {
  accept();
  tick();
  settle();
  thread_ = std::jthread([this] {
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
    for (;;) try {
        io_.run();
        return;
      } catch (const std::exception& error) {
        log::warn(fmt::format("class: {}", error.what()));
      }
  });
}

ClassServer::Host::~Host() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
  connections_.clear();
}

void ClassServer::Host::accept() {
  acceptor_.async_accept([this](error_code failed, tcp::socket socket) {
    if (failed == asio::error::operation_aborted) return;
    if (!failed) {
      admit(std::move(socket));
      return accept();
    }
    retry_.expires_after(kRetry);  // too many files, or the network is gone
    retry_.async_wait([this](error_code) { accept(); });
  });
}

/// Lets a connection in, unless there are too many.
void ClassServer::Host::admit(tcp::socket&& socket) {
  error_code failed;
  const tcp::endpoint from = socket.remote_endpoint(failed);
  if (failed) return;
  const std::string address = from.address().to_string();
  const auto ofAddress = std::count_if(connections_.begin(), connections_.end(),
                                       [&](const auto& one) { return one.second->address == address; });
  if (static_cast<std::size_t>(ofAddress) >= options_.limits.socketsOfAddress) return;
  if (connections_.size() >= options_.limits.sockets && !makeRoom()) return;
  socket.set_option(tcp::no_delay(true), failed);
  const Id id = ++newest_;
  const auto connection = std::make_shared<Connection>(*this, id, std::move(socket), address);
  connections_.emplace(id, connection);
  connection->begin();
}

/// Drops the oldest connection that has not said who it is. Returns whether there was one.
bool ClassServer::Host::makeRoom() {
  const auto nobody = std::find_if(connections_.begin(), connections_.end(),
                                   [](const auto& one) { return one.second->isNobody(); });
  if (nobody == connections_.end()) return false;
  const std::shared_ptr<Connection> dropped = nobody->second;
  dropped->drop();
  return true;
}

void ClassServer::Host::received(Connection& from, const std::optional<PhoneMessage>& message) {
  if (message) {
    room_.receive(from.id(), *message, secondsOf(SteadyClock::now()));
  } else {
    room_.refuseMessage(from.id());
  }
  from.tell();
  settle();
}

void ClassServer::Host::ended(Id id) {
  if (connections_.erase(id) > 0) room_.leave(id);
}

void ClassServer::Host::settle() {
  for (const LessonWish wish : room_.takeWishes()) outbox_.wishes.put(wish);
  for (ClassVote& vote : room_.takeVotes()) outbox_.votes.put(std::move(vote));
  const ClassView view = room_.view();
  if (view.phase != shown_.phase || view.round != shown_.round) tellAll();
}

/// Every tenth of a second: ends what has said nothing for too long, and tells the news of phones and votes.
void ClassServer::Host::tick() {
  const auto latest = SteadyClock::now() - options_.limits.request;
  std::vector<std::shared_ptr<Connection>> late;
  for (const auto& [id, connection] : connections_) {
    if (connection->isNobody() && connection->heard() < latest) late.push_back(connection);
  }
  for (const auto& connection : late) connection->drop();
  if (++sinceCount_ >= kTicksBetweenCounts && room_.takeChange()) tellAll();
  ticks_.expires_after(kTick);
  ticks_.async_wait([this](error_code failed) {
    if (!failed) tick();
  });
}

/// Tells all how things stand: the walls, the teacher, then the phones.
void ClassServer::Host::tellAll() {
  sinceCount_ = 0;
  room_.takeChange();
  shown_ = room_.view();
  outbox_.views.put(shown_);
  for (const bool teacher : {true, false}) {
    for (const auto& [id, connection] : connections_) {
      if (room_.isIn(id) && room_.isTeacher(id) == teacher) connection->tell();
    }
  }
}

ClassServer::ClassServer(const ClassServerOptions& options, const std::optional<ClassLeft>& left)
    : host_(std::make_unique<Host>(options, left)) {
  host_->begin();
}

ClassServer::~ClassServer() = default;

const ClassInvitation& ClassServer::invitation() const { return host_->room().invitation(); }

void ClassServer::tell(LessonNews news) {
  asio::post(host_->io(), [host = host_.get(), news = std::move(news)] {
    host->room().follow(news, secondsOf(SteadyClock::now()));
    host->settle();
  });
}

void ClassServer::ask(ClassStep step) {
  asio::post(host_->io(), [host = host_.get(), step] {
    host->room().take(step, secondsOf(SteadyClock::now()));
    host->settle();
  });
}

Mailbox<LessonWish>& ClassServer::wishes() { return host_->outbox().wishes; }
Mailbox<ClassVote>& ClassServer::votes() { return host_->outbox().votes; }
Mailbox<ClassView>& ClassServer::views() { return host_->outbox().views; }

}  // namespace carom
