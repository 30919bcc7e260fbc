#include "app/rig/rig.h"

#include <algorithm>
#include <array>

#include "app/file_keys/rig_keys.h"
#include "app/rig/rig_checks.h"
#include "app/rig/rig_headset.h"
#include "app/rig/rig_nodes.h"
#include "app/rig/rig_trackers.h"
#include "app/rig/rig_viewers.h"
#include "app/rig/rig_walls.h"
#include "app/toml/config_folder.h"
#include "app/toml/toml_file.h"
#include "app/toml/toml_values.h"

namespace carom {

namespace {

double readUnit_m(const TomlTable& root) {
  // An unknown unit falls back to the first, the smallest.
  return kMetresPerUnit[root.choice("unit")];
}

RoomAxes readAxes(const TomlTable& root) {
  const std::array<RoomAxes, 2> axes{RoomAxes{.right = {1, 0, 0}, .up = {0, 1, 0}, .forward = {0, 0, -1}},
                                     RoomAxes{.right = {1, 0, 0}, .up = {0, 0, 1}, .forward = {0, 1, 0}}};
  return axes[root.choice("axes")];
}

bool isOfAHead(std::size_t tracker, const Rig& rig) {
  return std::any_of(rig.viewers.begin(), rig.viewers.end(),
                     [&](const ViewerSetup& viewer) { return viewer.head.sensor.tracker == tracker; });
}

/// Returns the playlist that a rig names: beside the rig's file, or a shipped one by its bare name. Whether
/// it is there matters only to a session that plays it.
std::filesystem::path playlistOf(const std::filesystem::path& rig, const std::string& name) {
  if (name.empty()) return {};
  const std::filesystem::path known = shippedFile(name, "playlists");
  return known == name ? rig.parent_path() / name : known;
}

LinkSetup readLink(const TomlTable& table, const std::filesystem::path& rig) {
  LinkSetup link;
  link.name = table.text("name");
  link.key = rig.parent_path() / table.text("key");
  link.with = table.text("with", "");
  if (table.has("apart_m") && !table.isOneOfTexts("apart_m")) link.apart_m = table.number("apart_m");
  link.reach_m = table.number("reach_m");
  link.gone_s = table.number("gone_s");
  return link;
}

PlacedRig readPlacedRig(const TomlFile& file, const std::filesystem::path& path) {
  const TomlTable& root = file.root();
  PlacedRig placed;
  const double unit_m = placed.unit_m = readUnit_m(root);
  Rig& rig = placed.rig;
  rig.title = root.text("title", path.stem().string());
  rig.axes = readAxes(root);
  rig.display_hz = root.number("display_hz");
  rig.frameLock = static_cast<FrameLock>(root.choice("frame_lock"));
  rig.playlist = playlistOf(path, root.text("playlist", ""));
  rig.language = readLanguage(root, path.parent_path());
  rig.languages = readLanguages(root, path.parent_path());
  if (const auto headset = root.table("headset")) {
    readHeadset(root, *headset, unit_m, rig);
    placed.head = placed.eyeSeparation = headset->place();
  }
  std::uint64_t simulated = 0;  // the first simulated person has the seed of one who is alone
  for (const TomlTable& table : root.tables("tracker")) {
    TrackerSetup& tracker = rig.trackers.emplace_back(readTracker(file, table, unit_m, rig.axes));
    if (tracker.kind == TrackerKind::simulated) tracker.seed = ++simulated;
  }
  if (!isHeadset(rig)) rig.viewers = readViewers(root, rig.trackers, unit_m, path.parent_path());
  followForceDevices(rig);
  const std::vector<TomlTable> viewers = root.tables("viewer", kMostNamedViewers);
  if (const auto head = viewers.empty() ? root.table("head") : viewers.front()) {
    placed.head = head->place();
    placed.eyeSeparation = head->place("eye_separation");
  }
  for (const TomlTable& table : root.tables("node")) {
    rig.nodes.push_back(readNode(table));
    placed.nodes.push_back(table.place());
  }
  if (const auto comfort = root.table("comfort")) {
    rig.comfort.most_u = readMost_u(*comfort);
    rig.comfort.aids = comfort->flag("aids");
  }
  if (const auto table = root.table("spacetime")) rig.spacetime = readSpacetime(*table, placed.unit_m);
  if (const auto link = root.table("link")) rig.link = readLink(*link, path);
  if (const auto phones = root.table("class"))
    rig.classroom = {phones->text("address", ""), static_cast<std::uint16_t>(phones->integer("port"))};
  if (const auto start = root.table("start")) rig.start = readStart(*start);
  if (const auto window = root.table("one_window")) rig.oneWindow = readWindow(*window);
  if (const auto console = root.table("console")) {
    if (const auto window = console->requiredTable("window")) rig.console = readWindow(*window);
  }

  if (isHeadset(rig)) {
    placeEyes(rig);
    const FilePlace at = placed.head;
    placed.walls.assign(rig.walls.size(), {at, at, at, at, at, at, at});
    file.throwFaults();
    return placed;
  }
  std::vector<WallText> walls;
  for (const TomlTable& table : root.tables("wall")) {
    walls.push_back(readWall(file, table, rig.axes, unit_m, rig.oneWindow.has_value()));
    readEyes(table, rig.viewers, walls.back().wall);
    placed.walls.push_back(placesOf(table));
  }
  rig.panel = readPanel(root, unit_m);
  if (walls.empty()) root.fault("wall", "there is no wall here, expected one [[wall]] at least");
  file.throwFaults();
  for (WallText& text : walls) {
    straighten(text);
    if (text.screen) {
      if (const auto fault = curve(*text.screen, rig.axes, text.wall)) refuseScreen(*fault, text.table);
    }
    rig.walls.push_back(text.wall);
  }
  file.throwFaults();
  for (const ViewerSetup& viewer : rig.viewers) {
    if (viewer.hand && viewer.hand->buttons && !isOfAHead(*viewer.hand->buttons, rig))
      rig.trackers[*viewer.hand->buttons].buttonsAlone = true;
  }
  settlePanel(root, rig);
  checkTogether(root, rig, walls);
  checkViewers(root, rig, walls);
  holdBackTheFast(rig, root.tables("wall"));
  file.throwFaults();
  return placed;
}

}  // namespace

Rig readRig(const std::filesystem::path& path) { return readPlacedRig(path).rig; }

Rig readRig(const std::filesystem::path& path, const std::string& kept, const std::filesystem::path& root) {
  return readPlacedRig(TomlFile(path, rigKeys(), kept, root), path).rig;
}

PlacedRig readPlacedRig(const std::filesystem::path& path) {
  return readPlacedRig(TomlFile(path, rigKeys()), path);
}

}  // namespace carom
