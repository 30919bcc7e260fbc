// What a room of a linked game does with news from the line: joining, presents, strokes, and the end.
#include <sys/random.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/link/linked_play.h"
#include "app/link/stroke_check.h"

namespace carom {
namespace {

/// Returns a number for a game that no other game has.
std::uint64_t anyNumber() {
  std::uint64_t number = 0;
  while (number == 0) {
    if (getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number))
      throw std::runtime_error("the operating system gave no random numbers");
  }
  return number;
}

constexpr const char* kPlaysAlone = "its operator plays alone";
constexpr double kMostAside_s = 3600.0;  // between the times of two rooms
constexpr double kFreezes_s = 60.0;      // for all rooms at most
constexpr int kMostStood = 3;            // times in a game that a room may stand still for too long

}  // namespace

void LinkedPlay::hear(LinkClock::time_point now) {
  heard_.clear();
  news_.clear();
  now_ = now;
  line_->take(news_);
  for (const LineNews& news : news_) {
    if (!staysOut_)
      hear(news);
    else if (news.kind == LineNews::Kind::opened)
      line_->close(news.connection, kPlaysAlone);
  }
  if (staysOut_ && state_ != LinkState::alone) part("gone", kPlaysAlone);
  lookWhetherGone(now);
  if (connection_) lastRoundTrip_ = line_->roundTrip(connection_);
}

void LinkedPlay::hear(const LineNews& news) {
  if (news.kind == LineNews::Kind::opened) return sayHello(news.connection);
  if (news.kind == LineNews::Kind::closed) {
    if (news.connection != connection_) return;
    connection_ = 0;
    if (state_ != LinkState::playing) {
      state_ = LinkState::alone;
      other_.reset();
      isInvited_ = false;
    }
    heard_.notes.push_back({"broken", news.words});
    return;
  }
  if (const auto* hello = std::get_if<LinkHello>(&news.message)) return hear(*hello, news);
  if (news.connection != connection_) return;  // of one that is not let in, or no more
  std::visit(
      [&](const auto& message) {
        using Message = std::decay_t<decltype(message)>;
        if constexpr (std::is_same_v<Message, LinkPresent>) {
          hear(message, news.at);
        } else if constexpr (std::is_same_v<Message, LinkAccept>) {
          if (joins_ && own_ && !isAccepted_) {
            isAccepted_ = true;
            paired();
          }
        } else if constexpr (std::is_same_v<Message, LinkBye>) {
          part(state_ == LinkState::playing ? "gone" : "refused", message.reason);
        } else if constexpr (std::is_same_v<Message, LinkWelcome> || std::is_same_v<Message, LinkReady> ||
                             std::is_same_v<Message, LinkStroke> || std::is_same_v<Message, LinkDigest> ||
                             std::is_same_v<Message, LinkSettings> || std::is_same_v<Message, LinkTurns>) {
          hear(message);
        }
      },
      news.message);
}

// ---------------------------------------------------------------- joining
void LinkedPlay::sayHello(std::uint64_t connection) {
  LinkHello hello;
  hello.arithmetic = arithmetic_;
  hello.program = self_.program;
  hello.room = self_.room;
  hello.viewers = self_.viewers;
  hello.floor = self_.floor;
  if (state_ == LinkState::playing && other_) {
    hello.game = number_;
    hello.heard = other_->strokes();
  }
  line_->send(connection, hello);
}

/// Returns why a room may not play with this one; empty if it may.
std::string LinkedPlay::refusalOf(const LinkHello& hello) const {
  if (hello.arithmetic != arithmetic_)
    return fmt::format("the arithmetic differs: {} ({:016x}) here, {} ({:016x}) there", self_.program,
                       arithmetic_, hello.program, hello.arithmetic);
  if (hello.room == self_.room) return fmt::format("both rooms are named {}", hello.room);
  if (hello.viewers.empty()) return "it has no viewers";
  if (banned_.contains(hello.room)) return "it broke a promise, or stood still too often, in this game";
  if (self_.hosts && !game_.whyNot.empty()) return game_.whyNot;
  const bool isBack = state_ == LinkState::playing && hello.game == number_ && hello.room == otherName_;
  const bool isThere = connection_ != 0 && std::chrono::duration<double>(now_ - presentAt_).count() < 2.0;
  if (state_ == LinkState::alone || isBack) return {};
  if (hello.room == otherName_)
    return isThere ? fmt::format("a room named {} plays already", hello.room) : "";
  return "two rooms play already";
}

void LinkedPlay::hear(const LinkHello& hello, const LineNews& news) {
  if (connection_ && news.connection == connection_) return;  // told again
  const std::string refusal = refusalOf(hello);
  if (!refusal.empty()) {
    heard_.notes.push_back({"refused", fmt::format("{}: {}", hello.room, refusal)});
    return line_->close(news.connection, refusal);
  }
  const bool isBack = state_ == LinkState::playing && hello.game == number_ && hello.room == otherName_;
  if (isBack) return goOn(news.connection, hello.heard);
  if (state_ == LinkState::playing) part("gone", "it begins anew");
  adopt(news.connection, hello);
}

