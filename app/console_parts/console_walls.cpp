#include "app/console_parts/console_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtk_glew.h>

#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

constexpr int kCopyWidth_px = 240;
constexpr double kCopyEvery_s = 1.0;
constexpr float kGap_px = 8.0F;

/// Returns the same wall in mono, with few pixels and without its projector's settings.
Wall smallOf(const Wall& wall) {
  Wall small;
  small.name = wall.name;
  small.lowerLeft_m = wall.lowerLeft_m;
  small.lowerRight_m = wall.lowerRight_m;
  small.upperLeft_m = wall.upperLeft_m;
  small.screen = wall.screen;
  small.sky = wall.sky;
  const double scale = std::min(1.0, static_cast<double>(kCopyWidth_px) / wall.pixels.x);
  small.pixels = glm::max(glm::ivec2(glm::round(glm::dvec2(wall.pixels) * scale)), 1);
  return small;
}

/// Writes the image's colours as they are: its alpha has no meaning. A logical operation does that, and not
/// blending turned off, for which Mesa's llvmpipe 22.3 colours tiles of 64 × 64 pixels by their place.
void startCopying(const ImDrawList*, const ImDrawCmd*) {
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_COPY);
}

void endCopying(const ImDrawList*, const ImDrawCmd*) { glDisable(GL_COLOR_LOGIC_OP); }

/// Shrinks the rectangle to the image's aspect ratio, centred horizontally.
void fit(const glm::ivec2& picture_px, ImVec2& from, ImVec2& to) {
  const ImVec2 place{to.x - from.x, to.y - from.y};
  const float scale =
      std::min(place.x / static_cast<float>(picture_px.x), place.y / static_cast<float>(picture_px.y));
  const ImVec2 size{std::floor(scale * static_cast<float>(picture_px.x)),
                    std::floor(scale * static_cast<float>(picture_px.y))};
  from = {from.x + std::floor((place.x - size.x) / 2), from.y};
  to = {from.x + size.x, from.y + size.y};
}

}  // namespace

WallsPanel::WallsPanel(Graphics& graphics, const Rig& rig, const Cluster& cluster)
    : graphics_(graphics), rig_(rig), cluster_(cluster), room_(roomGeometryOf(rig)) {
  for (const Wall& wall : rig.walls) {
    if (!cluster.draws(wall)) absent_.push_back(smallOf(wall));
  }
}

void WallsPanel::play(const Scene& scene, double lightSpeed_m_s) {
  scene_ = &scene;
  lightSpeed_m_s_ = lightSpeed_m_s;
  copies_.reset();
}

void WallsPanel::prepare(const ConsoleFrame& frame) {
  if (!drawsAbsent_ || absent_.empty()) return;
  if (copies_ && std::abs(frame.record.display_s - copied_s_) < kCopyEvery_s) return;
  graphics_.makeCurrent();
  if (!copies_) {
    copies_ =
        std::make_unique<DisplayWalls>(graphics_, *scene_, lightSpeed_m_s_, absent_, std::nullopt, false);
    copies_->setRoom(room_);
  }
  copies_->draw(frame.record, frame.world);
  graphics_.finishDrawing();
  copied_s_ = frame.record.display_s;
}

void WallsPanel::drawAbsent(const ConsoleFrame& frame, const Wall& wall, const ImVec2& from,
                            const ImVec2& to) const {
  const int rank = wall.node % cluster_.size();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(kDim);
  list.AddRect(from, to, ink);
  const float line_px = ImGui::GetTextLineHeightWithSpacing();
  list.AddText({from.x + 8.0F, from.y + 8.0F}, ink, texts::console::kDrawnBy);
  list.AddText({from.x + 8.0F, from.y + 8.0F + line_px}, ink, cluster_.nameOf(rank).c_str());
  const auto& nodes = frame.latency.nodes;
  const auto node = static_cast<std::size_t>(rank);
  if (node >= nodes.size() || nodes[node].late.frames == 0) return;
  const double late_ms = std::max(0.0, 1e3 * static_cast<double>(nodes[node].late.p99_s));
  list.AddText({from.x + 8.0F, from.y + 8.0F + 2 * line_px}, ink,
               texts::format(texts::console::kLate, late_ms).c_str());
}

