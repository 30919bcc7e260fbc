#include "app/room_commands/doctor.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sched.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <glm/common.hpp>

#include "app/commands/session_options.h"
#include "app/nodes/rig_without.h"
#include "app/rig/rig.h"
#include "app/room_commands/link_health.h"
#include "app/room_commands/node_health.h"
#include "app/room_commands/room.h"
#include "app/room_commands/room_health.h"
#include "app/stage/all_ranks.h"
#include "app/stage/handover.h"
#include "app/study_data/retention.h"
#include "app/tools/option_values.h"
#include "cave/audio/sounds.h"
#include "cave/cluster/cluster.h"
#include "cave/display/display_facts.h"
#include "cave/headset/headset.h"
#include "devices/tracker/realtime_thread.h"
#include "devices/usb/device_list.h"
#include "devices/usb/evdev_force.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// Returns which part of a window lies on none of the monitors, 0 to 1, if these do not overlap.
double hiddenShare(const ScreenPlace& window, std::span<const Monitor> monitors) {
  const auto area = [](glm::ivec2 size) { return static_cast<double>(size.x) * size.y; };
  double shown = 0.0;
  for (const Monitor& monitor : monitors) {
    const glm::ivec2 from = glm::max(window.position_px, monitor.position_px);
    const glm::ivec2 to =
        glm::min(window.position_px + window.size_px, monitor.position_px + monitor.size_px);
    shown += area(glm::max(to - from, glm::ivec2(0)));
  }
  return std::max(0.0, 1.0 - shown / std::max(1.0, area(window.size_px)));
}

/// Judges the monitors on which a wall's window is to be.
void lookAtMonitors(const Rig& rig, const Wall& wall, std::span<const Monitor> present, NodeHealth& report) {
  const WindowPlacement window = rig.oneWindow.value_or(wall.window);
  std::vector<Monitor> chosen;
  try {
    chosen = monitorsOf(window, present);
    const double hidden = hiddenShare(placeOf(window, present), present);
    if (!window.border && hidden > 0.0) {
      report.warnings.push_back(
          fmt::format("wall {}: {:.0f} % of its window lies on no monitor, expected all of it", wall.name,
                      std::ceil(100.0 * hidden)));
    }
  } catch (const std::runtime_error& error) {
    report.errors.push_back(fmt::format("wall {}: {}", wall.name, error.what()));
  }
  for (const Monitor& monitor : chosen) {
    if (monitor.rate_hz > 0.0 && std::abs(monitor.rate_hz - rig.display_hz) > 1.0)
      report.warnings.push_back(
          fmt::format("wall {} is on monitor \"{}\" of {:.2f} Hz, expected {:g}, the rig's "
                      "display_hz",
                      wall.name, monitor.name, monitor.rate_hz, rig.display_hz));
  }
}

/// Returns the kind of the graphical session: X11, Wayland or unknown.
std::string sessionWords() {
  const char* session = std::getenv("XDG_SESSION_TYPE");
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  return fmt::format("session type {}{}", session ? session : "unknown",
                     wayland ? fmt::format(", Wayland display {}", wayland) : "");
}

std::string compositorWords(const DisplayFacts& facts) {
  const std::string name = facts.compositor.empty() ? "unnamed" : facts.compositor;
  if (facts.isXwayland) return fmt::format("Xwayland under a Wayland compositor ({})", name);
  return facts.hasCompositor ? fmt::format("with a compositor ({})", name) : "no compositor";
}