/// Lets a room in, as the host, or joins one.
void LinkedPlay::adopt(std::uint64_t connection, const LinkHello& hello) {
  if (connection_ && connection_ != connection) line_->close(connection_, "another line is used");
  connection_ = connection;
  otherName_ = hello.room;
  otherViewers_ = hello.viewers;
  otherFloor_ = hello.floor;
  state_ = LinkState::joining;
  isInvited_ = false;
  invitedTo_ = 0;
  other_.reset();
  presentAt_ = movedAt_ = now_;
}

/// Goes on with the game on another line: tells all strokes that the other room has not heard.
void LinkedPlay::goOn(std::uint64_t connection, std::uint32_t heard) {
  if (connection_ && connection_ != connection) line_->close(connection_, "another line is used");
  connection_ = connection;
  presentAt_ = now_;
  for (const LinkStroke& stroke : game_.strokes) {
    if (stroke.room == room_ && stroke.told.number >= heard) line_->send(connection, stroke);
  }
  line_->present(connection, told_);
  heard_.notes.push_back({"back", otherName_});
}

/// Invites the room that is there to this game, once the line has been measured.
void LinkedPlay::invite(LinkClock::time_point now) {
  constexpr std::size_t kPings = 10;
  const RoundTrip round = line_->roundTrip(connection_);
  if (round.count < kPings) return;
  isInvited_ = true;
  number_ = anyNumber();
  LinkWelcome welcome;
  welcome.game = number_;
  const Floor floors[] = {self_.floor, otherFloor_};
  const double wanted_m = distanceFor_m(round.p99_s, game_.billiard.lightSpeed_m_s);
  // The host stands where it is: the one who joins stands farther out by both shares.
  if (!self_.apart_m) apart_m_ = 2.0 * apartFor_m(game_.start, floors, wanted_m);
  welcome.apart_m = apart_m_;
  welcome.lightSpeedShown_m_s = settings_.lightSpeedShown_m_s;
  welcome.board_s = told_.present.persons[0].head.t_s;
  welcome.scenario = game_.scenario;
  welcome.meshes = game_.meshes;
  welcome.strokes = game_.strokes;
  line_->send(connection_, welcome);
  line_->present(connection_, told_);
  presentAt_ = movedAt_ = now;
  heard_.notes.push_back({"apart", fmt::format("{:.3f} m", apart_m_)});
}

void LinkedPlay::hear(const LinkWelcome& welcome) {
  if (self_.hosts) return part("refused", "it invites its host");
  if (std::exchange(invitedTo_, welcome.game) == welcome.game) return;  // told again
  if (differs_ || turnsThere_)
    heard_.notes.push_back(
        {"resynchronised",
         fmt::format("at {} s from {}", differs_.value_or(turnsThere_ ? turnsThere_->second : 0),
                     otherName_)});
  invitation_ = welcome;
  isWaiting_ = true;
  first_.reset();
  other_.reset();
  early_.clear();
  own_.reset();
  isAccepted_ = false;
  joins_ = true;
  state_ = LinkState::joining;
}

/// Knows the other room from its first present on.
void LinkedPlay::meets(const LinkPresent& first, LinkClock::time_point at) {
  other_.emplace(first.present, game_.billiard.lightSpeed_m_s);
  presentAt_ = movedAt_ = at;
  newest_s_ = first.present.persons[0].head.t_s;
}

void LinkedPlay::hear(const LinkReady& ready) {
  if (joins_ || !isInvited_ || !own_ || other_) return;
  const OtherRoom other(ready.first.present, game_.billiard.lightSpeed_m_s);
  const bool isAllowed = std::ranges::all_of(eyes_, [&](const Event& eye) { return other.allows(eye); });
  if (!isAllowed || ready.first.present.size != otherViewers_.size())
    return part("refused", "it came too late");
  meets(ready.first, now_);
  line_->send(connection_, LinkAccept{room_});
  if (settings_.lightSpeedShown_m_s > 0.0) line_->send(connection_, settings_);
  paired();
}

void LinkedPlay::paired() {
  state_ = LinkState::playing;
  const double error_s = 0.5 * line_->roundTrip(connection_).least_s;
  heard_.notes.push_back(
      {"paired", fmt::format("game {:016x} with {} to ± {:.0f} ms", number_, otherName_, 1e3 * error_s)});
}

