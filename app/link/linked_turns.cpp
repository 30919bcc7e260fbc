#include "app/link/linked_turns.h"

#include <tuple>

#include "engine/linked/promise.h"

namespace carom {

void LinkedTurns::joined(std::uint32_t before) {
  before_ = before;
  strokes_[1] = caroms_[1] = caromsKnown_[1] = {};
  std::erase_if(caromsAhead_, [](const Carom& carom) { return carom.player.room == 1; });
}

void LinkedTurns::struck(const LinkStroke& stroke) {
  if (!isPossible({stroke.room, stroke.told.viewer})) return;
  if (stroke.room == room_) return count(stroke);
  strokesAhead_.push_back(stroke);
}

void LinkedTurns::carom(const LinkedPlayer& player, std::uint32_t stroke, const Event& seenAt) {
  if (!isPossible(player)) return;
  std::uint32_t& known = caromsKnown_[player.room][player.viewer];
  if (known > stroke) return;
  known = stroke + 1;
  const Carom carom{player, stroke, seenAt};
  if (player.room == room_) return count(carom);
  caromsAhead_.push_back(carom);
}

void LinkedTurns::look(const Event& eye, double lightSpeed_m_s) {
  const auto isSeen = [&](const Event& event) { return isInFutureOf(event, eye, lightSpeed_m_s); };
  std::erase_if(strokesAhead_, [&](const LinkStroke& stroke) {
    if (!isSeen(stroke.told.event())) return false;
    count(stroke);
    return true;
  });
  std::erase_if(caromsAhead_, [&](const Carom& carom) {
    if (!isSeen(carom.seenAt)) return false;
    count(carom);
    return true;
  });
}

void LinkedTurns::count(const LinkStroke& stroke) {
  if (stroke.room != 1 || stroke.told.number >= before_) ++strokes_[stroke.room][stroke.told.viewer];
  const auto moment = [](const LinkStroke& of) {
    return std::tuple(of.told.stroke.at_s, of.room, of.told.number);
  };
  if (!latest_ || moment(stroke) > moment(*latest_)) latest_ = stroke;
}

LinkedPlayer LinkedTurns::turn(const std::array<std::uint32_t, 2>& people) const {
  if (!latest_) return {};
  const LinkedPlayer last{latest_->room, latest_->told.viewer};
  if (caroms_[last.room][last.viewer] == latest_->told.number + 1) return last;
  if (last.viewer + 1 < people[last.room]) return {last.room, last.viewer + 1};
  const std::uint32_t next = 1 - last.room;
  return people[next] > 0 ? LinkedPlayer{next, 0} : LinkedPlayer{last.room, 0};
}

}  // namespace carom
