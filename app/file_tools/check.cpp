#include "app/file_tools/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/file_tools/check_translation.h"
#include "app/file_tools/import.h"
#include "app/nodes/mpirun_line.h"
#include "app/operator/room_languages.h"
#include "app/rig/rig.h"
#include "app/rig/rig_checks.h"
#include "app/rig/rig_viewers.h"
#include "app/rig/traces.h"
#include "app/room_checks/rig_room.h"
#include "app/room_checks/room_check.h"
#include "app/room_formats/room_kind.h"
#include "app/scenario/playlist.h"
#include "app/scenario/scenario.h"
#include "app/study/study.h"
#include "app/study_data/retention.h"
#include "app/toml/config_folder.h"
#include "app/toml/toml_file.h"
#include "app/tools/option_values.h"
#include "cave/overlay/band_layout.h"
#include "cave/process/work_budget.h"
#include "devices/setup/force_factory.h"
#include "engine/game/soft_puck_mesh.h"
#include "engine/spacetime/lorentz.h"
#include "engine/text/log.h"

namespace carom {

namespace {

enum class FileKind { scenario, rig, playlist, study, itemBank, foreignRoom, translation };

constexpr std::size_t kMostTold = 100;  // pucks and bodies, one by one

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what) {
  throw InputErrors({InputError(path.string(), 1, 1, what)});
}

/// Opens a TOML file. If a file without that extension cannot be parsed, throws a message about the known
/// file kinds instead of the parser's.
TomlFile openedToml(const std::filesystem::path& path) {
  static const FileKey kAnyFile;
  try {
    return TomlFile(path, kAnyFile);
  } catch (const InputError&) {
    const bool canBeRead =
        refusalOf(path, InputKind::toml).empty() && !beginningOf(path, InputKind::toml, 1).empty();
    if (path.extension() == ".toml" || !canBeRead) throw;
    refuse(path, fmt::format("this is no file of a kind that is known here, expected a .toml of Carom or {}",
                             kForeignRooms));
  }
}

/// Returns the kind of file, from its content.
FileKind kindOf(const std::filesystem::path& path) {
  if (path.extension() == ".po" || path.extension() == ".pot") return FileKind::translation;
  if (isForeignRoom(path)) return FileKind::foreignRoom;
  const TomlFile file = openedToml(path);
  for (const char* key : {"light_speed_m_s", "puck", "body", "board", "physics", "observer", "stroke",
                          "flash", "pulse", "lesson", "tour"}) {
    if (file.contains(key)) return FileKind::scenario;
  }
  for (const char* key : {"wall", "unit", "axes", "head", "tracker", "one_window", "display_hz"}) {
    if (file.contains(key)) return FileKind::rig;
  }
  if (file.contains("game")) return FileKind::playlist;
  for (const char* key : {"arm", "lessons", "participants"}) {
    if (file.contains(key)) return FileKind::study;
  }
  if (file.contains("item")) return FileKind::itemBank;
  refuse(
      path,
      "this is no file of a kind that is known here, expected light_speed_m_s of a scenario, [[wall]] of a "
      "rig, [[game]] of a playlist, [[arm]] of a study or [[item]] of an item bank");
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void tellWalls(const Room& room) {
  for (const RoomWall& wall : room.walls) fmt::print("{}\n", wordsFor(wall, room));
  if (room.oneWindow) {
    fmt::print("all walls in one window of {} × {} pixels\n", room.oneWindow->size_px.x,
               room.oneWindow->size_px.y);
  }
}

/// Prints the first lines about a room of any format.
void tellHead(const Room& room) {
  for (const auto& [eyes_m, at, words] : room.viewers) {
    fmt::print("distances are seen from {}, eyes at ({}, {}, {}) mm\n", words, std::lround(eyes_m.x * 1e3),
               std::lround(eyes_m.y * 1e3), std::lround(eyes_m.z * 1e3));
  }
  for (const NodeSetup& node : room.nodes) {
    fmt::print("rank {}{} draws{}{}\n", node.rank,
               node.slots > 1 ? fmt::format(" to {}", node.rank + node.slots - 1) : "",
               node.host.empty() ? "" : " on " + node.host,
               node.display.empty() ? "" : " on display " + node.display);
  }
}

int tellForeignRoom(const std::filesystem::path& path, const std::string& wanted) {
  const Room room = readForeignRoom(path, wanted);
  const bool failed = printFindings(path, findingsOf(room));
  fmt::print("{}: {} of {}{}\n", room.title, room.format, counted(room.walls.size(), "wall"),
             failed ? " that can be read" : "");
  tellWalls(room);
  fmt::print("head: eyes {:.1f} mm apart\n", room.eyeSeparation_m * 1e3);
  tellHead(room);
  for (const TrackerSetup& tracker : room.trackers)
    fmt::print("tracker {}: {}, from {}\n", tracker.name, toString(tracker.kind), tracker.source.string());
  for (const std::string& assumption : room.assumptions) fmt::print("assumed: {}\n", assumption);
  return failed ? 1 : 0;
}

/// Prints how a viewer is tracked and, where there are several, what this one sees of each screen.
void tellViewer(const Rig& rig, std::size_t viewer) {
  const auto& [name, head, hand, force, language] = rig.viewers[viewer];
  const bool several = rig.viewers.size() > 1;
  const std::string whose = several ? name + "'s " : "";
  fmt::print("{}head: tracker {}, sensor {}, eyes {:.1f} mm apart\n", whose,
             rig.trackers[head.sensor.tracker].name, head.sensor.sensor, head.eyeSeparation_m * 1e3);
  if (hand) {
    const std::string buttons =
        hand->buttons ? ", buttons of tracker " + rig.trackers[*hand->buttons].name : "";
    fmt::print("{}hand: tracker {}, sensor {}{}\n", whose, rig.trackers[hand->tracker].name, hand->sensor,
               buttons);
  }
  if (force) {
    fmt::print("{}{}: {:g} N, {:g} N/m, {:g} m for a unit of rapidity\n", whose, carom::nameOf(*force),
               force->forceMax_n, limitsOf(*force).stiffness_n_m, force->d0_m);
    const std::string lowered = loweredStiffness(*force);
    if (!lowered.empty()) log::warn(lowered);
  }
  if (!several) return;
  for (const std::string& sight : sightsOf(rig, viewer)) fmt::print("{} {}\n", name, sight);
}

/// Opens the meshes of all games of a playlist.
Playlist openPlaylist(const std::filesystem::path& path, const FileOpeners& open) {
  Playlist playlist = readPlaylist(path);
  for (const PlaylistGame& game : playlist.games)
    if (open.meshes) open.meshes(readScenario(game.scenario));
  return playlist;
}

/// Warns of nodes without a host beside others that have one: a room of several computers cannot start so.
void warnOfHosts(const std::filesystem::path& path, const Rig& rig) {
  try {
    hostsOf(rig);
  } catch (const std::runtime_error& missing) {
    log::warn(fmt::format("{}: {}", path.string(), missing.what()));
  }
}

/// Prints in which languages a room has its words, if it names any.
void tellLanguages(const Rig& rig) {
  const SessionLanguages languages = languagesOf(rig, nullptr, "");
  if (languages == SessionLanguages{}) return;
  fmt::print("languages: {}{}\n", fmt::join(languages.all, ", "),
             languages.hasTile ? "; the front wall has a tile for the next one" : "");
  if (rig.viewers.size() < 2) return;
  for (std::size_t viewer = 0; viewer < rig.viewers.size(); ++viewer)
    fmt::print("{} begins in {}\n", rig.viewers[viewer].name, languages.firstOf(viewer));
}

/// Returns whether the room has an error.
bool tellRig(const std::filesystem::path& path, const FileOpeners& open) {
  constexpr std::uintmax_t kMostOfTrace = 16U << 20U;
  const PlacedRig placed = readPlacedRig(path);
  const Rig& rig = placed.rig;
  openTraces(rig, kMostOfTrace);
  if (open.blends) open.blends(path, rig);
  if (!rig.playlist.empty()) openPlaylist(rig.playlist, open);
  const Room room = roomOf(placed, path);
  const bool failed = !isHeadset(rig) && printFindings(path, findingsOf(room));
  fmt::print("{}: a rig of {} at {} Hz\n", rig.title, counted(rig.walls.size(), "wall"), rig.display_hz);
  if (!isHeadset(rig)) tellWalls(room);
  if (rig.panel) {
    const auto words = [](const glm::dvec3& m) {
      return fmt::format("({:.2f}, {:.2f}, {:.2f})", m.x, m.y, m.z);
    };
    fmt::print("words stand on a panel between {}, {} and {} m\n", words(rig.panel->lowerLeft_m),
               words(rig.panel->lowerRight_m), words(rig.panel->upperLeft_m));
  }
  warnOfHosts(path, rig);
  if (const auto warning = warningOf(rig.spacetime, rig))
    log::warn(fmt::format("{}: {}", path.string(), *warning));
  if (isHeadset(rig))
    fmt::print("The walls hang on the head, before the eyes of a headset; a board stands in the room.\n");
  if (rig.comfort.most_u < kMostPlatformU || rig.comfort.aids) {
    fmt::print("comfort: the drive up to {:.4g} c{}\n",
               rig.comfort.most_u / std::hypot(1.0, rig.comfort.most_u),
               rig.comfort.aids ? ", darker edges and a resting frame" : "");
  }
  for (const TrackerSetup& tracker : rig.trackers) {
    const std::string from = tracker.source.empty() ? "" : ", from " + tracker.source.string();
    fmt::print("tracker {}: {}{}\n", tracker.name, toString(tracker.kind), from);
  }
  for (std::size_t viewer = 0; viewer < rig.viewers.size(); ++viewer) tellViewer(rig, viewer);
  tellLanguages(rig);
  tellHead(room);
  return failed;
}

std::string spinText(const Puck& puck, double c_m_s) {
  if (puck.spin_kg_m2_s == 0.0) return "";
  const double u = rimUOf(puck, puck.spin_kg_m2_s, c_m_s), rim = u / std::sqrt(1.0 + u * u);
  return fmt::format(", spins at {:.6g} rad/s, its {} at {:.6g} c", rim * c_m_s / puck.radius_m,
                     puck.outline_m.empty() ? "rim" : "farthest corner", std::abs(rim));
}

/// Returns what a person could not see well in this game.
std::vector<std::string> oddities(const Scenario& scenario) {
  constexpr double kLargest_m = 50.0, kLongest_s = 60.0, kShortest_s = 0.02, kFinest = 0.001;
  std::vector<std::string> odd;
  const BilliardSetup& setup = scenario.billiard;
  double size_m = 3.0;  // of an open plane, what one overlooks
  if (setup.board) {
    size_m = std::max(setup.board->length_m, setup.board->width_m);
    if (size_m > kLargest_m) {
      odd.push_back(fmt::format("the board is {:.3g} m long: it is drawn coarsely, expected at most {} m",
                                size_m, kLargest_m));
    }
  }
  const double light_s = size_m / setup.lightSpeed_m_s;
  if (light_s > kLongest_s)
    odd.push_back(fmt::format("light takes {:.3g} s along the board: what is seen is that old", light_s));
  if (light_s < kShortest_s)
    odd.push_back(fmt::format("light takes {:.2g} s along the board: nothing looks relativistic", light_s));
  for (const Puck& puck : setup.pucks) {
    if (puck.radius_m >= kFinest * size_m) continue;
    odd.push_back(fmt::format("puck {} has a radius of {:.2g} m on a board of {:.3g} m: it is hardly seen",
                              puck.name, puck.radius_m, size_m));
    break;  // one tells enough
  }
  return odd;
}

/// Warns of walls of the shipped rigs whose band cannot show a lesson's texts in letters of their full
/// height.
void checkBand(const std::filesystem::path& path, const Lesson& lesson) {
  for (const auto& entry : std::filesystem::directory_iterator(configFolder() / "rigs")) {
    const std::optional<Wall> front = frontWall(roomGeometryOf(readRig(entry.path())));
    if (!front || bandHolds(lesson.words, lesson.plan, *front)) continue;
    log::warn(fmt::format(
        "{}: the lesson's longest text is longer than the band on the wall '{}' of {}: its letters "
        "will be lower than 1/40 of the wall",
        path.string(), front->name, entry.path().filename().string()));
  }
}

/// Says how many more of a kind there are than are told one by one.
void tellRest(std::size_t all, std::string_view what) {
  if (all > kMostTold) fmt::print("and {} more {}\n", all - kMostTold, what);
}

/// Says what a soft puck costs while it is awake: a step is 0.3 of the time in which light crosses the
/// flattest triangle.
void tellSoft(const Puck& puck, double c_m_s) {
  constexpr double kNode_s = 230e-9;  // of a processor, for a step
  const SoftMatter& matter = *puck.soft;
  const SoftMesh mesh = softMeshOf(puck);
  double across_m = std::numeric_limits<double>::infinity();
  for (const SoftMesh::Triangle& triangle : mesh.triangles())
    across_m = std::min(across_m, triangle.altitude);
  const double steps_1_s = c_m_s / (0.3 * across_m);
  fmt::print(
      "puck {} is soft: sound at {:.4g} c, viscosity {:.4g}, {} nodes, {} triangles; while it is awake "
      "{:.0f} "
      "steps a second, about {:.2g} of a core\n",
      puck.name, matter.soundSpeed, matter.viscosity, mesh.places().size(), mesh.triangles().size(),
      steps_1_s, kNode_s * steps_1_s * static_cast<double>(mesh.places().size()));
}

void tellScenario(const std::filesystem::path& path, const FileOpeners& open) {
  const Scenario scenario = readScenario(path);
  if (open.meshes) open.meshes(scenario);
  printFindings(path, scenario.odd);
  for (const std::string& odd : oddities(scenario)) log::warn(fmt::format("{}: {}", path.string(), odd));
  const BilliardSetup& setup = scenario.billiard;
  fmt::print("{}: a scenario with light at {} m/s\n", scenario.title, setup.lightSpeed_m_s);
  if (setup.board) {
    fmt::print("board: {:.0f} × {:.0f} mm between the cushions; light takes {:.3g} s along it\n",
               setup.board->length_m * 1e3, setup.board->width_m * 1e3,
               setup.board->length_m / setup.lightSpeed_m_s);
  } else {
    fmt::print("board: an open plane without cushions\n");
  }
  for (const Puck& puck : std::span(setup.pucks).first(std::min(setup.pucks.size(), kMostTold))) {
    const double beta = glm::length(puck.beta);
    fmt::print(
        "puck {}: {}radius {:.1f} mm, height {:.1f} mm, {} kg, starts at ({}, {}) mm with {:.4g} c (γ = "
        "{:.4g}){}\n",
        puck.name, puck.outline_m.empty() ? "" : fmt::format("{} corners, ", puck.outline_m.size()),
        puck.radius_m * 1e3, puck.height_m * 1e3, puck.mass_kg, puck.position_m.x * 1e3,
        puck.position_m.y * 1e3, beta, gammaFromU(uFromBeta(Vec3(puck.beta, 0.0))),
        spinText(puck, setup.lightSpeed_m_s));
  }
  tellRest(setup.pucks.size(), "pucks");
  for (const Puck& puck : std::span(setup.pucks).first(std::min(setup.pucks.size(), kMostTold))) {
    if (puck.soft) tellSoft(puck, setup.lightSpeed_m_s);
  }
  for (const ScriptedBody& body :
       std::span(scenario.bodies).first(std::min(scenario.bodies.size(), kMostTold))) {
    const std::size_t turns = body.worldLine.knots().size() - 1;
    const double spin_rad_s = body.worldLine.knots().front().spin.omega_rad_s;
    fmt::print("body {}: moves as scripted, turns {}{}\n", body.name, counted(turns, "time"),
               spin_rad_s == 0.0 ? std::string() : fmt::format(", spins at {:.6g} rad/s", spin_rad_s));
  }
  tellRest(scenario.bodies.size(), "bodies");
  for (const ToldBody& body : scenario.told) {
    const std::size_t vertices = body.history.vertexCount();
    fmt::print("body {}: moves as its history says, {} in {}\n", body.name,
               vertices == 1 ? "1 vertex" : fmt::format("{} vertices", vertices),
               counted(body.history.rowCount(), "row"));
  }
  fmt::print("{}\n", counted(setup.strokes.size(), "scripted stroke"));
  if (!setup.flashes.empty()) fmt::print("flashes of light: {}\n", setup.flashes.size());
  if (!scenario.pulses.empty()) fmt::print("scripted light pulses: {}\n", scenario.pulses.size());
  if (!scenario.tour.empty()) {
    const ThrustLeg& last = scenario.tour.back();
    fmt::print("tour of the platform: {}, {:.6g} s, {}\n", counted(scenario.tour.size(), "leg"),
               last.from_s + last.for_s, scenario.tourAtOnce ? "at once" : "when it is asked for");
  }
  if (scenario.lesson) {
    fmt::print("lesson: it asks \"{}\" and offers {}\n", scenario.lesson->words.question,
               counted(scenario.lesson->words.answers.size(), "answer"));
    checkBand(path, *scenario.lesson);
  }
  const Vec3& p = scenario.observer.position_m;
  fmt::print("observer: the room's floor origin starts at ({}, {}, {}) mm with {:.4g} c\n", p.x * 1e3,
             p.y * 1e3, p.z * 1e3, glm::length(scenario.observer.beta));
}

void tellPlaylist(const std::filesystem::path& path, const FileOpeners& open) {
  const Playlist playlist = openPlaylist(path, open);
  fmt::print("{}: a playlist of {}\n", playlist.title, counted(playlist.games.size(), "game"));
  if (!playlist.languages.empty()) fmt::print("languages: {}\n", fmt::join(playlist.languages, ", "));
  for (const PlaylistGame& game : playlist.games) {
    fmt::print("{}: {}{}{}{}\n", game.scenario.stem().string(), game.title, game.isLesson ? ", a lesson" : "",
               game.for_s ? fmt::format(", for {:.6g} s", *game.for_s) : "",
               game.attracts ? ", attracts" : "");
  }
}

void tellStudy(const std::filesystem::path& path) {
  const Study study = readStudy(path);
  printFindings(path, study.odd);
  printFindings(study.consent, leftOfTemplate(readText(study.consent, InputKind::toml)));
  if (const std::string words = overdueWords(study, todayUtc()); !words.empty())
    log::warn(fmt::format("{}: {}", path.string(), words));
  fmt::print("{}: a study of {} in {}, {}\n", study.title, counted(study.participants, "participant"),
             counted(study.arms.size(), "arm"), counted(study.lessons.size(), "lesson"));
  for (const StudyArm& arm : study.arms) {
    fmt::print("arm {}: rig {}, the head is {}", arm.name, arm.rig.string(),
               arm.isStill ? "still" : "tracked");
    if (!arm.switchesOff.empty()) fmt::print(", off: {}", fmt::join(arm.switchesOff, ", "));
    if (!arm.viewsOff.empty()) fmt::print(", no views: {}", fmt::join(arm.viewsOff, ", "));
    fmt::print("\n");
  }
  for (const StudyLesson& lesson : study.lessons)
    fmt::print("lesson {}: {}\n", lesson.name, lesson.scenario.string());
  fmt::print("orders of lessons: {}{}; items: {}, {}; SHA-256 {}\n", orderRows(study),
             study.hasFixedOrder ? " (fixed)" : " (Williams)", study.bankFile.string(),
             counted(study.bank.items.size(), "item"), study.sha256);
  if (study.primary.empty())
    log::warn(fmt::format("{}: there is no primary outcome: name the one comparison that needs no correction",
                          path.string()));
}

void tellItemBank(const std::filesystem::path& path) {
  const ItemBank bank = readItemBank(path);
  printFindings(path, bank.odd);
  fmt::print("{}: an item bank of {} on {}\n", bank.title, counted(bank.items.size(), "item"),
             counted(bank.concepts().size(), "concept"));
  for (std::size_t form = 0; form < kForms.size(); ++form)
    fmt::print("form {}: {}\n", kForms[form], counted(bank.ofForm(form).size(), "item"));
}

}  // namespace

int runCheck(const std::filesystem::path& file, const FileOpeners& open, const std::string& room,
             const std::filesystem::path& rig) {
  switch (kindOf(file)) {
    case FileKind::scenario:
      tellScenario(file, open);
      break;
    case FileKind::rig:
      return tellRig(file, open) ? 1 : 0;
    case FileKind::playlist:
      tellPlaylist(file, open);
      break;
    case FileKind::study:
      tellStudy(file);
      break;
    case FileKind::itemBank:
      tellItemBank(file);
      break;
    case FileKind::foreignRoom:
      return tellForeignRoom(file, room);
    case FileKind::translation:
      return tellTranslation(file, rig) ? 1 : 0;
  }
  return 0;
}

void addCheck(CLI::App& app, int& status, const FileOpeners& open, const ShowPattern& showPattern) {
  CLI::App* command = app.add_subcommand(
      "check",
      "Examine a scenario, a room, a playlist, a study, an item bank or a translation and say what is in it "
      "and what is suspicious");
  auto file = std::make_shared<std::filesystem::path>();
  command
      ->add_option("FILE", *file,
                   std::string("Scenario, rig, playlist, study, item bank, translation (.po), or a room of "
                               "another program: ") +
                       kForeignFiles)
      ->required()
      ->transform(shipped({"rigs", "scenarios", "playlists", "studies"}));
  auto room = std::make_shared<std::string>();
  command->add_option("--room", *room, kRoomHelp)->type_name("NAME");
  auto rig = std::make_shared<std::filesystem::path>();
  command
      ->add_option(
          "--rig", *rig,
          "Of a translation: whether its texts have room on the walls of this rig. Default: desk, play, "
          "single-screen, headset, desk-two and four-walls-cluster")
      ->type_name("RIG")
      ->transform(shipped({"rigs"}));
  auto pattern = std::make_shared<bool>(false);
  auto capture = std::make_shared<std::optional<std::filesystem::path>>();
  auto language = std::make_shared<std::string>();
  if (showPattern) {
    auto* show =
        command->add_flag("--pattern", *pattern,
                          "Show test patterns on the walls of the rig until Escape; under mpirun, on the "
                          "walls of every node");
    command
        ->add_option("--capture", *capture,
                     "Folder for the patterns as pictures, without a window: WALL-EYE-FRAME.png, frame 0 the "
                     "test patterns, 1 to 3 the seam pattern after 0, 1 and 2 s")
        ->type_name("DIR")
        ->needs(show);
    addLanguage(*command, *language)->needs(show);
  }
  command->footer("Examples:\n  carom check desk\n  carom check mine.fr.po");
  command->callback([=, &status] {
    if (*pattern) {
      status = showPattern(*file, *capture, *language);
      return;
    }
    begin(WorkBudget(),
          fmt::format("{}:1:1: takes more than check may use, 2 s of processor and 300 MB of memory, "
                      "to be examined, expected a smaller file",
                      printable(file->string())));
    try {
      status = runCheck(*file, open, *room, *rig);
    } catch (const std::bad_alloc&) {
      std::terminate();  // says that the budget is used up
    }
  });
}

}  // namespace carom
