#include "app/link/linked_play.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "app/link/stroke_check.h"
#include "engine/base/xxh3.h"
#include "engine/linked/pace.h"

namespace carom {
namespace {

constexpr std::size_t kTurnsKept_s = 60;

double secondsBetween(LinkClock::time_point from, LinkClock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// Returns the latest moment of a present's people.
double latest_s(const Present& present) {
  double latest_s = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < present.size; ++i) latest_s = std::max(latest_s, present.persons[i].head.t_s);
  return latest_s;
}

double earliestPromise_s(const Present& present) {
  double earliest_s = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < present.size; ++i)
    earliest_s = std::min(earliest_s, present.persons[i].promise.t_s);
  return earliest_s;
}

}  // namespace

LinkedPlay::LinkedPlay(LinkSelf self, Line& line, std::uint64_t arithmetic)
    : self_(std::move(self)), line_(&line), arithmetic_(arithmetic) {}

// ---------------------------------------------------------------- the game
void LinkedPlay::play(LinkedGame game) {
  game_ = std::move(game);
  room_ = 0;
  joins_ = false;
  own_.reset();
  other_.reset();
  eyes_.clear();
  std::vector<std::string> names;
  for (const Puck& puck : game_.billiard.pucks) names.push_back(puck.name);
  digest_.assign(1, FinalDigest(names));
  digests_.clear();
  others_.clear();
  sameUntil_s_ = 0;
  turns_.clear();
  differs_.reset();
  turnsThere_.reset();
  turnsTold_ = 0;
  isBuiltAnew_ = false;
  number_ = 0;
  banned_.clear();
  stood_ = 0;
  isInvited_ = isAccepted_ = false;
  settings_ = {};
  apart_m_ = self_.apart_m.value_or(0.0);
  early_.clear();
  if (connection_) state_ = LinkState::joining;
  if (connection_ && !game_.whyNot.empty()) part("refused", game_.whyNot);
}

void LinkedPlay::join(const LinkWelcome& welcome, LinkedGame game) {
  const std::vector<LinkStroke> early = std::exchange(early_, {});
  play(std::move(game));
  game_.strokes = welcome.strokes;
  if (first_) meets(*first_, presentAt_);
  for (const LinkStroke& stroke : early) {
    game_.strokes.push_back(stroke);
    if (other_ && stroke.told.number >= first_->present.strokes) other_->hear(stroke.told);
  }
  isWaiting_ = false;
  first_.reset();
  joins_ = true;
  room_ = welcome.room;
  number_ = welcome.game;
  apart_m_ = welcome.apart_m;
  settings_.lightSpeedShown_m_s = welcome.lightSpeedShown_m_s;
  settling_ = kSettle;
}

std::optional<double> LinkedPlay::begins_s(LinkClock::time_point now) const {
  if (!joins_) return 0.0;
  if (!other_) return std::nullopt;
  const double round_s = roundTrip().median_s;
  return newest_s_ + secondsBetween(presentAt_, now) + 1.5 * round_s;
}

void LinkedPlay::begin(const Observers& observers, LinkClock::time_point now) {
  own_.emplace(self_.reach_m, observers, othersHeads());
  own_->continueAfter(strokesOf(room_));
  now_ = now;
  told_ = {};
  told_.room = room_;
  told_.present = own_->present();
  told_.present.strokes = strokesOf(room_);
  told_.boardFromRoom = observers.boardFromRoom().matrix();
  if (joins_ && connection_) line_->send(connection_, LinkReady{told_});
}

double LinkedPlay::pace(LinkClock::time_point now) const {
  if (!other_ || !own_) return 1.0;
  const Present& present = other_->newest();
  const double age_s = present.waits ? 0.0 : secondsBetween(presentAt_, now) + 0.5 * roundTrip().median_s;
  return hurry(behind_s(latest_s(own_->present()), latest_s(present), age_s, slack_s()));
}

