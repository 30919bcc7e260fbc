#include "app/file_keys/screen_keys.h"

#include "app/file_keys/common_keys.h"
#include "app/file_keys/length_units.h"
#include "cave/screen/sky_screen.h"

namespace carom {
namespace {

using namespace declare;

constexpr Range kAngle{.least = -360.0, .most = 360.0};
constexpr Range kFov{.least = 0.0, .most = 359.0, .above = true};

FileKey screen() {
  const auto length = [](std::string_view name, const Range& range, std::string_view sentence) {
    return inUnit(kUnitOfRig, number(name, range, sentence));
  };
  return table(
      "screen", "a curved screen, in the place of corners, seen from inside",
      {required(choice("shape", {"cylinder", "dome", "mesh", "grid"},
                       "part of a cylinder; of a sphere, whose window is the circle of a fisheye "
                       "with the front at its bottom; or measured, as triangles or at the points "
                       "of a grid")),
       corner("foot", "of a cylinder: a point of its axis, from which heights are counted"),
       numbers("axis", 3, {}, "of a cylinder: the direction of its axis, upwards"),
       corner("centre", "of a dome"), length("radius", kPositive, "of the cylinder or dome"),
       number("from_deg", kAngle,
              "of a cylinder: where its window's left edge is, about the axis from the room's "
              "forward direction, positive to the right"),
       number("to_deg", kAngle, "of a cylinder: its window's right edge"),
       length("bottom", {}, "of a cylinder: its window's lower edge, along the axis"),
       length("top", {}, "of a cylinder: its window's upper edge"),
       number("fov_deg", kFov, "of a dome: the angle across its window's circle", 180.0),
       number("tilt_deg", kAngle, "of a dome: by how much its axis leans forward from upright", 0.0),
       number("heading_deg", kAngle,
              "of a dome: where its front is, to the right of the room's forward direction", 0.0),
       fitting("\\.(obj|pfm|vwf)$",
               text("file",
                    "of a mesh, an OBJ: v are places of the screen, vt of the window, 0 to 1 from its "
                    "lower left; of a grid, a PFM with x, y, z at the middles of its cells, NaN where "
                    "there is no screen, or a .vwf of VIOSO")),
       choice("rows", {"bottom", "top"}, "of a PFM: which edge of the window its first row is at", 0),
       choice("unit", kLengthUnits, "of the file's lengths; left out: the rig's"),
       pose("room_from_screen", "of a mesh or grid: takes the file's coordinates to the room's")});
}

FileKey sky() {
  return table(
      "sky", "a picture by direction, of no screen, in the place of corners",
      {required(choice("kind", kSkyKinds,
                       "a circle with the front at its bottom; longitude across and latitude up; or six "
                       "squares of 90 degrees in one row: right, left, up, down, back, front")),
       number("fov_deg", kFov, "of a fisheye: the angle across its circle", 180.0),
       number("tilt_deg", kAngle, "by how much its axis leans forward from upright", 0.0),
       number("heading_deg", kAngle, "where its front is, to the right of the room's forward direction", 0.0),
       corner("from", "the place in the room from which it is seen; left out: the tracked head")});
}

}  // namespace

std::vector<FileKey> screenKeys() {
  return {screen(), sky(),
          number("texels_per_pixel", {.least = 1.0, .most = 4.0},
                 "of a curved screen or a picture by direction: how finely the flat pieces are drawn of "
                 "which it is made",
                 1.25),
          inUnit(kUnitOfRig, number("facet_sagitta", kPositive,
                                    "of a curved screen: how deep the part of it may be that one flat piece "
                                    "shows; 0.1 m if left out"))};
}

FileKey panelKey() {
  return table("panel",
               "the board in the room that carries messages, lessons and choices; left out: the first flat "
               "wall ahead, or a chord of the curved screens' front 60 degrees",
               {required(corner("lower_left", "a corner as seen from the front")),
                required(corner("lower_right", "another")), required(corner("upper_left", "the third"))});
}

}  // namespace carom
