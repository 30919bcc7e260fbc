#include "app/room_formats/mpcdi_file.h"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/room_checks/foreign_room.h"
#include "app/room_formats/mpcdi_archive.h"
#include "app/room_formats/mpcdi_frustum.h"
#include "app/room_formats/mpcdi_picture.h"
#include "app/room_import/xml_tree.h"
#include "app/room_parts/part.h"
#include "app/room_parts/room_parts.h"
#include "cave/mesh_files/pfm_file.h"
#include "cave/mesh_files/screen_file.h"
#include "cave/mesh_files/vwf_file.h"
#include "engine/base/limits.h"
#include "engine/text/outside_file.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

constexpr std::size_t kMostMap = std::size_t{128} << 20U;

/// Marks parts as read that say nothing of a room, or only in some profiles.
void markKnown(const Part& part, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) part.find(name);
}

enum class Profile { flat, angles, screen };

/// A projector: its part of a buffer, and the files for it.
struct Region {
  const Part* part = nullptr;
  const Part* buffer = nullptr;
  const Part* files = nullptr;  ///< null: there are none
  std::string id;
};

/// Returns the part with the warp of a region; null if there is none.
const Part* warpOfRegion(const Region& region) {
  const Part* warp = region.files ? region.files->find("geometryWarpFile") : nullptr;
  if (warp) warp->find("interpolation");
  return warp;
}

/// Returns the length of the unit of a file; none, with an error noted, for another one.
std::optional<double> unitOf(const Part& warp, Room& room) {
  constexpr std::array<std::pair<std::string_view, double>, 5> kUnits{
      {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}, {"ft", 0.3048}}};
  const std::string unit = warp.textOf("geometricUnit");
  for (const auto& [name, metres] : kUnits)
    if (alike(unit, name)) return metres;
  addError(room, warp.placeOf("geometricUnit"),
           fmt::format("the unit is '{}', expected mm, cm, m, in or ft", printable(unit)));
  return {};
}

class MpcdiReading {
 public:
  MpcdiReading(const MpcdiArchive& archive, const Part& root, Profile profile, Room& room)
      : archive_(archive), root_(root), profile_(profile), room_(room) {}

  void read() {
    for (const Region& region : regions()) readRegion(region);
    constexpr std::array<std::string_view, 6> kQuietMpcdi{"date",     "level", "version",
                                                          "geometry", "color", "profile"};
    nameUnread(root_, kQuietMpcdi, room_);
  }

 private:
  std::vector<Region> regions() {
    std::vector<Region> all;
    std::vector<const Part*> sets;
    for (const Part* files : root_.all("files"))
      for (const Part* set : files->all("fileset")) sets.push_back(set);
    refuseTwins(sets, "region", room_);
    for (const Part* display : root_.all("display")) {
      for (const Part* buffer : display->all("buffer")) {
        markKnown(*buffer, {"id", "xResolution", "yResolution", "Xresolution", "Yresolution"});
        for (const Part* part : buffer->all("region")) {
          markKnown(*part, {"x", "y", "xsize", "ysize"});
          Region& region = all.emplace_back(Region{part, buffer, nullptr, part->textOf("id")});
          for (const Part* set : sets)
            if (set->textOf("region") == region.id) region.files = set;
        }
      }
    }
    return all;
  }

  void readRegion(const Region& region) {
    RoomWall wall;
    wall.wall.name = region.id.empty() ? "wall" : region.id;
    wall.at.wall = wall.at.name = wall.at.corner = wall.at.pixels = wall.at.window = region.part->at;
    const auto pixels = mpcdiPixels(*region.part, room_);
    if (!pixels) return;
    wall.wall.pixels = wall.wall.window.size_px = *pixels;
    wall.wall.window.position_px.x = nextWindow_px_;
    nextWindow_px_ += pixels->x;
    stem_ = fmt::format("{}-{}", printable(room_.file.stem().stem().string()), rigName(room_, region.id));
    if (profile_ != Profile::screen) wall.wall.warp = warpOf(region);
    readBlend(region, wall.wall);
    if (profile_ == Profile::screen)
      addScreen(region, std::move(wall));
    else
      addFlat(region, std::move(wall));
  }

