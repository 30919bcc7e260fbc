#include "app/tools/import.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <set>
#include <stdexcept>

#include "app/room_import/pvx_file.h"
#include "app/room_import/room_check.h"
#include "app/room_import/sgct_file.h"
#include "engine/base/log.h"
#include "engine/base/whole_file.h"

namespace carom {

namespace {

/// Returns a length in metres rounded to a thousandth of a millimetre.
std::string metres(double length_m) {
  std::string text = fmt::format("{:.6f}", length_m);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text += '0';
  return text == "-0.0" ? "0.0" : text;
}

std::string vectorText(const glm::dvec3& v) {
  return fmt::format("[{}, {}, {}]", metres(v.x), metres(v.y), metres(v.z));
}

std::string tomlText(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// Moves the room so that the origin is on the floor below the viewer, as rigs require.
void putOnFloor(Room& room) {
  const auto floor_m = floorHeight_m(room);
  const glm::dvec3 up = room.axes.up;
  const double eyes_m = glm::dot(room.viewers.front().eyes_m, up);
  const glm::dvec3 beneath_m = room.viewers.front().eyes_m - eyes_m * up;
  const glm::dvec3 shift_m = -beneath_m + (floor_m ? -*floor_m : kStandingEyes_m - eyes_m) * up;
  for (RoomWall& wall : room.walls) {
    wall.wall.lowerLeft_m += shift_m;
    wall.wall.lowerRight_m += shift_m;
    wall.wall.upperLeft_m += shift_m;
  }
  room.viewers.front().eyes_m += shift_m;
  room.floor_m = 0.0;
  if (!floor_m) {
    room.assumptions.push_back(
        fmt::format("no wall is a floor; the viewer's eyes are {:.0f} mm above it", kStandingEyes_m * 1e3));
  }
  if (glm::length(shift_m) > 0.0) {
    room.assumptions.push_back(
        fmt::format("everything is moved by {} m, so that the origin is on the floor beneath the viewer",
                    vectorText(shift_m)));
  }
}

/// Removes the displays unless they differ between ranks.
void keepDisplays(Room& room) {
  std::set<std::string> displays;
  for (const NodeSetup& node : room.nodes) displays.insert(node.display);
  if (displays.size() > 1) return;
  if (!displays.empty()) {
    room.assumptions.push_back(
        fmt::format("every rank draws on the display that it finds: the file names {} for all of them",
                    *displays.begin()));
  }
  room.nodes.clear();
}

std::string headText(const Room& room) {
  std::string text = fmt::format(
      "title = {}\nunit = \"m\"\naxes = \"x-right y-up z-back\"\ndisplay_hz = 60.0\n", tomlText(room.title));
  if (room.oneWindow) {
    const WindowPlacement& window = *room.oneWindow;
    text +=
        fmt::format("\n[one_window]\nmonitor = {}\nposition = [{}, {}]\nsize = [{}, {}]\nfullscreen = {}\n",
                    window.monitor, window.position_px.x, window.position_px.y, window.size_px.x,
                    window.size_px.y, window.fullscreen);
  }
  text += fmt::format("\n[head]\ntracker = \"person\"\nsensor = 0\neye_separation = {}\n",
                      metres(room.eyeSeparation_m));
  text += fmt::format(
      "\n[[tracker]]\nname = \"person\"\nkind = \"simulated\"\n"
      "room_from_tracker = {{ translation = {}, rotation_deg = [0, 0, 0] }}\n",
      vectorText(room.viewers.front().eyes_m - kStandingEyes_m * room.axes.up));
  for (const NodeSetup& node : room.nodes) {
    text += fmt::format("\n[[node]]\nrank = {}\ndisplay = {}\n", node.rank, tomlText(node.display));
  }
  return text;
}

std::string wallText(const Wall& wall) {
  const WindowPlacement& window = wall.window;
  std::string text = fmt::format(
      "\n[[wall]]\nname = {}\nlower_left = {}\nlower_right = {}\nupper_left = {}\npixels = [{}, {}]\nnode = "
      "{}\n"
      "window = {{ monitor = {}, position = [{}, {}], size = [{}, {}], fullscreen = {} }}\nstereo = \"{}\"\n",
      tomlText(wall.name), vectorText(wall.lowerLeft_m), vectorText(wall.lowerRight_m),
      vectorText(wall.upperLeft_m), wall.pixels.x, wall.pixels.y, wall.node, window.monitor,
      window.position_px.x, window.position_px.y, window.size_px.x, window.size_px.y, window.fullscreen,
      toString(wall.stereo));
  if (wall.flip != Flip::none) text += fmt::format("flip = \"{}\"\n", toString(wall.flip));
  return text;
}

std::string rigText(const Room& room) {
  std::string text = fmt::format("# Made of {} by carom import. What it assumed:\n",
                                 printable(room.file.filename().string()));
  for (const std::string& assumption : room.assumptions) text += fmt::format("# - {}\n", assumption);
  text += headText(room);
  for (const RoomWall& wall : room.walls) text += wallText(wall.wall);
  return text;
}

}  // namespace

bool isForeignRoom(const std::filesystem::path& file) {
  return file.extension() == ".pvx" || file.extension() == ".json";
}

Room readForeignRoom(const std::filesystem::path& file) {
  return file.extension() == ".pvx" ? readPvx(file) : readSgct(file);
}

std::vector<Finding> findingsOf(const Room& room) {
  std::vector<Finding> findings = room.findings.all();
  const std::vector<Finding> judged = judgeRoom(room);
  findings.insert(findings.end(), judged.begin(), judged.end());
  return findings;
}

bool printFindings(const std::filesystem::path& file, const std::vector<Finding>& findings) {
  bool failed = false;
  for (const Finding& finding : toldOf(findings)) {
    const bool error = finding.kind == Finding::Kind::error;
    failed = failed || error;
    const std::string line =
        fmt::format("{}:{}:{}: {}", file.string(), finding.at.line, finding.at.column, finding.text);
    error ? log::error(line) : log::warn(line);
  }
  return failed;
}

int runImport(const ImportOptions& options) {
  if (!isForeignRoom(options.file)) {
    throw InputErrors(
        {InputError(options.file.string(), 1, 1,
                    "this is no room of another program, expected a .pvx of ParaView or a .json of SGCT")});
  }
  Room room = readForeignRoom(options.file);
  if (printFindings(options.file, findingsOf(room))) return 1;
  putOnFloor(room);
  keepDisplays(room);
  room.assumptions.push_back("no tracker is taken over: a simulated person walks about where the viewer is");
  room.assumptions.push_back("the displays run at 60 Hz");
  const std::string text = rigText(room);
  std::error_code failed;
  if (options.rig != "-" && std::filesystem::exists(std::filesystem::symlink_status(options.rig, failed))) {
    throw std::runtime_error(fmt::format(
        "{} is there already, expected a new file: rigs are measured by hand", options.rig.string()));
  }
  readRig(options.rig, text);  // throws if the written rig would be refused
  WholeFile(options.rig).commit(text);
  for (const std::string& assumption : room.assumptions) log::note(fmt::format("assumed: {}", assumption));
  return 0;
}

void addImport(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("import", "Turn another program's room file into a rig");
  auto options = std::make_shared<ImportOptions>();
  command->add_option("FILE", options->file, ".pvx of ParaView or .json of SGCT")->required();
  command->add_option("-o,--output", options->rig, "The rig to write; must not exist. - is standard output")
      ->required()
      ->type_name("RIG.toml");
  command->footer("Example:\n  carom import cave.pvx -o cave.toml");
  command->callback([options, &status] { status = runImport(*options); });
}

}  // namespace carom
