#include "app/room_commands/room_health.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/scenario/playlist.h"
#include "app/scenario/scenario.h"
#include "app/stage/scenario_scene.h"
#include "cave/cluster/links.h"
#include "devices/monitor/sensor_statistics.h"
#include "devices/setup/force_factory.h"
#include "devices/setup/tracker_factory.h"

namespace carom {
namespace {

constexpr double kConnects_s = 3.0, kListens_s = 2.0;

// The bytes that a session file takes, measured and rounded up.
constexpr double kFrame_bytes = 900.0, kPose_bytes = 75.0;
constexpr double kUsualPoses_hz = 120.0;  // of a head and a wand
constexpr double kLeastSession_h = 8.0;   // a day

constexpr double kLeastRate_bytes_s = 30e6;  // a fast network of 1 Gbit/s has 110e6

/// A tracker of the rig that is listened to.
struct Heard {
  const TrackerSetup* setup = nullptr;
  std::unique_ptr<Tracker> tracker;
  std::map<int, SensorStatistics> sensors{};
};

bool sendsPoses(const TrackerSetup& setup) {
  return setup.kind != TrackerKind::spaceMouse && !setup.buttonsAlone;
}

/// Listens until every tracker that sends poses has sent some, and then as long as a rate needs.
std::vector<Heard> listenTo(const Rig& rig, double& now_s) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Heard> all;
  for (const TrackerSetup& setup : rig.trackers) {
    if (isDevice(setup.kind)) all.push_back({&setup, createTracker(setup, rig.axes, start)});
  }
  std::vector<TrackerSample> samples;
  double ends_s = all.empty() ? 0.0 : kConnects_s + kListens_s;
  for (now_s = 0.0; now_s < ends_s;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    now_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    bool allSend = true;
    for (Heard& heard : all) {
      samples.clear();
      heard.tracker->poll(now_s, samples);
      for (const TrackerSample& sample : samples) heard.sensors[sample.sensor].add(sample);
      allSend = allSend && (!sendsPoses(*heard.setup) || !heard.sensors.empty());
    }
    if (allSend) ends_s = std::min(ends_s, now_s + kListens_s);
    if (!allSend) ends_s = std::max(ends_s, std::min(now_s + kListens_s, kConnects_s + kListens_s));
  }
  return all;
}

/// Returns the sensors of a tracker whose poses the rig uses, and for what.
std::vector<std::pair<int, std::string>> usedSensors(const Rig& rig, const TrackerSetup& tracker) {
  std::vector<std::pair<int, std::string>> used;
  const auto add = [&](const SensorChoice& choice, const std::string& use) {
    if (&rig.trackers[choice.tracker] == &tracker) used.emplace_back(choice.sensor, use);
  };
  for (const ViewerSetup& viewer : rig.viewers) {
    const std::string whose = rig.viewers.size() > 1 ? fmt::format(" of {}", viewer.name) : "";
    add(viewer.head.sensor, "head" + whose);
    if (viewer.hand) add(*viewer.hand, "hand" + whose);
  }
  return used;
}

void judgeTracker(const Rig& rig, const Heard& heard, double now_s, NodeHealth& report) {
  const TrackerHealth health = heard.tracker->health(now_s);
  const std::string why = health.message.empty() ? "" : fmt::format(" ({})", health.message);
  std::vector<std::string> sent, numbers;
  std::map<int, double> rates_hz;
  for (const auto& [sensor, statistics] : heard.sensors) {
    const double rate_hz = statistics.figures(now_s - heard.setup->latency_s).rate_hz;
    rates_hz[sensor] = rate_hz;
    numbers.push_back(std::to_string(sensor));
    sent.push_back(std::isnan(rate_hz) ? fmt::format("sensor {}", sensor)
                                       : fmt::format("sensor {} at {:.0f} Hz", sensor, rate_hz));
  }
  report.add(
      "tracker",
      fmt::format("{} ({}): {}{}", heard.setup->name, toString(heard.setup->kind),
                  sent.empty() ? toString(health.state) : fmt::format("{}", fmt::join(sent, ", ")), why));
  if (!sendsPoses(*heard.setup)) {
    if (health.state == TrackerHealth::State::failed)
      report.warnings.push_back(fmt::format("tracker {} does not work{}", heard.setup->name, why));
    return;
  }
  if (sent.empty()) {
    report.warnings.push_back(
        fmt::format("tracker {} is silent: nothing came within {:.0f} s{}, expected poses", heard.setup->name,
                    now_s, why));
    return;
  }
  for (const auto& [sensor, use] : usedSensors(rig, *heard.setup)) {
    const auto rate = rates_hz.find(sensor);
    if (rate == rates_hz.end())
      report.warnings.push_back(fmt::format("tracker {} sends nothing of sensor {}, the {}; it sends {}",
                                            heard.setup->name, sensor, use, fmt::join(numbers, ", ")));
    else if (rate->second < 0.9 * rig.display_hz)
      report.warnings.push_back(fmt::format(
          "tracker {} sends sensor {}, the {}, at {:.0f} Hz, expected {:g} at least, the rig's display_hz",
          heard.setup->name, sensor, use, rate->second, rig.display_hz));
  }
}

std::string bytesInWords(double bytes) {
  constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;
  return bytes < kGiB ? fmt::format("{:.0f} MiB", bytes * 1024.0 / kGiB)
                      : fmt::format("{:.0f} GiB", bytes / kGiB);
}

std::string hoursInWords(double hours) {
  return hours < 1.5 ? fmt::format("{:.0f} minutes", 60.0 * hours) : fmt::format("{:.0f} hours", hours);
}

/// Returns whether a TCP port of this computer is free.
bool isFree(int port) {
  const int listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (listening < 0) return false;
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  const bool free = bind(listening, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
  close(listening);
  return free;
}

}  // namespace

double judgeTrackers(const Rig& rig, NodeHealth& report) {
  double now_s = 0.0, poses_hz = 0.0;
  for (const Heard& heard : listenTo(rig, now_s)) {
    judgeTracker(rig, heard, now_s, report);
    for (const auto& [sensor, statistics] : heard.sensors) {
      const double rate_hz = statistics.figures(now_s - heard.setup->latency_s).rate_hz;
      if (!std::isnan(rate_hz)) poses_hz += rate_hz;
    }
  }
  return poses_hz;
}

void judgeForces(const Rig& rig, NodeHealth& report) {
  for (const ViewerSetup& viewer : rig.viewers) {
    if (!viewer.force) continue;
    const ForceTrial trial = tryForce(*viewer.force, rig.axes);
    report.add("force", fmt::format("{}: {}", nameOf(*viewer.force), trial.words));
    if (!trial.works)
      report.warnings.push_back(
          fmt::format("{}: {}: there is no force in the hand", nameOf(*viewer.force), trial.words));
  }
}

void judgeLinks(const Cluster& cluster, const Rig& rig, NodeHealth& report) {
  if (cluster.size() == 1) return;
  const std::vector<LinkFigures> links = measureLinks(cluster);
  const double frame_s = 1.0 / rig.display_hz;
  for (std::size_t rank = 1; rank < links.size(); ++rank) {
    const LinkFigures& link = links[rank];
    const std::string name = cluster.nameOf(static_cast<int>(rank));
    const std::string trips =
        fmt::format("{:.2f} ms there and back, at times {:.2f}", 1e3 * link.median_s, 1e3 * link.late_s);
    report.add("link", fmt::format("{}: {}; {:.0f} MB/s", name, trips, 1e-6 * link.bytes_per_s));
    const double most_s = 0.1 * frame_s, mostLate_s = 0.25 * frame_s;
    if (link.median_s > most_s || link.late_s > mostLate_s)
      report.warnings.push_back(
          fmt::format("{} is slow to answer: messages take {}, expected {:.1f} and at times {:.1f} ms at "
                      "most; is that computer "
                      "busy, or on a wireless network?",
                      name, trips, 1e3 * most_s, 1e3 * mostLate_s));
    if (link.bytes_per_s < kLeastRate_bytes_s)
      report.warnings.push_back(fmt::format(
          "messages to {} run at {:.1f} MB/s, expected {:.0f} at least, as a cable of 1 Gbit/s allows", name,
          1e-6 * link.bytes_per_s, 1e-6 * kLeastRate_bytes_s));
  }
}

void judgeDisk(const std::filesystem::path& folder, const Rig* rig, double poses_hz, NodeHealth& report) {
  std::error_code failed;
  const std::filesystem::path place = std::filesystem::absolute(folder, failed);
  const auto space = std::filesystem::space(folder, failed);
  if (failed) {
    report.errors.push_back(
        fmt::format("{}: {}, expected a folder for session files", place.string(), failed.message()));
    return;
  }
  const double frames_hz = rig ? rig->display_hz : 60.0;
  const double bytes_per_s =
      frames_hz * kFrame_bytes * (rig ? static_cast<double>(rig->viewers.size()) : 1.0) +
      (poses_hz > 0.0 ? poses_hz : kUsualPoses_hz) * kPose_bytes;
  const auto free_bytes = static_cast<double>(space.available);
  const std::string free = bytesInWords(free_bytes), hours = hoursInWords(free_bytes / bytes_per_s / 3600.0);
  report.add("disk", fmt::format("{} free in {}: {} of session at {} an hour", free, place.string(), hours,
                                 bytesInWords(3600.0 * bytes_per_s)));
  if (free_bytes / bytes_per_s / 3600.0 < kLeastSession_h)
    report.warnings.push_back(
        fmt::format("{} are free in {}, enough for {} of session, expected {:g} hours at least", free,
                    place.string(), hours, kLeastSession_h));
}

void judgePorts(const Rig& rig, int ranks, NodeHealth& report) {
  const auto& ports = rig.start.ports;
  report.add("ports", ports ? fmt::format("MPI listens on TCP ports {} to {}", ports->first, ports->last)
                            : "MPI listens on any TCP port; [start] ports of the rig fixes them");
  if (!ports) return;
  int free = 0;
  for (int port = ports->first; port <= ports->last; ++port) free += isFree(port) ? 1 : 0;
  const int needed = 2 * ranks + 2;  // beside those that this very program holds
  if (free < needed)
    report.errors.push_back(fmt::format("{} of the TCP ports {} to {} are free, expected {} at least", free,
                                        ports->first, ports->last, needed));
}

void judgeFiles(const Rig& rig, NodeHealth& report) {
  std::size_t meshes = 0, pictures = 0, traces = 0;
  for (const Wall& wall : rig.walls) {
    for (const std::filesystem::path* mesh :
         {&wall.warp, &wall.colourWarps[0], &wall.colourWarps[1], &wall.colourWarps[2]})
      meshes += mesh->empty() ? 0 : 1;
    pictures += wall.blend.empty() ? 0 : 1;
  }
  for (const TrackerSetup& tracker : rig.trackers) traces += tracker.kind == TrackerKind::recorded ? 1 : 0;
  std::string games;
  if (!rig.playlist.empty()) {
    const Playlist playlist = readPlaylist(rig.playlist);
    for (const PlaylistGame& game : playlist.games) openMeshes(readScenario(game.scenario));
    games = fmt::format(", a playlist of {} games", playlist.games.size());
  }
  report.add("files", fmt::format("the rig's {} warp meshes, {} blend pictures and {} traces{} can be read",
                                  meshes, pictures, traces, games));
}

}  // namespace carom
