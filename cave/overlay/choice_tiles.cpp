#include "cave/overlay/choice_tiles.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "cave/overlay/hud_panel.h"
#include "cave/room/off_axis.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

constexpr double kTileWidth = 0.165, kGap = 0.012;  // fractions of the wall's width
constexpr double kTileHeight = 0.36;                // fraction of the tile's width
constexpr PanelPicture::Rgba kNothing{0, 0, 0, 0}, kTile{20, 44, 78, 225}, kPointed{245, 190, 60, 245};
constexpr glm::vec3 kOnTile(240.0F), kOnPointed(15.0F);

/// Returns the width of all tiles and the gaps between them.
double rowOf_m(double width_m) { return (kChoices * kTileWidth + (kChoices - 1) * kGap) * width_m; }

}  // namespace

std::array<Tile, kChoices> tilesOn(const Wall& wall, bool atFoot) {
  const glm::dvec2 wall_m = sizeOf_m(wall);
  const glm::dvec2 tile_m = kTileWidth * wall_m.x * glm::dvec2(1.0, kTileHeight);
  const double margin_m = HudPanel::kMargin * wall_m.y;
  const double left_m =
      atFoot ? 0.5 * (wall_m.x - rowOf_m(wall_m.x)) : wall_m.x - margin_m - rowOf_m(wall_m.x);
  const double foot_m = atFoot ? margin_m : HudPanel::top_m(wall, margin_m) - tile_m.y;
  std::array<Tile, kChoices> tiles;
  for (std::size_t i = 0; i < kChoices; ++i)
    tiles[i] = {{left_m + static_cast<double>(i) * (kTileWidth + kGap) * wall_m.x, foot_m}, tile_m};
  return tiles;
}

std::optional<PointedChoice> choiceAt(const Wall& front, bool atFoot, const glm::dvec3& from_m,
                                      const glm::dvec3& along) {
  const glm::dvec3 normal = normalOf(front);
  const double far_m = glm::dot(front.lowerLeft_m - from_m, normal) / glm::dot(along, normal);
  if (!(far_m > 0.0) || !std::isfinite(far_m)) return std::nullopt;
  const glm::dvec3 onWall_m = from_m + far_m * along;
  const glm::dvec2 at_m{
      glm::dot(onWall_m - front.lowerLeft_m, glm::normalize(front.lowerRight_m - front.lowerLeft_m)),
      glm::dot(onWall_m - front.lowerLeft_m, glm::normalize(front.upperLeft_m - front.lowerLeft_m))};
  const std::array<Tile, kChoices> tiles = tilesOn(front, atFoot);
  for (std::size_t i = 0; i < kChoices; ++i) {
    const glm::dvec2 in_m = at_m - tiles[i].from_m;
    if (in_m.x >= 0.0 && in_m.y >= 0.0 && in_m.x <= tiles[i].size_m.x && in_m.y <= tiles[i].size_m.y)
      return PointedChoice{static_cast<Choice>(i), onWall_m};
  }
  return std::nullopt;
}

/// Renders the names and keys as large as the tiles allow.
void ChoiceTiles::write(const glm::ivec2& tile_px) {
  const int name_px = std::max(1, tile_px.y / 2), key_px = std::max(1, tile_px.y / 4);
  for (std::size_t i = 0; i < kChoices; ++i) {
    names_[i] = ink(texts::kChoices[i], name_px);
    keys_[i] = ink(texts::kChoiceKeys[i], key_px);
  }
  tile_px_ = tile_px;
}

void ChoiceTiles::paint(const glm::ivec2& tile_px, int gap_px, std::optional<Choice> pointed) {
  const int step_px = tile_px.x + gap_px;
  panel_.begin({static_cast<int>(kChoices) * step_px - gap_px, tile_px.y}, kNothing);
  for (std::size_t i = 0; i < kChoices; ++i) {
    const int left_px = static_cast<int>(i) * step_px;
    const bool isPointed = pointed == static_cast<Choice>(i);
    panel_.fill({left_px, 0}, tile_px, isPointed ? kPointed : kTile);
    const auto centred = [&](const GlyphBitmap& text) { return left_px + (tile_px.x - text.size_px.x) / 2; };
    const glm::vec3 colour = isPointed ? kOnPointed : kOnTile;
    panel_.write({centred(names_[i]), tile_px.y * 42 / 100}, names_[i], colour);
    panel_.write({centred(keys_[i]), tile_px.y * 12 / 100}, keys_[i], colour);
  }
  panel_.upload();
  pointed_ = pointed;
}

void ChoiceTiles::draw(const Wall& wall, const FrameRecord& record, const RenderTarget& picture) {
  if (!offersChoicesNow(record)) return;
  const bool atFoot = record.lesson.phase == LessonPhase::explains;
  const glm::dvec2 pxPerM = glm::dvec2(picture.size_px()) / sizeOf_m(wall);
  const std::array<Tile, kChoices> tiles = tilesOn(wall, atFoot);
  const glm::ivec2 tile_px(tiles[0].size_m * pxPerM);
  const int gap_px = static_cast<int>(kGap * picture.size_px().x);
  std::optional<PointedChoice> pointed;
  if (record.hand.shown)
    pointed = choiceAt(wall, atFoot, record.hand.from_m, record.hand.to_m - record.hand.from_m);
  const std::optional<Choice> choice = pointed ? std::optional(pointed->choice) : std::nullopt;
  const bool isNew = tile_px != tile_px_;
  if (isNew) write(tile_px);
  if (isNew || choice != pointed_) paint(tile_px, gap_px, choice);
  panel_.draw(picture, glm::ivec2(tiles[0].from_m * pxPerM), 1.0);
}

}  // namespace carom