void WallsPanel::drawTile(const ConsoleFrame& frame, const Wall& wall, const ImVec2& size_px) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float label_px = ImGui::GetTextLineHeightWithSpacing();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool absent = !cluster_.draws(wall);
  const RenderTarget* picture = frame.walls.pictureOf(wall.name);
  if (absent) picture = drawsAbsent_ && copies_ ? copies_->pictureOf(wall.name) : nullptr;
  ImVec2 from{corner.x, corner.y + label_px}, to{corner.x + size_px.x, corner.y + size_px.y};
  fit(wall.pixels, from, to);
  list.AddText({from.x, corner.y}, ImGui::GetColorU32(kBright), wall.name.c_str());
  if (cluster_.size() > 1) {
    const float width = ImGui::CalcTextSize(wall.name.c_str()).x;
    const std::string node = absent && picture
                                 ? texts::format(texts::console::kNodeDrawnHere, wall.node % cluster_.size())
                                 : texts::format(texts::console::kNodeOf, wall.node % cluster_.size());
    list.AddText({from.x + width + 8.0F, corner.y}, ImGui::GetColorU32(kDim), node.c_str());
  }
  if (picture) {
    list.AddCallback(startCopying, nullptr);
    list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture->texture())), from, to,
                  {0, 1}, {1, 0});
    list.AddCallback(endCopying, nullptr);
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_Separator));
    if (frame.record.controls.blank)
      list.AddText({from.x + 8.0F, from.y + 8.0F}, ImGui::GetColorU32(kDim), texts::console::kBlack);
  } else {
    drawAbsent(frame, wall, from, to);
  }
  ImGui::Dummy(size_px);
  tip(texts::format(texts::console::kWallTip, wall.name, wall.pixels.x, wall.pixels.y, toString(wall.stereo),
                    cluster_.nameOf(wall.node % cluster_.size()),
                    absent ? texts::console::kForMiddle : texts::console::kForLeftEye));
}

/// Returns the number of columns for which a grid of all walls has the largest tiles.
std::size_t WallsPanel::columnsFor(const ImVec2& room_px, float label_px) const {
  const std::size_t walls = rig_.walls.size();
  std::size_t best = 1;
  float most = 0.0F;
  for (std::size_t columns = 1; columns <= walls; ++columns) {
    const std::size_t rows = (walls + columns - 1) / columns;
    const float width = room_px.x / static_cast<float>(columns) - kGap_px;
    const float height = room_px.y / static_cast<float>(rows) - kGap_px - label_px;
    float area = 0.0F;
    for (const Wall& wall : rig_.walls) {
      const float scale =
          std::min(width / static_cast<float>(wall.pixels.x), height / static_cast<float>(wall.pixels.y));
      area += scale * scale * static_cast<float>(wall.pixels.x) * static_cast<float>(wall.pixels.y);
    }
    if (area <= most) continue;
    most = area;
    best = columns;
  }
  return best;
}

/// Says which computers the session does without, and with which walls.
void WallsPanel::drawMissing() const {
  for (const MissingNode& node : rig_.missing) {
    const std::string walls = node.walls.empty()
                                  ? std::string(texts::console::kNoWalls)
                                  : texts::format(texts::console::kMissingWalls, fmt::join(node.walls, ", "));
    light(kBad);
    ImGui::SameLine(0.0F, 4.0F);
    words(texts::format(texts::console::kMissing, node.name, walls));
    tip(texts::console::kMissingTip);
  }
}

void WallsPanel::draw(const ConsoleFrame& frame) {
  drawMissing();
  if (!absent_.empty()) {
    ImGui::Checkbox(texts::console::kDrawAbsent, &drawsAbsent_);
    tip(texts::console::kDrawAbsentTip);
  }
  const ImVec2 room_px = ImGui::GetContentRegionAvail();
  const float label_px = ImGui::GetTextLineHeightWithSpacing();
  const std::size_t columns = columnsFor(room_px, label_px);
  const std::size_t rows = (rig_.walls.size() + columns - 1) / columns;
  const ImVec2 tile{room_px.x / static_cast<float>(columns) - kGap_px,
                    room_px.y / static_cast<float>(rows) - kGap_px};
  for (std::size_t i = 0; i < rig_.walls.size(); ++i) {
    if (i % columns > 0) ImGui::SameLine(0.0F, kGap_px);
    drawTile(frame, rig_.walls[i], tile);
  }
}

}  // namespace carom::console