double LinkedPlay::slack_s() const {
  if (!other_ || !own_) return 0.0;
  return carom::slack_s(nearest_m(), own_->reach_m(0), game_.billiard.lightSpeed_m_s);
}

double LinkedPlay::away_s() const {
  return other_ && own_ ? nearest_m() / game_.billiard.lightSpeed_m_s : 0.0;
}

LinkStroke LinkedPlay::struck(std::uint32_t viewer, const Stroke& stroke) {
  const LinkStroke made{room_, own_->made(viewer, stroke)};
  game_.strokes.push_back(made);
  if (connection_ && (joins_ ? isAccepted_ : isInvited_)) line_->send(connection_, made);
  return made;
}

void LinkedPlay::tell(const Observers& observers, std::span<const Vec3> handsFromHeads_m,
                      const Persons& persons, std::span<const Event> eyes, bool waits,
                      LinkClock::time_point now) {
  if (!own_) return;
  eyes_.assign(eyes.begin(), eyes.end());
  told_.room = room_;
  told_.present = own_->tell(observers, handsFromHeads_m, othersHeads(), waits);
  told_.persons = persons;
  told_.boardFromRoom = observers.boardFromRoom().matrix();
  now_ = now;
  if (!connection_ || state_ == LinkState::alone) return;
  if (!joins_ && !isInvited_) return invite(now);
  if (!joins_ || isAccepted_) line_->present(connection_, told_);
}

double LinkedPlay::final_s() const {
  if (!own_) return 0.0;
  const double own_s = earliestPromise_s(own_->present());
  return other_ ? std::min(own_s, earliestPromise_s(other_->present())) : own_s;
}

void LinkedPlay::compare(std::span<const WorldLine> pucks) {
  FinalDigest& digest = digest_.front();
  const double until_s = final_s();
  while (digest.second() + 1.0 <= until_s) {
    digest.add(pucks, digest.second() + 1.0);
    digests_.push_back(digest.value());
    turns_[digest.second()].assign(digest.turns().begin(), digest.turns().end());
    if (turns_.size() > kTurnsKept_s) turns_.erase(turns_.begin());
    if (connection_ && state_ == LinkState::playing)
      line_->send(connection_, LinkDigest{digest.second(), digest.value()});
    judge(digest.second());
  }
}

/// Compares the digest of a second that both rooms have told.
void LinkedPlay::judge(std::uint32_t second) {
  const auto told = others_.find(second);
  if (told == others_.end() || second > digests_.size()) return;
  const bool isSame = told->second == digests_[second - 1];
  others_.erase(told);
  if (isSame) {
    sameUntil_s_ = std::max(sameUntil_s_, second);
    return;
  }
  if (differs_) return;
  differs_ = second;
  differsAt_ = now_;
  tellTurns(second);
  findDifference();
}

/// Tells the turns of a second, once.
void LinkedPlay::tellTurns(std::uint32_t second) {
  const auto found = turns_.find(second);
  if (found == turns_.end() || turnsTold_ == second || !connection_) return;
  turnsTold_ = second;
  LinkTurns message{second, digestOfStrokes(second), found->second};
  message.turns.resize(std::min<std::size_t>(message.turns.size(), kMostTurnsTold));
  line_->send(connection_, message);
}

