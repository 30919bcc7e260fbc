#include "cave/display/window_layout.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace carom {
namespace {

constexpr double kSmallest = 0.4, kStep = 0.05;  // scales of the pictures

struct Box {
  glm::ivec2 low{0}, high{0};

  glm::ivec2 size() const { return high - low; }
};

Box boxOf(const ScreenPlace& place) { return {place.position_px, place.position_px + place.size_px}; }

/// Returns the window with its title and edges.
Box framed(const ScreenPlace& place) {
  return {place.position_px - glm::ivec2(kEdge_px, kTitle_px),
          place.position_px + place.size_px + glm::ivec2(kEdge_px)};
}

bool meet(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool holds(const Box& outer, const Box& inner) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

bool isFree(const Box& box, std::span<const Box> obstacles) {
  return std::none_of(obstacles.begin(), obstacles.end(), [&](const Box& other) { return meet(box, other); });
}

/// Returns the size that a window has in a free box: as wanted, or as much of it as fits.
glm::ivec2 sizeIn(const Box& box, const FreeWindow& window) {
  const glm::ivec2 room = box.size() - glm::ivec2(2 * kEdge_px, kTitle_px + kEdge_px);
  if (!window.keepsShape) return glm::min(room, window.wanted_px);
  const glm::dvec2 share = glm::dvec2(room) / glm::dvec2(glm::max(window.wanted_px, 1));
  return glm::ivec2(glm::floor(std::min({share.x, share.y, 1.0}) * glm::dvec2(window.wanted_px)));
}

/// Calls `see` with every free box whose sides lie on those of the area and of the obstacles.
template <typename See>
void eachFreeBox(const Box& area, std::span<const Box> obstacles, const See& see) {
  std::vector<int> xs{area.low.x, area.high.x}, ys{area.low.y, area.high.y};
  for (const Box& box : obstacles) {
    for (const int x : {box.low.x, box.high.x}) xs.push_back(std::clamp(x, area.low.x, area.high.x));
    for (const int y : {box.low.y, box.high.y}) ys.push_back(std::clamp(y, area.low.y, area.high.y));
  }
  for (const int left : xs) {
    for (const int top : ys) {
      for (const int right : xs) {
        for (const int bottom : ys) {
          const Box box{{left, top}, {right, bottom}};
          if (right > left && bottom > top && isFree(box, obstacles)) see(box);
        }
      }
    }
  }
}

/// Returns the place where the window is largest, the first of those that are equal, or none.
std::optional<ScreenPlace> largest(const FreeWindow& window, std::span<const Box> areas,
                                   std::span<const Box> obstacles) {
  std::optional<ScreenPlace> best;
  double most = 0.0;
  for (const Box& area : areas) {
    eachFreeBox(area, obstacles, [&](const Box& box) {
      const glm::ivec2 size = sizeIn(box, window);
      if (size.x < window.least_px.x || size.y < window.least_px.y) return;
      const double pixels = static_cast<double>(size.x) * size.y;
      if (pixels <= most) return;
      most = pixels;
      best = ScreenPlace{box.low + glm::ivec2(kEdge_px, kTitle_px), size};
    });
  }
  return best;
}

/// Returns the window's own place if it is free and on a monitor.
std::optional<ScreenPlace> ownPlace(const FreeWindow& window, std::span<const Box> areas,
                                    std::span<const Box> obstacles) {
  if (!window.at) return {};
  const bool isOnOne = std::any_of(areas.begin(), areas.end(),
                                   [&](const Box& area) { return holds(area, boxOf(*window.at)); });
  if (!isOnOne || !isFree(boxOf(*window.at), obstacles)) return {};
  return window.at;
}

/// Returns a window that wants this part of its size; a picture's own place and least size shrink with it.
FreeWindow scaled(FreeWindow window, double scale) {
  const auto shrunk = [scale](const glm::ivec2& size_px) { return glm::ivec2(scale * glm::dvec2(size_px)); };
  window.wanted_px = shrunk(window.wanted_px);
  if (!window.keepsShape) {
    window.wanted_px = glm::max(window.wanted_px, window.least_px);
    return window;
  }
  if (window.at) window.at->size_px = shrunk(window.at->size_px);
  window.least_px = glm::min(window.least_px, window.wanted_px);
  return window;
}

}  // namespace

namespace {

using Places = std::vector<std::optional<ScreenPlace>>;

std::size_t placed(const Places& places) {
  return static_cast<std::size_t>(
      std::count_if(places.begin(), places.end(), [](const auto& place) { return place.has_value(); }));
}

/// Returns the places of windows that each want this part of their size.
Places placesAt(double scale, std::span<const FreeWindow> windows, std::vector<Box> obstacles,
                std::span<const Box> monitors) {
  Places places;
  for (const FreeWindow& given : windows) {
    const FreeWindow window = scaled(given, scale);
    std::optional<ScreenPlace> place = ownPlace(window, monitors, obstacles);
    if (!place) place = largest(window, monitors, obstacles);
    places.push_back(place);
    if (place) obstacles.push_back(framed(*place));
  }
  return places;
}

}  // namespace

std::vector<std::optional<ScreenPlace>> arranged(std::span<const FreeWindow> given,
                                                 std::span<const ScreenPlace> taken,
                                                 std::span<const ScreenPlace> areas) {
  std::vector<Box> monitors, obstacles;
  for (const ScreenPlace& area : areas) monitors.push_back(boxOf(area));
  for (const ScreenPlace& place : taken) obstacles.push_back(boxOf(place));
  std::vector<FreeWindow> windows(given.begin(), given.end());
  Places best(windows.size());
  for (const bool keepsPlaces : {true, false}) {
    for (FreeWindow& window : windows) {
      if (!keepsPlaces && !window.keepsShape) window.at.reset();  // it has taken the others' room
    }
    for (double scale = 1.0; scale > kSmallest - 0.5 * kStep; scale -= kStep) {
      const Places places = placesAt(scale, windows, obstacles, monitors);
      if (placed(places) > placed(best)) best = places;
      if (placed(best) == windows.size()) return best;
    }
  }
  return best;
}

Viewport fitted(const glm::ivec2& shape_px, const glm::ivec2& window_px) {
  const glm::dvec2 shape(shape_px), window(window_px);
  const double scale = std::min(window.x / shape.x, window.y / shape.y);
  const glm::ivec2 size_px = glm::max(glm::ivec2(glm::round(scale * shape)), glm::ivec2(1));
  const glm::ivec2 beside_px = window_px - size_px;
  if (beside_px.x <= 1 && beside_px.y <= 1) return {{0, 0}, window_px};
  return {beside_px / 2, size_px};
}

}  // namespace carom