  /// Adds a file that goes beside the rig; returns its name.
  std::filesystem::path keep(const std::string& ending, std::string content) {
    room_.files.push_back({stem_ + ending, std::make_shared<const std::string>(std::move(content))});
    return room_.files.back().name;
  }

  /// Returns the content of the file that a part names by its path; none, with an error noted, without it.
  std::optional<std::string> mapOf(const Part& map) {
    try {
      return archive_.contentOf(map.textOf("path"), kMostMap);
    } catch (const std::runtime_error& fault) {
      addError(room_, map.placeOf("path"), fault.what());
      return {};
    }
  }

  void addScreen(const Region& region, RoomWall wall) {
    const Part* warp = warpOfRegion(region);
    if (!warp)
      return addError(room_, region.part->at,
                      fmt::format("region '{}' has no geometryWarpFile, expected the places of its screen",
                                  printable(region.id)));
    auto content = mapOf(*warp);
    const auto unit_m = unitOf(*warp, room_);
    if (!content || !unit_m) return;
    placeOrigin(*warp);
    MeasuredScreen screen;
    screen.isGrid = true;
    screen.unit_m = *unit_m;
    screen.file = keep(".pfm", std::move(*content));
    screen.bytes = room_.files.back().content;
    addCurvedWall(std::move(wall), screen, room_);
  }

  /// Notes where the viewer and the floor are, by what the origin of the places is.
  void placeOrigin(const Part& warp) {
    const std::string origin = warp.textOf("originof3DData");
    const bool isFloor = alike(origin, "floorCenter"), isEyes = alike(origin, "idealEyePoint");
    if (isFloor) room_.floor_m = 0.0;
    if (isEyes && room_.viewers.empty())
      room_.viewers.push_back({glm::dvec3(0.0), warp.at, "the ideal eye point"});
    if (!isFloor && !isEyes)
      addWarning(room_, warp.placeOf("originof3DData"),
                 fmt::format("the origin is '{}', which says nothing of the floor: it is taken to be on it",
                             printable(origin)));
  }

  /// Returns the name of the warp of a flat picture, written as the .vwf that a rig reads; empty if there is
  /// none, or, with an error noted, none that can be read.
  std::filesystem::path warpOf(const Region& region) {
    const Part* warp = warpOfRegion(region);
    if (!warp) return {};
    for (const char* ofScreens : {"geometricUnit", "originof3DData"}) warp->find(ofScreens);
    const auto content = mapOf(*warp);
    if (!content) return {};
    try {
      const PfmGrid grid = parsePfm(*content, false, kMostGridPoints);
      std::vector<glm::vec2> inPicture;
      for (std::size_t row = grid.rows; row-- > 0;) {  // from the window's top
        for (std::size_t column = 0; column < grid.columns; ++column) {
          const glm::vec3 place = grid.point(column, row);
          inPicture.emplace_back(place.x, 1.0F - place.y);
        }
      }
      const glm::ivec2 size(static_cast<int>(grid.columns), static_cast<int>(grid.rows));
      std::string bytes = vwfOf(size, inPicture);
      carom::warpOf(parseVwf(bytes));  // throws if it cannot be drawn
      return keep(".vwf", std::move(bytes));
    } catch (const std::runtime_error& fault) {
      addError(room_, warp->placeOf("path"),
               fmt::format("'{}': {}", printable(warp->textOf("path")), fault.what()));
      return {};
    }
  }

