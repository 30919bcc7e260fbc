#include "cave/overlay/wall_buttons.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "cave/hud/motion_overlay.h"
#include "cave/hud/panel_place.h"
#include "cave/overlay/home_arrow.h"
#include "cave/record/effects.h"
#include "cave/room/off_axis.h"

namespace carom {
namespace {

constexpr double kTileWidth = 0.165, kGap = 0.012;        // fractions of the wall's width
constexpr double kTileHeight = 0.36, kFlatHeight = 0.18;  // fractions of the tile's width

/// Returns the width of all tiles and the gaps between them.
double rowOf_m(double width_m) { return (kChoices * kTileWidth + (kChoices - 1) * kGap) * width_m; }

/// Returns unit vectors along a wall's lower and left edge.
std::array<glm::dvec3, 2> edgesOf(const Wall& wall) {
  return {glm::normalize(wall.lowerRight_m - wall.lowerLeft_m),
          glm::normalize(wall.upperLeft_m - wall.lowerLeft_m)};
}

/// Returns the flat place below a tile.
Tile below(const Tile& tile, const Wall& wall) {
  const double width_m = tile.size_m.x, high_m = kFlatHeight * width_m;
  return {{tile.from_m.x, tile.from_m.y - kGap * sizeOf_m(wall).x - high_m}, {width_m, high_m}};
}

/// Returns the place of the tile for the next language: at the end of the third row below the choices, or
/// beside those at the wall's foot, below a lesson's band.
Tile languageTile(const Wall& wall, bool atFoot) {
  Tile last = tilesOn(wall, atFoot).back();
  if (!atFoot) return below(below(below(last, wall), wall), wall);
  last.from_m.x += last.size_m.x + kGap * sizeOf_m(wall).x;
  return last;
}

/// Appends the tile for the viewer's next language.
void addLanguage(const Wall& wall, const SeenFrame& seen, std::vector<WallButton>& buttons) {
  const std::uint8_t languages = seen.record.languagesOnTile;
  if (languages < 2 || seen.self.hand.pulling) return;
  const auto next = static_cast<std::uint8_t>((seen.self.language + 1) % languages);
  const bool isLesson = seen.record.lesson.phase != LessonPhase::none;
  buttons.push_back({{WallAction::Kind::language, next}, languageTile(wall, isLesson)});
}

}  // namespace

std::array<Tile, kChoices> tilesOn(const Wall& wall, bool atFoot) {
  const glm::dvec2 wall_m = sizeOf_m(wall);
  const glm::dvec2 tile_m = kTileWidth * wall_m.x * glm::dvec2(1.0, atFoot ? kFlatHeight : kTileHeight);
  const double margin_m = PanelPlace::kMargin * wall_m.y;
  const double left_m =
      atFoot ? 0.5 * (wall_m.x - rowOf_m(wall_m.x)) : wall_m.x - margin_m - rowOf_m(wall_m.x);
  const double foot_m = atFoot ? kGap * wall_m.x : PanelPlace::top_m(wall, margin_m) - tile_m.y;
  std::array<Tile, kChoices> tiles;
  for (std::size_t i = 0; i < kChoices; ++i)
    tiles[i] = {{left_m + static_cast<double>(i) * (kTileWidth + kGap) * wall_m.x, foot_m}, tile_m};
  return tiles;
}

OfferedTiles offeredIn(const RoomGeometry& room, const SeenFrame& seen, const GameOffers& game) {
  return {game.choices, !room.viewers.front().hasHand, game.hasTable && wayHome(room, seen).has_value(),
          game.hasTasks};
}

void addTiles(const Wall& wall, const SeenFrame& seen, const OfferedTiles& offered,
              std::vector<WallButton>& buttons) {
  using Kind = WallAction::Kind;
  addLanguage(wall, seen, buttons);
  const bool isLesson = seen.record.lesson.phase != LessonPhase::none;
  if (offered.choices && offersChoicesNow(seen)) {
    const std::array<Tile, kChoices> tiles = tilesOn(wall, isLesson);
    for (std::size_t i = 0; i < kChoices; ++i)
      buttons.push_back({actionOf(static_cast<Choice>(i)), tiles[i]});
  }
  if (isLesson || seen.self.hand.pulling) return;  // a lesson's band has buttons of its own
  const std::array<Tile, kChoices> above = tilesOn(wall, false);
  const auto add = [&](std::size_t column, Kind kind) {
    buttons.push_back({{kind, 0}, below(above[column], wall)});
  };
  if (seen.self.score.caroms > 0) add(0, Kind::goOn);
  const bool isFree =
      seen.record.drive.mode == DriveMode::free || seen.record.drive.mode == DriveMode::braking;
  if (seen.record.views.frozen) {
    add(1, Kind::unfreeze);
  } else if (isFree && (offered.isAstray || isDriven(seen))) {
    add(1, Kind::home);
  } else if (seen.self.score.caroms > 0) {
    add(1, Kind::keepShot);
  }
  if (!offered.choices || !offersChoicesNow(seen)) return;
  if (offered.keys) add(2, Kind::keys);
  const auto addBelow = [&](std::size_t column, Kind kind, std::uint8_t number = 0) {
    buttons.push_back({{kind, number}, below(below(above[column], wall), wall)});
  };
  if (offered.hasTasks) {
    addBelow(0, Kind::nextTask);
    addBelow(1, Kind::again);
    return;
  }
  if (seen.self.score.strokes > 0) addBelow(1, Kind::tasks);
  addBelow(2, Kind::effect, numberOf(&Switches::colour));
}

std::optional<PointedButton> buttonAt(const Wall& front, std::span<const WallButton> buttons,
                                      const glm::dvec3& from_m, const glm::dvec3& along) {
  const glm::dvec3 normal = normalOf(front);
  const double far_m = glm::dot(front.lowerLeft_m - from_m, normal) / glm::dot(along, normal);
  if (!(far_m > 0.0) || !std::isfinite(far_m)) return std::nullopt;
  const glm::dvec3 onWall_m = from_m + far_m * along;
  const auto [right, up] = edgesOf(front);
  const glm::dvec2 at_m{glm::dot(onWall_m - front.lowerLeft_m, right),
                        glm::dot(onWall_m - front.lowerLeft_m, up)};
  for (const WallButton& button : buttons) {
    const glm::dvec2 in_m = at_m - button.place.from_m;
    if (in_m.x >= 0.0 && in_m.y >= 0.0 && in_m.x <= button.place.size_m.x && in_m.y <= button.place.size_m.y)
      return PointedButton{button.action, onWall_m};
  }
  return std::nullopt;
}

WallAction pointedByHand(const Wall& front, std::span<const WallButton> buttons, const SeenFrame& seen) {
  if (!seen.self.hand.shown) return {};
  const auto pointed =
      buttonAt(front, buttons, seen.self.hand.from_m, seen.self.hand.to_m - seen.self.hand.from_m);
  return pointed ? pointed->action : WallAction{};
}

glm::dvec3 middleOf(const Wall& wall, const Tile& tile) {
  const auto [right, up] = edgesOf(wall);
  const glm::dvec2 middle_m = tile.from_m + 0.5 * tile.size_m;
  return wall.lowerLeft_m + middle_m.x * right + middle_m.y * up;
}

}  // namespace carom
