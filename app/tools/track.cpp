#include "app/tools/track.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/rig/rig.h"
#include "app/toml/config_folder.h"
#include "app/tools/live_display.h"
#include "app/tools/option_values.h"
#include "devices/monitor/input_monitor.h"
#include "devices/monitor/loss_counter.h"
#include "devices/monitor/sensor_statistics.h"
#include "devices/setup/force_factory.h"
#include "devices/setup/tracker_factory.h"
#include "devices/tracker/trace.h"
#include "devices/usb/device_list.h"
#include "devices/usb/evdev_force.h"
#include "engine/text/log.h"

namespace carom {

namespace {

using SteadyTime = std::chrono::steady_clock::time_point;

constexpr double kPoll_s = 0.005;

/// A tracker of the rig and the statistics of its data.
struct Watched {
  const TrackerSetup* setup = nullptr;
  std::unique_ptr<Tracker> tracker;
  std::map<int, SensorStatistics> sensors;
  std::map<int, InputMonitor> inputs;  // for sensors that have some
  std::vector<LossCounter> losses;     // for sensors that the rig uses
};

/// Returns a counter for each sensor of that tracker whose pose the rig uses.
std::vector<LossCounter> lossCountersOf(const Rig& rig, std::size_t tracker) {
  std::vector<LossCounter> counters;
  if (rig.viewers.front().head.sensor.tracker == tracker)
    counters.emplace_back(rig.viewers.front().head.sensor.sensor);
  if (rig.viewers.front().hand && rig.viewers.front().hand->tracker == tracker)
    counters.emplace_back(rig.viewers.front().hand->sensor);
  return counters;
}

/// Records the head's sensor as a trace. The file is created at once, so that an unwritable path is reported
/// at once.
class Recording {
 public:
  Recording(std::filesystem::path file, const Rig& rig)
      : file_(std::move(file)),
        sensor_(rig.viewers.front().head.sensor),
        latency_s_(rig.trackers[sensor_.tracker].latency_s) {
    const TrackerSetup& tracker = rig.trackers[sensor_.tracker];
    comment_ = fmt::format("recorded by carom track: tracker {} ({}), sensor {}", tracker.name,
                           toString(tracker.kind), sensor_.sensor);
    writer_ = std::make_unique<TraceWriter>(file_, true, comment_);
  }

  void add(std::size_t tracker, const TrackerSample& sample) {
    if (tracker != sensor_.tracker || sample.sensor != sensor_.sensor) return;
    if (rows_ == 0 && !sample.hasOrientation) {
      writer_ = nullptr;
      writer_ = std::make_unique<TraceWriter>(file_, false, comment_);
    }
    TrackerSample row = sample;
    row.time_s -= latency_s_;
    writer_->add(row);
    ++rows_;
  }

  /// Returns whether there is a trace now.
  bool commit() {
    if (rows_ == 0) return false;
    writer_->commit();
    return true;
  }

  std::size_t rows() const { return rows_; }