  void readBlend(const Region& region, Wall& wall) {
    if (!region.files) return;
    for (const Part* other : region.files->all("distortionMap")) leaveOut(*other, "distortion map");
    for (const Part* black : region.files->all("betaMap"))
      leaveOut(*black, "map of black levels: a rig has one black_level for a wall");
    const Part* alpha = region.files->find("alphaMap");
    if (!alpha) return;
    for (const char* known : {"componentDepth", "bitDepth"}) alpha->find(known);
    constexpr Range kGamma{.least = 0.1, .most = 10.0};
    const auto content = mapOf(*alpha);
    const double gamma = number(*alpha, "gammaEmbedded", kGamma, false, room_).value_or(1.0);
    if (!content) return;
    try {
      wall.blend = keep(".png", linearPicture(*content, gamma));
    } catch (const std::runtime_error& fault) {
      addError(room_, alpha->placeOf("path"),
               fmt::format("'{}': {}", printable(alpha->textOf("path")), fault.what()));
    }
  }

  void leaveOut(const Part& map, std::string_view what) {
    map.markRead();
    addWarning(room_, map.at, fmt::format("'{}' is left out, a {}", printable(map.textOf("path")), what));
  }

  void addFlat(const Region& region, RoomWall wall) {
    const auto corners = profile_ == Profile::angles ? cornersByAngles(*region.part, room_)
                                                     : cornersByShare(*region.part, *region.buffer, room_);
    if (!corners) return;
    addWarning(room_, region.part->at,
               fmt::format(
                   "the picture of region '{}' is right from one place only, {}: a tracked person needs the "
                   "screen itself, which the profile a3 has",
                   printable(region.id),
                   profile_ == Profile::angles ? "the point of its frustum" : "which the file does not say"));
    addWall(std::move(wall), *corners, room_);
  }

  const MpcdiArchive& archive_;
  const Part& root_;
  Profile profile_;
  Room& room_;
  std::string stem_;
  int nextWindow_px_ = 0;
};

void stateAssumptions(Profile profile, Room& room) {
  room.assumptions.push_back(
      "axes are x right, y up, z back, as MPCDI has them; all projectors are on one computer, "
      "their windows side by side");
  if (profile == Profile::screen) return;
  room.assumptions.push_back(
      "places in the picture count from its lower left, and rows of a PFM from the window's bottom");
  room.assumptions.push_back(
      profile == Profile::angles
          ? fmt::format("lengths are metres; the file gives angles: the walls stand {:g} m from their points",
                        kMpcdiAway_m)
          : fmt::format("the file says nothing of the room: the picture is {:g} m high, {:g} m ahead, at the "
                        "height of "
                        "the eyes",
                        kMpcdiHeight_m, kMpcdiAway_m));
}

}  // namespace

bool isMpcdi(const std::filesystem::path& file) {
  if (file.extension() == ".mpcdi") return true;
  if (!refusalOf(file, InputKind::mpcdi).empty()) return false;
  const std::string beginning = beginningOf(file, InputKind::mpcdi, 4096);
  return beginning.starts_with("PK\x03\x04") || beginning.find("<MPCDI") != std::string::npos;
}

Room readMpcdi(const std::filesystem::path& file) {
  const MpcdiArchive archive(file);
  const XmlElement root = parseXml(file, archive.description(), Doctype::none).root;
  Room room = roomOfFormat(file, "an MPCDI room", "m", 1.0);
  if (!alike(root.name, "MPCDI")) {
    addError(room, root.at, fmt::format("the first element is <{}>, expected <MPCDI>", printable(root.name)));
  } else {
    const Part whole = partOf(root);
    const std::string profile = whole.textOf("profile");
    constexpr std::array<std::pair<std::string_view, Profile>, 3> kProfiles{
        {{"2d", Profile::flat}, {"3d", Profile::angles}, {"a3", Profile::screen}}};
    for (const auto& [name, kind] : kProfiles) {
      if (!alike(profile, name)) continue;
      MpcdiReading(archive, whole, kind, room).read();
      stateAssumptions(kind, room);
      finishRoom("a region in a buffer of a display", room, root.at);
      return room;
    }
    addError(
        room, whole.placeOf("profile"),
        alike(profile, "sl")
            ? std::string(
                  "the profile sl gives poses of projectors and no surface to draw on, expected a3, 3d or 2d")
            : fmt::format("the profile is '{}', expected a3, 3d or 2d", printable(profile)));
  }
  room.viewers.push_back({});
  return room;
}

}  // namespace carom
