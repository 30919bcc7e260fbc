#pragma once
// A wall of the room as the rig file describes it: where it stands, its pixels, the node that draws it and
// how its pictures reach the person's two eyes. Room frame, metres.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/room/skewed_screen.h"
#include "cave/room/sky_eyes.h"
#include "engine/spacetime/observer.h"

namespace carom {

enum class StereoMode {
  mono,
  left,
  right,
  quadBuffer,
  sideBySide,
  topBottom,
  anaglyph,  ///< for red and cyan glasses; colours are kept as far as the two eyes' images do not conflict
  interlaced,
  checkerboard,
  anaglyphGrey,  ///< for red and cyan glasses, without colours: all brightness is kept
};

/// How the projector mirrors its picture on the way to the eye; the picture is mirrored beforehand to undo
/// it.
enum class Flip {
  none,
  horizontal,  ///< left and right, as for projection from behind the screen
  vertical,
  both,  ///< upside down, as for a projector hung from the ceiling
};

/// The mechanism that keeps the swaps of all nodes together (cave/cluster/frame_lock.h), as a rig asks for
/// it.
enum class FrameLock : std::uint8_t { software, swapGroup };
inline constexpr std::array<std::string_view, 2> kFrameLocks{"software", "swap-group"};

/// Where a visible window lies on its monitors, or, in a rig with one window for all walls, where the wall's
/// picture lies in that window. Pixels from the top left.
struct WindowPlacement {
  int monitor = 0;
  glm::ivec2 position_px{0};
  glm::ivec2 size_px{0};
  bool fullscreen = false;  ///< it covers its monitors
  bool border = false;      ///< it has a title and a border, as on a desk
  /// Names of the monitors that it spans, such as "DP-1"; if empty, it is on the monitor of that number.
  std::vector<std::string> monitorNames{};

  bool operator==(const WindowPlacement&) const = default;
};

/// Part of a window, in pixels from its top left.
struct Viewport {
  glm::ivec2 position_px{0};
  glm::ivec2 size_px{0};
};

/// An eye of one of the viewers in the room.
struct ViewerEye {
  std::size_t viewer = 0;  ///< index of the rig's viewers
  Eye eye = Eye::middle;

  bool operator==(const ViewerEye&) const = default;
};

struct CurvedScreen;  // cave/screen/curved_screen.h

/// A rectangle given by three of its corners, as seen from inside the room. Of a screen that is no rectangle,
/// it is the one around it; a curved screen has its own description, and is drawn on several flat walls.
struct Wall {
  std::string name;
  glm::dvec3 lowerLeft_m{0.0};
  glm::dvec3 lowerRight_m{0.0};
  glm::dvec3 upperLeft_m{0.0};
  glm::ivec2 pixels{0};  ///< per eye: size of the pictures that are drawn and captured
  int node = 0;          ///< MPI rank that draws it
  WindowPlacement window;
  /// The wall's part of the window, which it then shares with all walls of its node that name the same window
  /// and a part; none: it has the whole window.
  std::optional<Viewport> viewport;
  StereoMode stereo = StereoMode::mono;
  std::size_t viewer = 0;  ///< whose eyes it shows, an index of the rig's viewers
  /// The eyes of the stereo mode's channels, in their order; empty: those of `viewer`.
  std::vector<ViewerEye> eyes;
  /// The names of its channels' pictures in files, where they are of several viewers; empty: the wall's name.
  std::vector<std::string> pictureNames;
  /// The screen's own corners; none: they are those of the rectangle.
  std::optional<SkewedScreen> skewed;
  std::shared_ptr<const CurvedScreen> screen;  ///< it is curved; its corners are not set; null: flat
  /// Its picture is by direction, and `screen` is very far away (cave/screen/sky_screen.h); none: it is a
  /// wall of the room.
  std::optional<SkyEyes> sky;
  int piece =
      0;  ///< of the flat walls on which a curved screen is drawn, counted from 1; 0: it is none of them
  std::filesystem::path warp;  ///< file of the mesh that warps the picture to the screen; empty: none
  /// Meshes of its own for red, green and blue, for projectors whose colours do not lie upon each other;
  /// empty: all colours as `warp`.
  std::array<std::filesystem::path, 3> colourWarps;
  std::filesystem::path blend;  ///< picture that dims where projectors overlap; empty: none
  double blackLevel = 0.0;  ///< what black is lifted to, as a fraction of the brightest: evens out overlaps
  glm::dvec3 gain{1.0};     ///< red, green and blue of its white, as fractions of the brightest
  std::optional<glm::dvec3> gamma;  ///< its light is code^gamma; none: sRGB
  Flip flip = Flip::none;
  double displayLatency_s = 0.0;  ///< from the swap to the photons
  bool onHead = false;            ///< it hangs on the head, before an eye of a headset, wherever that is
  double textSize = 1.0;          ///< of its words, a factor; where there is no room for it, they get smaller
  std::size_t heldFrames = 0;     ///< frames by which its pictures are delayed, to match slower walls
};

/// Returns a wall's unit normal, which points to the person who looks at it.
inline glm::dvec3 normalOf(const Wall& wall) {
  return glm::normalize(
      glm::cross(wall.lowerRight_m - wall.lowerLeft_m, wall.upperLeft_m - wall.lowerLeft_m));
}

}  // namespace carom