void lookAtDisplay(const Graphics& graphics, const Rig* rig, std::span<const Wall> walls,
                   NodeHealth& report) {
  const DisplayFacts facts = displayFacts(graphics);
  report.add("display", fmt::format("{}, {}, {}", facts.display, sessionWords(), compositorWords(facts)));
  report.add("OpenGL", fmt::format("{}, by {}", facts.openGl, facts.renderer));
  report.add("stereo", facts.hasQuadBuffer ? "quad-buffer windows" : "no quad-buffer windows");
  report.add("swap group", facts.noSwapGroup.empty() ? "available" : "none: " + facts.noSwapGroup);
  for (const Monitor& monitor : facts.monitors)
    report.add(
        "monitor",
        fmt::format("{}: {} × {} at {}, from ({}, {})", monitor.name, monitor.size_px.x, monitor.size_px.y,
                    monitor.rate_hz > 0.0 ? fmt::format("{:.2f} Hz", monitor.rate_hz) : "an unknown rate",
                    monitor.position_px.x, monitor.position_px.y));
  if (graphics.inSoftware())
    report.warnings.push_back(
        fmt::format("{} draws on the processor, expected the driver of a graphics card: frames take longer",
                    facts.renderer));
  if (facts.isXwayland)
    report.warnings.emplace_back(
        "a Wayland compositor draws the windows, expected an X11 session: its frames come later and at its "
        "own "
        "rate");
  else if (facts.hasCompositor)
    report.warnings.emplace_back(
        "a compositor redraws the windows, expected none: it adds a frame of latency");
  if (!rig) return;
  const bool wantsStereo = std::any_of(
      walls.begin(), walls.end(), [](const Wall& wall) { return wall.stereo == StereoMode::quadBuffer; });
  const bool wantsLock = rig->frameLock == FrameLock::swapGroup;
  if (wantsStereo && !facts.hasQuadBuffer)
    report.errors.emplace_back("the rig has a quad-buffer wall here, expected a display with such windows");
  if (wantsLock && !facts.noSwapGroup.empty())
    report.errors.push_back(
        fmt::format("the rig asks for a swap group, expected one here: {}", facts.noSwapGroup));
  if ((wantsStereo || wantsLock) && (facts.isXwayland || facts.hasCompositor))
    report.errors.push_back(fmt::format("the rig asks for {}, expected a display without a compositor",
                                        wantsStereo ? "quad-buffer stereo" : "a swap group"));
  for (const Wall& wall : walls) lookAtMonitors(*rig, wall, facts.monitors, report);
}

void lookAtSystem(NodeHealth& report) {
  const std::string sound = soundDeviceName();
  report.add("sound", sound.empty() ? "none" : sound);
  if (sound.empty()) report.warnings.emplace_back("there is no sound device: sessions are silent");

  const std::vector<ListedDevice> devices = listDevices();
  for (const ListedDevice& device : devices) {
    report.add("device", fmt::format("{} ({}) at {}", device.name, device.kind, device.place));
    if (!device.problem.empty())
      report.warnings.push_back(fmt::format("{}: {}", device.name, device.problem));
  }
  if (devices.empty()) report.add("device", "no tracker on USB or HID");
  for (const EvdevForceFacts& force : listEvdevForces()) {
    if (force.problem.empty())
      report.add("force", fmt::format("{} at {}: {}", force.name, force.node, force.words()));
    else
      report.add("force", force.problem);
  }

  Promptness granted = Promptness::usual;
  std::thread([&] { granted = askForPromptness(); }).join();
  report.add("real time", granted == Promptness::realTime ? "granted"
                          : granted == Promptness::nicer  ? "a higher priority is granted"
                                                          : "refused");
  if (granted != Promptness::realTime)
    report.warnings.emplace_back(
        "trackers' threads are not real-time, expected a line like '@users - rtprio 10' in "
        "/etc/security/limits.conf: on a busy machine poses come late");

  cpu_set_t mask;
  CPU_ZERO(&mask);
  sched_getaffinity(0, sizeof mask, &mask);
  report.add("cores", fmt::format("{} of {}", CPU_COUNT(&mask), std::thread::hardware_concurrency()));
}

