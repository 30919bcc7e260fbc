#include "app/link/linked_play.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "app/link/stroke_check.h"
#include "engine/linked/pace.h"

namespace carom {
namespace {

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
  number_ = 0;
  banned_.clear();
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
  banned_.insert(otherName_);
  part("mismatch", fmt::format("the games differ in board second {}: each room plays on alone", second - 1));
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
