#include "app/class_server/class_host.h"

#include <sys/random.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "engine/text/log.h"

namespace carom {
namespace {

constexpr std::chrono::milliseconds kTick{100}, kRetry{1000};
constexpr int kTicksBetweenCounts = 5;  // while a vote is open, phones hear of its count twice a second
constexpr std::chrono::milliseconds kNews{50};  // followers hear of the game twenty times a second
constexpr int kNice = 10;                       // frames come first

/// Returns 128 bits from the operating system, as hexadecimal digits.
std::string newToken() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the operating system gave no random numbers");
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

}  // namespace

ClassHost::ClassHost(const ClassServerOptions& options, const std::optional<ClassLeft>& left)
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
  pages_ = classPages(options.word, options.followed.has_value());
  if (left) room_.resume(*left);
}

void ClassHost::begin() {
  accept();
  tick();
  settle();
  if (options_.followed) tellFollowers();
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

ClassHost::~ClassHost() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
  connections_.clear();
}

void ClassHost::accept() {
  acceptor_.async_accept([this](error_code failed, tcp::socket socket) {
    if (failed == asio::error::operation_aborted) return;
    if (!failed) {
      admit(std::move(socket));
      return accept();
    }
    timers_.retry.expires_after(kRetry);  // too many files, or the network is gone
    timers_.retry.async_wait([this](error_code) { accept(); });
  });
}

/// Lets a connection in, unless there are too many.
void ClassHost::admit(tcp::socket&& socket) {
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
bool ClassHost::makeRoom() {
  const auto nobody = std::find_if(connections_.begin(), connections_.end(),
                                   [](const auto& one) { return one.second->isNobody(); });
  if (nobody == connections_.end()) return false;
  const std::shared_ptr<Connection> dropped = nobody->second;
  dropped->drop();
  return true;
}

void ClassHost::received(Connection& from, const std::optional<PhoneMessage>& message) {
  if (message) {
    room_.receive(from.id(), *message, secondsOf(SteadyClock::now()));
  } else {
    room_.refuseMessage(from.id());
  }
  from.tell();
  settle();
}

void ClassHost::ended(Id id) {
  if (connections_.erase(id) > 0) room_.leave(id);
}

void ClassHost::settle() {
  for (const LessonWish wish : room_.takeWishes()) outbox_.wishes.put(wish);
  for (ClassVote& vote : room_.takeVotes()) outbox_.votes.put(std::move(vote));
  const ClassView view = this->view();
  if (view.phase != shown_.view.phase || view.round != shown_.view.round) tellAll();
}

/// Every tenth of a second: ends what has said nothing for too long, and tells the news of phones and votes.
void ClassHost::tick() {
  const auto latest = SteadyClock::now() - options_.limits.request;
  std::vector<std::shared_ptr<Connection>> late;
  for (const auto& [id, connection] : connections_) {
    if (connection->isNobody() && connection->heard() < latest) late.push_back(connection);
  }
  for (const auto& connection : late) connection->drop();
  if (++shown_.ticksAgo >= kTicksBetweenCounts &&
      (room_.takeChange() || view().address != shown_.view.address))
    tellAll();
  timers_.ticks.expires_after(kTick);
  timers_.ticks.async_wait([this](error_code failed) {
    if (!failed) tick();
  });
}

/// Tells all how things stand: the walls, the teacher, then the phones.
void ClassHost::tellAll() {
  shown_.ticksAgo = 0;
  room_.takeChange();
  shown_.view = view();
  outbox_.views.put(shown_.view);
  for (const bool teacher : {true, false}) {
    for (const auto& [id, connection] : connections_) {
      if (room_.isIn(id) && room_.isTeacher(id) == teacher) connection->tell();
    }
  }
}

/// Returns how things stand for the walls. These have one code at a time: between votes it is that of the
/// newest page to take home.
ClassView ClassHost::view() const {
  ClassView view = room_.view();
  const std::string code = codes_.offered(secondsOf(SteadyClock::now()));
  if (code.empty() || view.phase != ClassPhase::idle) return view;
  view.address = ShortText<120>(fmt::format("{}take/{}", room_.invitation().address, code));
  view.word = {};
  return view;
}

void ClassHost::offer(const std::string& code, std::string page) {
  codes_.keep(code, std::move(page), secondsOf(SteadyClock::now()));
  tellAll();
}

std::shared_ptr<const std::string> ClassHost::whole() {
  if (!whole_) whole_ = std::make_shared<const std::string>(options_.followed->whole());
  return whole_;
}

/// Tells the news to the phones that follow the game.
void ClassHost::tellFollowers() {
  const auto news = std::make_shared<const std::string>(options_.followed->more());
  if (!news->empty()) {
    whole_.reset();
    for (const auto& [id, connection] : connections_)
      if (connection->isFollower()) connection->follow(news);
  }
  timers_.news.expires_after(kNews);
  timers_.news.async_wait([this](error_code failed) {
    if (!failed) tellFollowers();
  });
}

}  // namespace carom
