#include "engine/linked/told_path.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

constexpr double kFastest = 0.98;   // of c; a head moves slower
constexpr double kSteady_s = 0.15;  // of a tracked head, a velocity from a shorter time is noise
// A hand is within 1.2 m of the head, and presents come at 60 Hz: 1.7 s of both ways of the light at 1.42
// m/s.
constexpr std::size_t kHandAside = 256;

Event between(const Event& from, const Event& to, double share) {
  return {glm::mix(from.t_s, to.t_s, share), glm::mix(from.r_m, to.r_m, share)};
}

/// Returns the share of the straight way from one event to the next that is past: `since_s` is not negative
/// at `from`, and negative at `to`.
double pastShare(const Event& from, const Event& to, const std::function<double(const Event&)>& since_s) {
  double past = 0.0, future = 1.0;
  for (int halving = 0; halving < 52; ++halving) {
    const double middle = 0.5 * (past + future);
    (since_s(between(from, to, middle)) >= 0.0 ? past : future) = middle;
  }
  return past;
}

}  // namespace

void ToldMoment::setName(std::string_view text) {
  name.fill('\0');
  std::copy_n(text.begin(), std::min(text.size(), name.size() - 1), name.begin());
}

void ToldPath::add(const ToldMoment& moment) {
  if (moment.kind == ToldKind::begins) moments_.clear();
  if (!moments_.empty()) {
    const Displacement way = moment.head - moments_.back().head;
    if (!(glm::length(way.dr_m) < kFastest * c_m_s_ * way.dt_s)) return;
  }
  moments_.push_back(moment);
}

void ToldPath::forgetBefore(double board_s) {
  const auto kept = std::ranges::lower_bound(moments_, board_s, {},
                                             [](const ToldMoment& moment) { return moment.head.t_s; });
  if (kept - moments_.begin() > 1) moments_.erase(moments_.begin(), kept - 1);
}

/// Returns the γβ of the way from somewhat before this moment to the next one. Later moments change no
/// picture.
Vec3 ToldPath::uAfter(std::size_t moment) const {
  if (moment + 1 >= moments_.size()) return Vec3(0.0);
  const Event& to = moments_[moment + 1].head;
  std::size_t first = moment;
  while (first > 0 && moments_[first].head.t_s > to.t_s - kSteady_s) --first;
  const Displacement way = to - moments_[first].head;
  return uFromBeta(way.dr_m / (c_m_s_ * way.dt_s));
}

/// The last moment near that of the head whose hand is past. Hands outrun light, so that their events need
/// not come one after the other.
std::size_t ToldPath::handBefore(const Since& since_s, std::size_t head) const {
  const std::size_t first = head - std::min(head, kHandAside);
  for (std::size_t i = std::min(moments_.size() - 1, head + kHandAside); i > first; --i)
    if (since_s(moments_[i].hand) >= 0.0) return i;
  return first;
}

std::optional<ToldView> ToldPath::at(const Since& since_s) const {
  const auto past = std::ranges::partition_point(
      moments_, [&](const ToldMoment& moment) { return since_s(moment.head) >= 0.0; });
  if (past == moments_.begin()) return std::nullopt;
  const auto before = static_cast<std::size_t>(past - moments_.begin()) - 1;
  const ToldMoment& moment = moments_[before];
  if (moment.kind == ToldKind::ends) return std::nullopt;
  ToldView view;
  view.moment = &moment;
  view.appears_s = moments_.front().head.t_s;
  view.u = uAfter(before);
  view.head = moment.head;
  view.properTime_s = moment.properTime_s;
  if (past != moments_.end()) {
    const double share = pastShare(moment.head, past->head, since_s);
    view.head = between(moment.head, past->head, share);
    view.properTime_s = glm::mix(moment.properTime_s, past->properTime_s, share);
  }
  const std::size_t hand = handBefore(since_s, before);
  view.handMoment = &moments_[hand];
  view.hand = moments_[hand].hand;
  const bool goesOn = hand + 1 < moments_.size() && since_s(view.hand) >= 0.0;
  if (goesOn && moments_[hand].hasHand && moments_[hand + 1].hasHand) {
    const Event& next = moments_[hand + 1].hand;
    view.hand = between(view.hand, next, pastShare(view.hand, next, since_s));
  }
  return view;
}

}  // namespace carom
