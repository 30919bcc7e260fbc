#pragma once
// The windows of one computer of an OpenCOVER room: on which part of which window, and on which X display,
// each channel draws.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Returns the elements of a group, such as the Screens of ScreenConfig, in the order of their names, which
/// are numbers from 0; as the file has them if some are none.
std::vector<const Part*> coverElements(const Part& config, std::string_view group, std::string_view element);

/// A channel by its number; its element may be missing.
struct CoverChannel {
  std::size_t index = 0;
  const Part* part = nullptr;
};

class CoverWindows {
 public:
  /// `config`: what the computer sees of <COVER>.
  CoverWindows(const Part& config, Room& room) : config_(config), room_(room) {}

  /// Returns the X display of a channel's window; empty for the default one.
  std::string displayOf(const CoverChannel& channel);
  /// Gives the wall the channel's part of its window. Numbers of a viewport above 1 are pixels, others shares
  /// of the window, from its lower left.
  void placeOnWindow(const CoverChannel& channel, RoomWall& wall);

 private:
  const Part* numbered(const char* group, const char* element, std::size_t index) const;
  std::size_t indexIn(const Part* part, std::string_view name, std::size_t usual);
  const Part* viewportOf(const CoverChannel& channel);
  const Part* windowOf(const CoverChannel& channel, const Part* viewport);
  /// Returns both edges of a viewport along an axis of its window, in pixels.
  glm::dvec2 edgesOf(const Part& viewport, std::array<std::string_view, 3> names, double whole_px);

  const Part& config_;
  Room& room_;
};

}  // namespace carom
