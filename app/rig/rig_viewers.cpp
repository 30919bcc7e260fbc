#include "app/rig/rig_viewers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "app/rig/rig_trackers.h"
#include "app/toml/toml_values.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall_eyes.h"

namespace carom {
namespace {

/// Reads a hand, which names a tracker, or has a force device, or both.
void readHandOf(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m,
                ViewerSetup& viewer) {
  viewer.force = readForce(table, unit_m);
  if (table.has("tracker") || !viewer.force) {
    viewer.hand = readHand(table, trackers, unit_m);
    return;
  }
  for (const char* key : {"sensor", "buttons", "hand_from_sensor"})
    table.refuse(key, "is that of a tracker, expected a tracker, too");
}

ViewerSetup readViewer(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m,
                       const std::filesystem::path& folder) {
  ViewerSetup viewer;
  viewer.name = table.text("name");
  const bool plain = std::all_of(viewer.name.begin(), viewer.name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
  if (!plain)
    table.fault("name", fmt::format("name is '{}', expected letters, digits, - and _ only", viewer.name));
  viewer.head = readHead(table, trackers, unit_m);
  if (const auto hand = table.table("hand")) readHandOf(*hand, trackers, unit_m, viewer);
  viewer.language = readLanguage(table, folder);
  return viewer;
}

/// Returns the eye that a text such as "left", "anna.left" or "anna.middle" names, or nothing.
std::optional<ViewerEye> eyeNamed(std::string_view text, const std::vector<ViewerSetup>& viewers,
                                  std::size_t viewerOfWall) {
  ViewerEye named{viewerOfWall};
  const std::size_t dot = text.find('.');
  if (dot != std::string_view::npos) {
    const auto found = std::find_if(viewers.begin(), viewers.end(), [&](const ViewerSetup& viewer) {
      return viewer.name == text.substr(0, dot);
    });
    if (found == viewers.end()) return {};
    named.viewer = static_cast<std::size_t>(found - viewers.begin());
    text = text.substr(dot + 1);
  }
  if (text != "left" && text != "middle" && text != "right") return {};
  named.eye = text == "left" ? Eye::left : text == "right" ? Eye::right : Eye::middle;
  return named;
}

std::string quotedNamesOf(const std::vector<ViewerSetup>& viewers) {
  return fmt::format("'{}'", fmt::join(namesOf(viewers), "' or '"));
}

std::string nameOf(const ViewerEye& eye, const std::vector<ViewerSetup>& viewers) {
  return fmt::format("{}.{}", viewers[eye.viewer].name, nameOf(eye.eye));
}

/// The eyes that see one screen, each with the wall that shows it.
struct Screen {
  struct Shown {
    ViewerEye eye;
    std::size_t wall;
  };
  std::size_t firstWall = 0;
  std::vector<Shown> shown;
};

std::vector<Screen> screensOf(const Rig& rig) {
  std::vector<Screen> screens;
  for (std::size_t wall = 0; wall < rig.walls.size(); ++wall) {
    auto screen = std::find_if(screens.begin(), screens.end(), [&](const Screen& other) {
      return standSame(rig.walls[other.firstWall], rig.walls[wall]);
    });
    if (screen == screens.end()) screen = screens.insert(screens.end(), {wall, {}});
    for (const ViewerEye& eye : eyesOf(rig.walls[wall])) screen->shown.push_back({eye, wall});
  }
  return screens;
}

/// Checks what one viewer sees of a screen. Returns whether the viewer sees it at all.
bool checkScreen(const Rig& rig, const Screen& screen, std::size_t viewer,
                 const std::vector<WallText>& walls) {
  std::array<int, 3> times{};               // of each eye
  std::size_t ofViewer = screen.firstWall;  // a wall of the screen that shows one
  for (const Screen::Shown& shown : screen.shown) {
    if (shown.eye.viewer != viewer) continue;
    ofViewer = shown.wall;
    if (++times[static_cast<std::size_t>(shown.eye.eye)] == 2) {
      walls[shown.wall].table.fault(
          "eyes", fmt::format("wall '{}' shows {} on the screen of wall '{}', which shows this eye already, "
                              "expected each eye once on a screen",
                              rig.walls[shown.wall].name, nameOf(shown.eye, rig.viewers),
                              rig.walls[screen.firstWall].name));
    }
  }
  const bool left = times[static_cast<std::size_t>(Eye::left)] > 0,
             right = times[static_cast<std::size_t>(Eye::right)] > 0,
             both = times[static_cast<std::size_t>(Eye::middle)] > 0;
  if (left != right && !both) {
    const WallText& wall = walls[ofViewer];
    wall.table.fault(
        wall.table.has("eyes") ? "eyes" : "stereo",
        fmt::format("viewer '{}' sees the screen of wall '{}' with the {} eye only, expected both",
                    rig.viewers[viewer].name, rig.walls[ofViewer].name, left ? "left" : "right"));
  }
  return left || right || both;
}

}  // namespace

std::vector<std::string> namesOf(const std::vector<ViewerSetup>& viewers) {
  std::vector<std::string> names;
  for (const ViewerSetup& viewer : viewers) names.push_back(viewer.name);
  return names;
}

std::vector<ViewerSetup> readViewers(const TomlTable& root, const std::vector<TrackerSetup>& trackers,
                                     double unit_m, const std::filesystem::path& folder) {
  std::vector<ViewerSetup> viewers;
  const std::vector<TomlTable> tables = root.tables("viewer", kMostNamedViewers);
  for (const TomlTable& table : tables) {
    ViewerSetup viewer = readViewer(table, trackers, unit_m, folder);
    const auto same = std::find_if(viewers.begin(), viewers.end(),
                                   [&](const ViewerSetup& other) { return other.name == viewer.name; });
    if (same != viewers.end()) {
      const TomlTable& other = tables[static_cast<std::size_t>(same - viewers.begin())];
      table.fault("name", fmt::format("the name '{}' is taken in line {}, expected another", viewer.name,
                                      other.place("name").line));
    }
    viewers.push_back(std::move(viewer));
  }
  if (viewers.size() > kMostViewers) {
    tables[kMostViewers].fault(
        tables[kMostViewers].place(),
        fmt::format("this is viewer {}, expected at most {} in a room", kMostViewers + 1, kMostViewers));
  }
  if (!viewers.empty()) {
    root.refuse("head", "is the head of the one viewer of a room without [[viewer]], expected none");
    root.refuse("hand", "is the hand of the one viewer of a room without [[viewer]], expected none");
    return viewers;
  }
  ViewerSetup& alone = viewers.emplace_back();
  if (const auto head = root.requiredTable("head")) alone.head = readHead(*head, trackers, unit_m);
  if (const auto hand = root.table("hand")) readHandOf(*hand, trackers, unit_m, alone);
  return viewers;
}

void readEyes(const TomlTable& table, const std::vector<ViewerSetup>& viewers, Wall& wall) {
  if (table.has("viewer")) {
    const std::string name = table.text("viewer");
    const auto found = std::find_if(viewers.begin(), viewers.end(),
                                    [&](const ViewerSetup& viewer) { return viewer.name == name; });
    if (found == viewers.end()) {
      table.fault("viewer",
                  fmt::format("there is no viewer '{}', expected {}", name, quotedNamesOf(viewers)));
    } else {
      wall.viewer = static_cast<std::size_t>(found - viewers.begin());
    }
  } else if (viewers.size() > 1 && !table.has("eyes")) {
    table.fault(table.place(), fmt::format("wall '{}' does not say whose eyes it shows, expected viewer = {}",
                                           wall.name, quotedNamesOf(viewers)));
  }
  if (!table.has("eyes")) return;
  const std::size_t channels = eyesOf(wall.stereo).size();
  const std::vector<PlacedText> names = table.texts("eyes");
  for (const PlacedText& text : names) {
    if (const auto eye = eyeNamed(text.text, viewers, wall.viewer)) {
      wall.eyes.push_back(*eye);
    } else {
      table.fault(text.place,
                  fmt::format("eyes has '{}', expected 'left', 'right', 'middle' or a viewer's, such as "
                              "'{}.left'",
                              text.text, viewers.front().name));
    }
  }
  const bool ofSeveral = std::any_of(wall.eyes.begin(), wall.eyes.end(), [&](const ViewerEye& eye) {
    return eye.viewer != wall.eyes.front().viewer;
  });
  for (std::size_t i = 0; ofSeveral && i < wall.eyes.size(); ++i)
    wall.pictureNames.push_back(fmt::format("{}-{}", wall.name, viewers[wall.eyes[i].viewer].name));
  if (wall.stereo == StereoMode::mono) {
    table.fault("eyes", "a wall with one picture for both eyes has no channels, expected no eyes");
  } else if (names.size() != channels) {
    table.fault("eyes",
                fmt::format("eyes has {} name{}, expected one for each of the {} channels of '{}'",
                            names.size(), names.size() == 1 ? "" : "s", channels, toString(wall.stereo)));
  }
}

void checkViewers(const TomlTable& root, const Rig& rig, const std::vector<WallText>& walls) {
  if (rig.viewers.size() < 2) return;
  const std::vector<TomlTable> tables = root.tables("viewer");
  for (std::size_t i = 0; i < rig.viewers.size(); ++i) {
    const ViewerSetup& viewer = rig.viewers[i];
    for (std::size_t j = 0; j < i; ++j) {
      const ViewerSetup& other = rig.viewers[j];
      if (other.head.sensor == viewer.head.sensor)
        tables[i].fault(
            "sensor", fmt::format("viewers '{}' and '{}' have one sensor of tracker '{}', expected one each",
                                  other.name, viewer.name, rig.trackers[viewer.head.sensor.tracker].name));
    }
  }
  const std::vector<Screen> screens = screensOf(rig);
  for (std::size_t viewer = 0; viewer < rig.viewers.size(); ++viewer) {
    bool sees = false;
    for (const Screen& screen : screens) sees = checkScreen(rig, screen, viewer, walls) || sees;
    if (!sees)
      tables[viewer].fault(tables[viewer].place(),
                           fmt::format("no wall shows the eyes of viewer '{}', expected "
                                       "one [[wall]] at least with viewer = '{}'",
                                       rig.viewers[viewer].name, rig.viewers[viewer].name));
  }
}

std::vector<std::string> sightsOf(const Rig& rig, std::size_t viewer) {
  std::vector<std::string> sights;
  for (const Screen& screen : screensOf(rig)) {
    std::vector<std::string> shown;
    for (const Screen::Shown& picture : screen.shown) {
      if (picture.eye.viewer != viewer) continue;
      const char* eye = picture.eye.eye == Eye::middle ? "both eyes" : nameOf(picture.eye.eye);
      shown.push_back(fmt::format("{} ({})", rig.walls[picture.wall].name, eye));
    }
    const std::string& name = rig.walls[screen.firstWall].name;
    sights.push_back(shown.empty() ? fmt::format("sees nothing on the screen of {}", name)
                                   : fmt::format("sees {}", fmt::join(shown, ", ")));
  }
  return sights;
}

namespace {

/// Keeps the channels of a wall that show the first viewer's eyes. Returns whether there are any.
bool keepFirstViewer(Wall& wall) {
  if (wall.eyes.empty()) return wall.viewer == 0;
  const std::size_t channels = wall.eyes.size();
  for (std::size_t i = wall.eyes.size(); i-- > 0;) {
    if (wall.eyes[i].viewer == 0) continue;
    wall.eyes.erase(wall.eyes.begin() + static_cast<std::ptrdiff_t>(i));
    if (!wall.pictureNames.empty())
      wall.pictureNames.erase(wall.pictureNames.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (wall.eyes.size() < channels && !wall.eyes.empty())
    wall.stereo = wall.eyes.front().eye == Eye::left    ? StereoMode::left
                  : wall.eyes.front().eye == Eye::right ? StereoMode::right
                                                        : StereoMode::mono;
  wall.viewer = 0;
  return !wall.eyes.empty();
}

}  // namespace

Rig rigFor(Rig rig, const std::string& viewer) {
  const auto found = std::find_if(rig.viewers.begin(), rig.viewers.end(),
                                  [&](const ViewerSetup& setup) { return setup.name == viewer; });
  const std::size_t chosen =
      found == rig.viewers.end() ? 0 : static_cast<std::size_t>(found - rig.viewers.begin());
  std::swap(rig.viewers.front(), rig.viewers[chosen]);
  const auto swapped = [chosen](std::size_t index) {
    return index == 0 ? chosen : index == chosen ? 0 : index;
  };
  for (Wall& wall : rig.walls) {
    wall.viewer = swapped(wall.viewer);
    for (ViewerEye& eye : wall.eyes) eye.viewer = swapped(eye.viewer);
  }
  std::erase_if(rig.walls, [](Wall& wall) { return !keepFirstViewer(wall); });
  return rig;
}

}  // namespace carom
