#include "app/cave_formats/cover_windows.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <optional>

#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

constexpr glm::ivec2 kUsualWindow_px{1024, 768};

}  // namespace

std::vector<const Part*> coverElements(const Part& config, std::string_view group, std::string_view element) {
  const Part* found = config.find(group);
  std::vector<const Part*> parts = found ? found->all(element) : std::vector<const Part*>();
  const auto numberOf = [](const Part* part) { return wholeNumber(part->textOf("name")); };
  if (std::all_of(parts.begin(), parts.end(), [&](const Part* part) { return numberOf(part).has_value(); })) {
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const Part* a, const Part* b) { return *numberOf(a) < *numberOf(b); });
  }
  return parts;
}

std::string CoverWindows::displayOf(const CoverChannel& channel) {
  const Part* window = windowOf(channel, viewportOf(channel));
  const std::size_t index = indexIn(window, "pipeIndex", 0);
  const Part* pipe = numbered("PipeConfig", "Pipe", index);
  if (!pipe && index > 0)
    addWarning(room_, window->placeOf("pipeIndex"),
               fmt::format("there is no pipe {}: the window is on the computer's usual display", index));
  if (!pipe || flagOr(*pipe, "useDISPLAY", false, room_)) return "";
  const std::string server = pipe->textOf("server"), screen = pipe->textOf("screen");
  if (server.empty() && screen.empty()) return "";
  return fmt::format(":{}.{}", server.empty() ? "0" : server, screen.empty() ? "0" : screen);
}

void CoverWindows::placeOnWindow(const CoverChannel& channel, RoomWall& wall) {
  const Part* viewport = viewportOf(channel);
  const Part* window = windowOf(channel, viewport);
  if (!window && !viewport) return;
  const auto pixels = [&](const char* name, const Range& range, int usual) {
    return static_cast<int>(window ? number(*window, name, range, false, room_).value_or(usual) : usual);
  };
  WindowPlacement placed;
  placed.position_px = {pixels("left", kWindowPlace_px, 0), pixels("top", kWindowPlace_px, 0)};
  placed.size_px = {pixels("width", kWindowSize_px, kUsualWindow_px.x),
                    pixels("height", kWindowSize_px, kUsualWindow_px.y)};
  if (window) wall.at.window = window->at;
  if (!viewport) return placeInWindow(placed, {0, 0}, placed.size_px, wall, room_);
  wall.at.pixels = viewport->at;
  const glm::dvec2 across = edgesOf(*viewport, {"left", "right", "width"}, placed.size_px.x),
                   up = edgesOf(*viewport, {"bottom", "top", "height"}, placed.size_px.y);
  const glm::ivec2 low_px(glm::round(glm::dvec2(across.x, up.x))),
      high_px(glm::round(glm::dvec2(across.y, up.y)));
  const glm::ivec2 size_px = glm::max(high_px - low_px, glm::ivec2(1));
  if (!window) {
    wall.wall.pixels = wall.wall.window.size_px = size_px;
    return;
  }
  placeInWindow(placed, {low_px.x, placed.size_px.y - low_px.y - size_px.y}, size_px, wall, room_);
}

/// Returns the element of this name and number of a group, such as the second Window of WindowConfig.
const Part* CoverWindows::numbered(const char* group, const char* element, std::size_t index) const {
  const Part* found = config_.find(group);
  for (const Part* part : found ? found->all(element) : std::vector<const Part*>()) {
    if (part->textOf("name") == fmt::format("{}", index)) return part;
  }
  return nullptr;
}

std::size_t CoverWindows::indexIn(const Part* part, std::string_view name, std::size_t usual) {
  const auto value = part ? number(*part, name, {.least = -1.0, .most = 512.0}, true, room_) : std::nullopt;
  return value ? static_cast<std::size_t>(std::max(0.0, *value)) : usual;
}

/// Channel i has viewport i unless it says otherwise. Old files give the viewport in the channel.
const Part* CoverWindows::viewportOf(const CoverChannel& channel) {
  if (channel.part && channel.part->find("width")) return channel.part;
  return numbered("ViewportConfig", "Viewport", indexIn(channel.part, "viewportIndex", channel.index));
}

/// Returns the window of a channel: its own, or that of its viewport.
const Part* CoverWindows::windowOf(const CoverChannel& channel, const Part* viewport) {
  const Part* holder = viewport && viewport->find("windowIndex") ? viewport : channel.part;
  return numbered("WindowConfig", "Window", indexIn(holder, "windowIndex", 0));
}

glm::dvec2 CoverWindows::edgesOf(const Part& viewport, std::array<std::string_view, 3> names,
                                 double whole_px) {
  const auto pixels = [&](std::string_view name) -> std::optional<double> {
    const auto value = number(viewport, name, kWindowPlace_px, false, room_);
    return value ? std::optional(*value > 1.0 ? *value : *value * whole_px) : std::nullopt;
  };
  const double low = pixels(names[0]).value_or(0.0);
  const auto high = pixels(names[1]);
  return {low, high ? *high : low + pixels(names[2]).value_or(whole_px)};
}

}  // namespace carom