std::string hostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// Says which walls this node draws, and which of them the rig gives to a node that is not there.
void lookAtWalls(const Cluster& cluster, std::span<const Wall> walls, NodeHealth& report) {
  std::vector<std::string> names;
  for (const Wall& wall : walls) {
    names.push_back(wall.name);
    if (wall.node < cluster.size()) continue;
    report.warnings.push_back(
        fmt::format("wall {} asks for node {}, expected {} processes under mpirun; node {} draws it",
                    wall.name, wall.node, wall.node + 1, cluster.rank()));
  }
  report.add("walls", names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")));
}

/// Runs a judgement; if it cannot be made, this is an error of the report.
void tried(NodeHealth& report, const std::function<void()>& judge) {
  try {
    judge();
  } catch (const InputErrors& errors) {
    for (const InputError& fault : errors.faults()) report.errors.push_back(fault.what());
  } catch (const std::exception& error) {
    report.errors.emplace_back(error.what());
  }
}

/// Returns the findings about this computer.
NodeHealth lookAtNode(const Cluster& cluster, const Rig* rig, const DoctorOptions& options) {
  NodeHealth report;
  report.add("host", hostName());
  tried(report, [&] {
    if (options.noWindow) return;
    const Graphics graphics(rig ? displayOf(*rig, cluster.rank()) : "");
    const std::vector<Wall> walls = rig ? cluster.wallsOf(rig->walls) : std::vector<Wall>();
    if (rig) lookAtWalls(cluster, walls, report);
    lookAtDisplay(graphics, rig, walls, report);
  });
  tried(report, [&] { lookAtSystem(report); });
  report.add("headset", aboutHeadsets());
  report.add("MPI", fmt::format("{}, {} node{}", Cluster::libraryVersion(), cluster.size(),
                                cluster.size() == 1 ? "" : "s"));
  return report;
}

/// Returns how many processes of this room run on this computer.
int ranksHere() {
  const char* here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  return here ? std::max(1, std::atoi(here)) : 1;
}

/// Adds the findings about the room. Every rank must call it; rank 0 makes the report.
void lookAtRoom(const Cluster& cluster, const Rig* rig, const DoctorOptions& options, NodeHealth& report) {
  double poses_hz = 0.0;
  if (rig && cluster.size() > 1 && cluster.rank() == 0) judgePorts(*rig, ranksHere(), report);
  if (rig && cluster.rank() == 0) {
    tried(report, [&] { judgeFiles(*rig, report); });
    if (!options.byMouse) tried(report, [&] { poses_hz = judgeTrackers(*rig, report); });
    if (!options.byMouse) tried(report, [&] { judgeForces(*rig, report); });
  }
  if (cluster.rank() == 0) {
    judgeDisk(options.folder, rig, poses_hz, report);
    for (const std::string& session : overdueSessions(options.folder, todayUtc()))
      report.warnings.push_back(session);
  }
  if (rig) judgeLinks(cluster, *rig, report);
}

std::string packed(const NodeHealth& report) {
  return nlohmann::json{{"facts", report.facts}, {"warnings", report.warnings}, {"errors", report.errors}}
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);  // names may be in any encoding
}

NodeHealth unpacked(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  NodeHealth report;
  json.at("facts").get_to(report.facts);
  json.at("warnings").get_to(report.warnings);
  json.at("errors").get_to(report.errors);
  return report;
}

/// Prints the facts of all nodes, kind by kind: once where all nodes have the same.
void printFacts(const Cluster& cluster, const std::vector<NodeHealth>& nodes) {
  std::vector<std::string> kinds;
  for (const NodeHealth& node : nodes) {
    for (const auto& [what, said] : node.facts) {
      if (std::find(kinds.begin(), kinds.end(), what) == kinds.end()) kinds.push_back(what);
    }
  }
  for (const std::string& kind : kinds) {
    std::vector<std::vector<std::string>> said(nodes.size());
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      for (const auto& [what, words] : nodes[node].facts) {
        if (what == kind) said[node].push_back(words);
      }
    }
    const bool same =
        std::all_of(said.begin(), said.end(), [&](const auto& words) { return words == said[0]; });
    std::string label = kind;
    for (std::size_t node = 0; node < (same ? 1 : nodes.size()); ++node) {
      for (const std::string& words : said[node]) {
        const std::string where = same ? "" : cluster.nameOf(static_cast<int>(node)) + ": ";
        fmt::print("{:11}{}{}\n", label, where, words);
        label.clear();
      }
    }
  }
}