/// Names the first turn that differs, once both rooms have told theirs. Where one room lacks a stroke, the
/// game of who has joined is built anew; otherwise they compute differently, and each room plays on alone.
void LinkedPlay::findDifference() {
  if (!differs_ || !turnsThere_ || turnsThere_->second != *differs_) return;
  const std::uint32_t second = *differs_;
  std::string words = fmt::format("the games differ in board second {}", second - 1);
  if (const auto difference = firstDifference(turns_[second], turnsThere_->turns)) {
    std::vector<std::string> names;
    for (const Puck& puck : game_.billiard.pucks) names.push_back(puck.name);
    std::ranges::sort(names);
    words +=
        fmt::format(", first in turn {} of {} at {:.6f} s", difference->turn,
                    difference->puck < names.size() ? names[difference->puck] : "a puck that is not here",
                    difference->t_s);
  }
  const bool isStrokeMissing = turnsThere_->strokes != digestOfStrokes(second);
  if (!isStrokeMissing || isBuiltAnew_) {
    banned_.insert(otherName_);
    return part("mismatch", words);
  }
  heard_.notes.push_back({"mismatch", otherName_ + ": " + words});
  isBuiltAnew_ = true;
  if (!joins_) buildAnew(second);  // who has joined is invited again
}

/// As the host invites the other room again, to the game as it is here: its own, in which a stroke was
/// missing, is void.
void LinkedPlay::buildAnew(std::uint32_t second) {
  heard_.notes.push_back({"resynchronised", fmt::format("{}: at {} s from here", otherName_, second)});
  other_.reset();
  others_.clear();
  differs_.reset();
  turnsThere_.reset();
  isInvited_ = false;
  state_ = LinkState::joining;
  presentAt_ = movedAt_ = now_;
}

/// Of the strokes before a board second that nothing can change any more: both rooms know those.
std::uint64_t LinkedPlay::digestOfStrokes(std::uint32_t second) const {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<double, 8>>
      strokes;  // in an order of their own
  for (const LinkStroke& made : game_.strokes) {
    const Stroke& stroke = made.told.stroke;
    if (stroke.at_s >= second) continue;
    strokes[{made.room, made.told.number}] = {static_cast<double>(stroke.puck),
                                              stroke.at_s,
                                              stroke.from_m->x,
                                              stroke.from_m->y,
                                              stroke.from_m->z,
                                              stroke.momentum_kg_m_s.x,
                                              stroke.momentum_kg_m_s.y,
                                              stroke.offset_m};
  }
  std::uint64_t digest = 0;
  for (const auto& [number, values] : strokes) {
    digest = XXH3_64bits_withSeed(&number, sizeof number, digest);
    digest = XXH3_64bits_withSeed(values.data(), sizeof values, digest);
  }
  return digest;
}

void LinkedPlay::tellSettings(double lightSpeedShown_m_s, bool isFrozen) {
  if (settings_.lightSpeedShown_m_s == 0.0) settings_.lightSpeedShown_m_s = lightSpeedShown_m_s;
  const bool isShown = settings_.lightSpeedShown_m_s == lightSpeedShown_m_s && settings_.isFrozen == isFrozen;
  if (isShown) settling_ = 0;
  if (isShown || settling_-- > 0) return;
  settling_ = 0;
  settings_ = {settings_.number + 1, lightSpeedShown_m_s, isFrozen};
  if (connection_ && state_ == LinkState::playing) line_->send(connection_, settings_);
}

void LinkedPlay::leave(const std::string& reason) {
  if (connection_) line_->close(connection_, reason);
  connection_ = 0;
  state_ = LinkState::alone;
  other_.reset();
}

// ---------------------------------------------------------------- helpers
std::vector<Event> LinkedPlay::othersHeads() const {
  std::vector<Event> heads;
  for (std::size_t i = 0; other_ && i < other_->newest().size; ++i)
    heads.push_back(other_->newest().persons[i].head);
  return heads;
}

double LinkedPlay::nearest_m() const {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Event& head : othersHeads()) {
    for (std::size_t i = 0; own_ && i < own_->present().size; ++i)
      nearest_m = std::min(nearest_m, glm::distance(head.r_m, own_->present().persons[i].head.r_m));
  }
  return nearest_m;
}

std::uint32_t LinkedPlay::strokesOf(std::uint32_t room) const {
  return static_cast<std::uint32_t>(
      std::ranges::count_if(game_.strokes, [room](const LinkStroke& stroke) { return stroke.room == room; }));
}

}  // namespace carom
