#include "cave/overlay/choice_tiles.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "cave/hud/hud_line.h"
#include "cave/record/effects.h"
#include "cave/room/off_axis.h"
#include "cave/texts/key_names.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

constexpr double kFlat = 0.27;  // tiles lower than this share of their width have one line
constexpr PanelPicture::Rgba kNothing{0, 0, 0, 0}, kTile{20, 44, 78, 225};
constexpr glm::vec3 kOnTile(240.0F);

bool isFlat(const glm::ivec2& tile_px) { return tile_px.y < kFlat * tile_px.x; }

/// Returns the name of an action and its key.
std::pair<std::string_view, std::string_view> textsOf(const WallAction& action) {
  switch (action.kind) {
    case WallAction::Kind::choice:
      return {texts::tile::kChoices.at(action.number), texts::tile::kChoiceKeys.at(action.number)};
    case WallAction::Kind::goOn:
      return {texts::tile::kBestShot, texts::keys::kEnterKey};
    case WallAction::Kind::effect: {
      const NamedSwitch& effect = kNamedSwitches.at(action.number);
      return {effect.words, std::string_view(&effect.key, 1)};
    }
    case WallAction::Kind::keepShot:
      return {texts::tile::kKeepShot, ""};
    case WallAction::Kind::home:
      return {texts::tile::kHome, texts::keys::kHomeKey};
    case WallAction::Kind::unfreeze:
      return {texts::tile::kTimeGoesOn, "F"};
    case WallAction::Kind::tasks:
      return {texts::tile::kTasks, ""};
    case WallAction::Kind::nextTask:
      return {texts::tile::kNextTask, ""};
    case WallAction::Kind::again:
      return {texts::tile::kTryAgain, "Y"};
    case WallAction::Kind::keys:
      return {texts::tile::kKeys, "H"};
    default:
      return {"", ""};
  }
}

}  // namespace

/// Returns the name of a tile, and its key as the keyboard has it.
std::pair<std::string, std::string> ChoiceTiles::wordsOf(const WallAction& action) const {
  if (action.kind == WallAction::Kind::language)
    return {action.number < languages_.size() ? languages_[action.number] : std::string(), "F9"};
  const auto [name, key] = textsOf(action);
  return {std::string(name), texts::inLayout(key)};
}

/// Returns the label of a tile of this size, rendered when it is first needed.
const ChoiceTiles::Label& ChoiceTiles::labelOf(const Painted& tile) {
  const auto& [action, unused, tile_px, language] = tile;
  const auto known = std::find_if(labels_.begin(), labels_.end(), [&](const Label& label) {
    return label.action == tile.action && label.tile_px == tile.size_px && label.language == tile.language;
  });
  if (known != labels_.end()) return *known;
  constexpr std::size_t kMostLabels = 32;  // of a window whose size has changed many times
  if (labels_.size() == kMostLabels) labels_.clear();
  const bool flat = isFlat(tile_px);
  const auto [name, key] = wordsOf(action);
  int name_px = std::max(1, (flat ? 65 : 50) * tile_px.y / 100),
      key_px = std::max(1, (flat ? 40 : 25) * tile_px.y / 100);
  Label label{action, language, tile_px, ink(name, name_px), ink(key, key_px)};
  const int most_px = 92 * tile_px.x / 100;
  const int least_px = std::min(leastLetter_px(), name_px), name_wide_px = label.name.size_px.x;
  int wide_px = name_wide_px + (flat ? tile_px.y / 3 + label.key.size_px.x : 0);
  const bool hasKey = !flat || wide_px <= most_px || name_px * most_px / wide_px >= least_px;
  if (!hasKey) {  // the list of keys has it
    label.key = {};
    wide_px = name_wide_px;
  }
  if (wide_px > most_px) {  // smaller letters
    label.name = ink(name, std::max(least_px, name_px * most_px / wide_px));
    if (hasKey) label.key = ink(key, std::max(1, key_px * most_px / wide_px));
  }
  labels_.push_back(std::move(label));
  return labels_.back();
}

void ChoiceTiles::paintTile(std::size_t tile, const glm::ivec2& from_px) {
  const auto& [action, unused, tile_px, language] = painted_[tile];
  const bool isPointed = action == pointed_;
  panel_.fill(from_px, tile_px, isPointed ? PanelPicture::kPointed : kTile);
  const auto centred = [&](int width_px) { return from_px.x + (tile_px.x - width_px) / 2; };
  const glm::vec3 colour = isPointed ? PanelPicture::kOnPointed : kOnTile;
  const Label& label = labelOf(painted_[tile]);
  if (isFlat(tile_px)) {  // the key stands behind the name
    const int name_px = label.name.size_px.x + tile_px.y / 3;
    const int begin_px = centred(name_px + label.key.size_px.x), foot_px = from_px.y + tile_px.y * 27 / 100;
    panel_.write({begin_px, foot_px}, label.name, colour);
    panel_.write({begin_px + name_px, foot_px}, label.key, colour);
  } else {
    panel_.write({centred(label.name.size_px.x), from_px.y + tile_px.y * 42 / 100}, label.name, colour);
    panel_.write({centred(label.key.size_px.x), from_px.y + tile_px.y * 12 / 100}, label.key, colour);
  }
}

void ChoiceTiles::paint() {
  glm::ivec2 low = painted_.front().from_px, high = low;
  for (const Painted& tile : painted_) {
    low = glm::min(low, tile.from_px);
    high = glm::max(high, tile.from_px + tile.size_px);
  }
  corner_px_ = low;
  panel_.begin(high - low, kNothing);
  for (std::size_t i = 0; i < painted_.size(); ++i) paintTile(i, painted_[i].from_px - low);
  panel_.upload();
}

void ChoiceTiles::draw(const Wall& wall, const SeenFrame& seen, const OfferedTiles& offered,
                       const RenderTarget& picture) {
  tiles_.clear();
  wanted_.clear();
  addTiles(wall, seen, offered, tiles_);
  if (tiles_.empty()) return;
  const glm::dvec2 pxPerM = glm::dvec2(picture.size_px()) / sizeOf_m(wall);
  for (const WallButton& tile : tiles_)
    wanted_.push_back({tile.action, glm::ivec2(tile.place.from_m * pxPerM),
                       glm::ivec2(tile.place.size_m * pxPerM), seen.self.language});
  if (const std::uint64_t named = texts::keyNames.changes(); keysNamed_ != named) {
    keysNamed_ = named;
    labels_.clear();
    painted_.clear();
  }
  pointed_ = pointedByHand(wall, tiles_, seen);
  if (wanted_ != painted_ || pointed_ != paintedPointed_) {
    painted_ = wanted_;
    paintedPointed_ = pointed_;
    paint();
  }
  panel_.draw(picture, corner_px_, 1.0);
}

}  // namespace carom