/// Prints the findings of all nodes, each once with the nodes that have it.
bool printFindings(const Cluster& cluster, const std::vector<NodeHealth>& nodes) {
  const auto print = [&](auto member, const auto& log) {
    std::vector<std::string> told;
    for (const NodeHealth& node : nodes) {
      for (const std::string& finding : node.*member) {
        if (std::find(told.begin(), told.end(), finding) != told.end()) continue;
        told.push_back(finding);
        std::vector<std::string> where;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const auto& all = nodes[i].*member;
          if (std::find(all.begin(), all.end(), finding) != all.end())
            where.push_back(cluster.nameOf(static_cast<int>(i)));
        }
        const bool everywhere = where.size() == nodes.size();
        log(everywhere ? finding : fmt::format("{}: {}", fmt::join(where, ", "), finding));
      }
    }
    return !told.empty();
  };
  print(&NodeHealth::warnings, [](const std::string& line) { log::warn(line); });
  return print(&NodeHealth::errors, [](const std::string& line) { log::error(line); });
}

}  // namespace

int runDoctor(const DoctorOptions& options) {
  int status = 0;
  const int failed = runOnCluster([&](Cluster& cluster) {
    std::optional<Rig> rig;
    agreeOnVersion(cluster);
    Handover files(cluster);
    if (options.rig) try {
        rig = files.rig({*options.rig, {}});
        onAllRanks(cluster, [&] { rig = rigWithout(std::move(*rig), options.withoutNodes); });
      } catch (const RankFailed&) {  // it has been said why; the rest is judged without the rig
        rig.reset();
        status = 1;
      }
    if (rig) cluster.nameNodes(rig->walls);
    const Rig* const judged = rig ? &*rig : nullptr;
    const std::vector<std::string> texts = cluster.gather(packed(lookAtNode(cluster, judged, options)));
    NodeHealth room;
    lookAtRoom(cluster, judged, options, room);
    if (cluster.rank() > 0) return;
    if (judged) lookAtLink(*judged, room);
    std::vector<NodeHealth> nodes;
    for (const std::string& text : texts) nodes.push_back(unpacked(text));
    if (!options.findings) {
      printFacts(cluster, nodes);
      for (const auto& [subject, said] : room.facts) fmt::print("{:11}{}\n", subject, said);
    }
    if (printFindings(cluster, nodes)) status = 1;
    for (const std::string& finding : room.warnings) log::warn(finding);
    for (const std::string& finding : room.errors) log::error(finding);
    if (!room.errors.empty()) status = 1;
  });
  return std::max(failed, status);
}

namespace {

/// Judges the nodes of a rig on their computers, or this machine: under mpirun this is one of its nodes.
int judgeAll(const DoctorOptions& options) {
  const bool isNode = std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr;
  bool isRoom = false;
  try {
    isRoom = !isNode && options.rig && nodesOf(readRig(*options.rig)) > 1;
  } catch (const InputErrors&) {  // the doctor reports them
  }
  if (!isRoom) return runDoctor(options);
  RoomOptions room;
  room.rig = *options.rig;
  room.doctor = true;
  room.folder = options.folder;
  return runRoom(room);
}

}  // namespace

void addDoctor(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "doctor", "Say what this machine, or every computer of a room, has and lacks for a session");
  auto options = std::make_shared<DoctorOptions>();
  command
      ->add_option("RIG", options->rig,
                   "Rig file of the room to be judged: its computers, trackers, files, links, disk and ports")
      ->transform(shipped({"rigs"}));
  command->add_flag("--findings", options->findings, "Say only what is wrong or suspicious");
  command->add_flag("--no-window", options->noWindow, "Do not judge the displays: nothing is to be shown");
  command->add_flag("--by-mouse", options->byMouse,
                    "Do not judge the trackers: mouse and keys take their place");
  command
      ->add_option(
          "--folder", options->folder,
          "Folder of the session files, whose disk is judged; sessions of studies that are kept for too "
          "long are named")
      ->type_name("DIR")
      ->capture_default_str();
  addWithoutNodes(*command, options->withoutNodes);
  command->footer(
      "Examples:\n  carom doctor\n  carom doctor my-cave.toml\n"
      "The nodes of a rig are judged on their own computers, by mpirun. The exit status is 1 if something "
      "keeps a\n"
      "session from running.");
  command->callback([options, &status] { status = judgeAll(*options); });
}

}  // namespace carom