// ---------------------------------------------------------------- the other's news
void LinkedPlay::hear(const LinkPresent& message, LinkClock::time_point at) {
  if (isWaiting_) {
    if (!first_) {
      first_ = message;
      presentAt_ = at;
    }
    return;
  }
  if (message.room != otherNumber()) return;
  if (!other_) {
    if (!joins_) return;  // the host meets those who join when they are ready
    return meets(message, at);
  }
  if (other_->hear(message.present) == Judgement::broken) {
    banned_.insert(otherName_);
    return part("refused", other_->broken());
  }
  const double moment_s = message.present.persons[0].head.t_s;
  if (own_ && std::abs(moment_s - own_->present().persons[0].head.t_s) > kMostAside_s)
    return part("refused", fmt::format("its time is {:.0f} s, expected within an hour of {:.0f} s here",
                                       moment_s, own_->present().persons[0].head.t_s));
  presentAt_ = at;
  if (moment_s > newest_s_) movedAt_ = at;
  newest_s_ = std::max(newest_s_, moment_s);
  heard_.presents.push_back(message);
}

void LinkedPlay::hear(const LinkStroke& stroke) {
  if (isWaiting_) {
    early_.push_back(stroke);
    return;
  }
  if (!other_) return;
  const Judgement judged = other_->hear(stroke.told);
  if (judged == Judgement::old) return;
  std::string fault = judged == Judgement::broken ? other_->broken()
                                                  : strokeFault(stroke.told.stroke, game_.billiard.pucks,
                                                                game_.billiard.lightSpeed_m_s);
  if (fault.empty() && strikesTooOften(stroke.told)) fault = "it strikes more than 20 times a second";
  if (!fault.empty()) {
    banned_.insert(otherName_);
    return part("refused", fault);
  }
  game_.strokes.push_back({otherNumber(), stroke.told});
  heard_.strokes.push_back({otherNumber(), stroke.told});
}

/// Returns whether a person would have struck more than twenty times in a second of the board.
bool LinkedPlay::strikesTooOften(const StrokeTold& told) const {
  constexpr std::ptrdiff_t kMost = 20;
  const auto near = [&](const LinkStroke& made) {
    return made.room == otherNumber() && made.told.viewer == told.viewer &&
           std::abs(made.told.stroke.at_s - told.stroke.at_s) < 0.5;
  };
  return std::ranges::count_if(game_.strokes, near) >= kMost;
}

void LinkedPlay::hear(const LinkDigest& digest) {
  constexpr std::size_t kMostWaiting = 4000;  // board seconds
  if (digest.second == 0 || others_.size() > kMostWaiting) return;
  others_[digest.second] = digest.digest;
  judge(digest.second);
}

void LinkedPlay::hear(const LinkTurns& turns) {
  if (state_ != LinkState::playing) return;
  turnsThere_ = turns;
  tellTurns(turns.second);
  findDifference();
}

void LinkedPlay::hear(const LinkSettings& settings) {
  const bool isNewer = settings.number > settings_.number || (settings.number == settings_.number && joins_);
  if (!isNewer || settings.lightSpeedShown_m_s == 0.0) return;
  settings_ = settings;
  heard_.settings = settings;
}

// ---------------------------------------------------------------- the end
/// Ends the game with the other room: it has gone, or it is refused. This room plays on alone.
void LinkedPlay::part(const char* what, const std::string& why) {
  heard_.notes.push_back({what, fmt::format("{}: {}", otherName_, why)});
  if (connection_) {
    lastRoundTrip_ = line_->roundTrip(connection_);
    line_->close(connection_, why);
  }
  connection_ = 0;
  other_.reset();
  others_.clear();
  differs_.reset();
  turnsThere_.reset();
  isInvited_ = false;
  isAccepted_ = joins_;  // who has joined lives on alone
  state_ = LinkState::alone;
}

void LinkedPlay::lookWhetherGone(LinkClock::time_point now) {
  if (state_ == LinkState::alone) return;
  const auto since_s = [&](LinkClock::time_point then) {
    return std::chrono::duration<double>(now - then).count();
  };
  // Loading a game takes its time.
  const double most_s = state_ == LinkState::playing ? self_.gone_s : 10.0 * self_.gone_s;
  if (since_s(presentAt_) > most_s) return part("gone", fmt::format("it was not heard for {:.0f} s", most_s));
  if (state_ == LinkState::playing && !settings_.isFrozen && since_s(movedAt_) > 2.0 * most_s) {
    if (++stood_ == kMostStood) banned_.insert(otherName_);
    return part("gone", fmt::format("its time stood still for {:.0f} s", 2.0 * most_s));
  }
  if (differs_ && since_s(differsAt_) > most_s)
    return part("mismatch", fmt::format("the games differ in board second {}", *differs_ - 1));
  if (settings_.isFrozen && since_s(movedAt_) > kFreezes_s && self_.hosts) {
    settings_ = {settings_.number + 1, settings_.lightSpeedShown_m_s, false};
    if (connection_) line_->send(connection_, settings_);
    heard_.settings = settings_;
  }
}

}  // namespace carom
