#include "app/live/wall_presses.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "cave/overlay/band_layout.h"
#include "cave/texts/language.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

bool does(const WallButton& button) { return button.action.kind != WallAction::Kind::none; }

}  // namespace

WallPresses::WallPresses(const RoomGeometry& room) : room_(room), front_(frontWall(room)) {
  if (front_) text_.setWall(*front_, room_.viewers);
}

void WallPresses::play(const Scenario& scenario) {
  const Lesson lesson = scenario.lesson.value_or(Lesson{});
  text_.setLesson(lesson.words, lesson.plan);
  offers_ = offersOf(scenario);
  band_.clear();
  buttons_.clear();
  chosen_.reset();
}

void WallPresses::follow(const SeenFrame& shown) {
  if (!front_) return;
  const texts::InLanguage reads(
      texts::ofSession(shown.self.language));  // its buttons are as wide as its words
  if (text_.follow(shown)) {
    band_.clear();
    if (text_.isBand()) addBand(*front_, text_.lines(), band_);
  }
  before_.swap(buttons_);
  buttons_.assign(band_.begin(), band_.end());
  addTiles(*front_, shown, offeredIn(room_, shown, offers_), buttons_);
  const bool isSame =
      std::equal(buttons_.begin(), buttons_.end(), before_.begin(), before_.end(),
                 [](const WallButton& now, const WallButton& before) { return now.action == before.action; });
  if (!isSame) chosen_.reset();
}

void WallPresses::aimPad(int steps, HandInput& hand) {
  if (steps != 0 && std::any_of(buttons_.begin(), buttons_.end(), does)) {
    const std::size_t count = buttons_.size(), by = steps > 0 ? 1 : count - 1;
    std::size_t next = chosen_ ? *chosen_ : steps > 0 ? count - 1 : 0;
    do next = (next + by) % count;
    while (!does(buttons_[next]));
    chosen_ = next;
  }
  if (!chosen_ || hand.device != kHandGamepad) return;
  hand.along = glm::normalize(middleOf(*front_, buttons_[*chosen_].place) - hand.from_m);
}

std::optional<PointedButton> WallPresses::at(const HandInput& hand) {
  const bool isFree = !hand.device.empty() && (!hand.held || hand.pressed);
  if (!isFree || !front_) return std::nullopt;
  const auto pointed = buttonAt(*front_, buttons_, hand.from_m, hand.along);
  if (hand.pressed) chosen_.reset();
  return pointed;
}

}  // namespace carom