 private:
  std::filesystem::path file_;
  SensorChoice sensor_;
  double latency_s_;
  std::string comment_;
  std::unique_ptr<TraceWriter> writer_;
  std::size_t rows_ = 0;
};

std::string figure(double value, const char* format) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

constexpr const char* kColumns =
    "tracker          sensor   rate Hz    age ms  jitter ms  rest mm  dropouts  battery  quality\n";

std::string sensorLine(const std::string& tracker, int sensor, const SensorFigures& figures) {
  return fmt::format("{:<16} {:>6} {:>9} {:>9} {:>10} {:>8} {:>9} {:>8} {:>8}\n", tracker, sensor,
                     figure(figures.rate_hz, "{:.1f}"), figure(1e3 * figures.age_s, "{:.1f}"),
                     figure(1e3 * figures.jitter_s, "{:.2f}"), figure(1e3 * figures.rest_m, "{:.3f}"),
                     figures.dropouts, figure(100.0 * figures.battery, "{:.0f} %"),
                     figure(figures.quality, "{:.2f}"));
}

std::string trackerLine(const Watched& watched, double now_s) {
  const TrackerHealth health = watched.tracker->health(now_s);
  std::string line =
      fmt::format("{} ({}): {}", watched.setup->name, toString(watched.setup->kind), toString(health.state));
  const auto count = [&line](std::uint64_t number, const char* what) {
    if (number > 0) line += fmt::format(", {} {}", number, what);
  };
  count(health.gaps, "gaps");
  count(health.late, "late");
  count(health.refused, "refused");
  count(health.overflowed, "overflowed");
  count(health.reconnections, "reconnections");
  std::size_t losses = 0;
  for (const LossCounter& counter : watched.losses) losses += counter.count();
  count(losses, "losses");
  if (!health.message.empty()) line += fmt::format(". {}", health.message);
  line += '\n';
  if (!health.names.empty()) line += fmt::format("  {}: {}\n", watched.setup->name, health.names);
  return line;
}

std::string inputLines(const Watched& watched) {
  std::string lines;
  for (const auto& [sensor, inputs] : watched.inputs) {
    lines += fmt::format("  {} sensor {}: {}\n", watched.setup->name, sensor, inputs.text());
  }
  return lines;
}

std::string tableOf(const std::vector<Watched>& all, double now_s) {
  std::string text = kColumns;
  for (const Watched& watched : all) {
    for (const auto& [sensor, monitor] : watched.sensors) {
      text += sensorLine(watched.setup->name, sensor, monitor.figures(now_s - watched.setup->latency_s));
    }
  }
  for (const Watched& watched : all) text += trackerLine(watched, now_s) + inputLines(watched);
  return text;
}

void take(Watched& watched, std::size_t number, double now_s, Recording* recording,
          std::vector<TrackerSample>& samples, std::vector<Reading>& inputs) {
  samples.clear();
  inputs.clear();
  watched.tracker->poll(now_s, samples);
  watched.tracker->takeInputs(inputs);
  for (const TrackerSample& sample : samples) {
    watched.sensors[sample.sensor].add(sample);
    if (recording) recording->add(number, sample);
  }
  for (LossCounter& counter : watched.losses) counter.see(samples, inputs);
  for (const Reading& input : inputs) {
    if (input.kind == Reading::Kind::battery) watched.sensors[input.sensor].setBattery(input.value);
    if (input.kind == Reading::Kind::button || input.kind == Reading::Kind::axis) {
      watched.inputs[input.sensor].add(input);
    }
  }
}

/// Polls and prints until interrupted or until the given time has passed.
void watch(std::vector<Watched>& all, SteadyTime start, const TrackOptions& options, Recording* recording) {
  const EndOnSignals endOnSignals;
  LiveDisplay display;
  std::vector<TrackerSample> samples;
  std::vector<Reading> inputs;
  double shown_s = 0.0;
  for (bool ends = false; !ends;) {
    constexpr std::timespec kPause{0, static_cast<long>(1e9 * kPoll_s)};
    ::nanosleep(&kPause, nullptr);
    const double now_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (std::size_t i = 0; i < all.size(); ++i) take(all[i], i, now_s, recording, samples, inputs);
    ends = EndOnSignals::isAsked() || (options.seconds && now_s >= *options.seconds);
    if (!ends && now_s < shown_s + display.period_s()) continue;
    display.show(tableOf(all, now_s), now_s);
    shown_s = now_s;
  }
}

}  // namespace

int runTrack(const TrackOptions& options) {
  const Rig rig = readRig(options.rig);
  const SteadyTime start = std::chrono::steady_clock::now();
  std::vector<Watched> all;
  for (std::size_t i = 0; i < rig.trackers.size(); ++i) {
    const TrackerSetup& setup = rig.trackers[i];
    all.push_back({&setup, createTracker(setup, rig.axes, start), {}, {}, lossCountersOf(rig, i)});
  }
  std::unique_ptr<Recording> recording;
  if (options.record) recording = std::make_unique<Recording>(*options.record, rig);
  log::note(fmt::format("The trackers of {}. Ctrl-C ends.", options.rig.string()));
  watch(all, start, options, recording.get());
  if (!recording) return 0;
  if (!recording->commit()) {
    log::error(
        fmt::format("nothing came from the head's sensor: {} is not written", options.record->string()));
    return 1;
  }
  log::note(
      fmt::format("{} samples of the head's sensor are in {}.", recording->rows(), options.record->string()));
  return 0;
}

namespace {

/// Lists the devices that push or rumble, and those behind servers that the rig names.
void listForces(const std::vector<EvdevForceFacts>& forces, const std::optional<Rig>& rig) {
  std::vector<std::pair<std::string, std::string>> named;
  for (const ViewerSetup& viewer : rig ? rig->viewers : std::vector<ViewerSetup>()) {
    if (viewer.force && rowOf(viewer.force->kind).needsSource)
      named.emplace_back(viewer.force->source, tryForce(*viewer.force, rig->axes).words);
  }
  if (forces.empty() && named.empty()) return;
  fmt::print("\nForce devices, for [hand.force]:\n");
  for (const auto& [source, words] : named) fmt::print("{:<14} {:<18} {}\n", "vrpn", source, words);
  for (const EvdevForceFacts& force : forces) {
    if (force.problem.empty())
      fmt::print("{:<14} {:<18} {:<28} {}\n", "evdev", force.node, force.name, force.words());
    else
      fmt::print("{:<14} {}\n", "evdev", force.problem);
  }
}

}  // namespace

int runTrackList(const std::optional<std::filesystem::path>& file) {
  const std::optional<Rig> rig = file ? std::optional(readRig(*file)) : std::nullopt;
  const std::vector<ListedDevice> devices = listDevices();
  const std::vector<EvdevForceFacts> forces = listEvdevForces();
  if (devices.empty()) {
    fmt::print(
        "No {} that carom knows is plugged in. (Those on the network are not looked for: name them in a "
        "rig.)\n",
        forces.empty() ? "device" : "tracker");
    listForces(forces, rig);
    return 0;
  }
  fmt::print("{:<14} {:<18} {:<28} {}\n", "kind", "source", "device", "at");
  for (const ListedDevice& device : devices) {
    fmt::print("{:<14} {:<18} {:<28} {}\n", device.kind, device.source, device.name, device.place);
    if (!device.serial.empty()) fmt::print("{:<14} serial number {}\n", "", device.serial);
    if (!device.problem.empty()) fmt::print("{:<14} {}\n", "", device.problem);
  }
  listForces(forces, rig);
  return 0;
}

void addTrack(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("track", "Watch the trackers of a rig, and record the head");
  auto options = std::make_shared<TrackOptions>();
  auto list = std::make_shared<bool>(false);
  options->rig = configFolder() / "rigs/desk.toml";
  command->add_option("--rig", options->rig, "Rig file whose trackers to watch")
      ->capture_default_str()
      ->transform(shipped({"rigs"}));
  command
      ->add_option(
          "--record", options->record,
          "Write the samples of the head's sensor to this trace. The file appears when the command ends")
      ->type_name("TRACE");
  command->add_option("--seconds", options->seconds, "End after this many seconds; by default, Ctrl-C ends")
      ->type_name("S")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  command->add_flag(
      "--list", *list,
      "Only list the devices that are plugged in and, with --rig, its force devices behind servers");
  command->footer(
      "Columns: age, the time since the newest pose; jitter, the spread of the intervals between poses; "
      "rest, the\n"
      "noise of a coordinate while the sensor last kept still; dropouts, the intervals longer than one and a "
      "half\n"
      "usual ones.\n"
      "Example:\n  carom track --rig desk --record walk.csv --seconds 60");
  command->callback([options, list, command, &status] {
    const bool isNamed = command->count("--rig") > 0;
    status = *list ? runTrackList(isNamed ? std::optional(options->rig) : std::nullopt) : runTrack(*options);
  });
}

}  // namespace carom
