#include "app/session/status_file.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/base/log.h"
#include "engine/base/whole_file.h"

namespace carom {
namespace {

constexpr std::chrono::seconds kEvery{1};
constexpr std::size_t kWaiting = 2;  // statuses; further ones are left out until the disk has taken these

nlohmann::ordered_json statusOf(const char* state) {
  return {{"version", CAROM_VERSION},
          {"written", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"state", state}};
}

std::string linesOf(const nlohmann::ordered_json& status) {
  return status.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

const char* wordsFor(const WallControls& walls) {
  if (walls.blank) return "black";
  switch (walls.shown) {
    case Shown::calibrationPattern:
      return "test patterns";
    case Shown::alignmentPattern:
      return "seam pattern";
    case Shown::session:
      break;
  }
  return "session";
}

const char* wordsFor(TrackerLamp lamp) {
  if (lamp == TrackerLamp::well) return "well";
  return lamp == TrackerLamp::doubtful ? "doubtful" : "bad";
}

nlohmann::ordered_json nodesOf(const std::vector<LatencyView::Node>& all) {
  auto nodes = nlohmann::ordered_json::array();
  for (const LatencyView::Node& node : all) {
    nodes.push_back({{"name", node.name},
                     {"late_ms", {{"median", 1e3 * node.late.median_s}, {"p99", 1e3 * node.late.p99_s}}},
                     {"frame_lock", kLockStates[static_cast<std::size_t>(node.lock)]}});
  }
  return nodes;
}

nlohmann::ordered_json trackersOf(const std::vector<TrackerReport>& reports) {
  auto trackers = nlohmann::ordered_json::array();
  for (const TrackerReport& report : reports) {
    const bool isExplained = lampOf(report) == TrackerLamp::well || !report.health.message.empty();
    trackers.push_back({{"name", report.name},
                        {"use", report.use},
                        {"state", wordsFor(lampOf(report))},
                        {"message", isExplained ? report.health.message : headWords(report)},
                        {"rate_hz", report.rate_hz},
                        {"age_ms", 1e3 * report.age_s}});
  }
  return trackers;
}

}  // namespace

StatusFile::StatusFile(std::filesystem::path file)
    : file_(std::move(file)),
      writer_(kWaiting, 1, [this](const Moment& moment) { write(textOf(moment)); }),
      onLeaving_([this] { end(); }) {
  WholeFile(file_).commit(linesOf(statusOf("starting")));
}

StatusFile::~StatusFile() {
  writer_.finish();
  try {
    end();
  } catch (const NotWritten& error) {
    log::warn(error.what());
  }
}

void StatusFile::play(const std::string& rig, const std::string& game, const std::filesystem::path& session) {
  rig_ = rig;
  game_ = game;
  session_ = session.string();
}

void StatusFile::watch(const FrameSource& source, FrameStatistics& statistics) {
  source_ = &source;
  statistics_ = &statistics;
}

void StatusFile::shown(const Decision& decision) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_ || writer_.room() == 0) return;
  next_ = now + kEvery;
  const FrameRecord& record = decision.frame.record;
  Moment moment = writer_.spare();  // whose memory is used again
  moment.rig = rig_;
  moment.game = game_;
  moment.session = session_;
  moment.frame = record.number;
  moment.session_s = record.display_s;
  moment.walls = record.controls;
  if (statistics_) moment.nodes = statistics_->numbers(record).nodes;
  if (source_) moment.trackers = source_->status().trackers;
  writer_.add(std::move(moment));
}

std::string StatusFile::textOf(const Moment& moment) {
  nlohmann::ordered_json status = statusOf("playing");
  status["rig"] = moment.rig;
  status["game"] = moment.game;
  status["session"] = moment.session;
  status["frame"] = moment.frame;
  status["session_s"] = moment.session_s;
  status["walls"] = wordsFor(moment.walls);
  status["nodes"] = nodesOf(moment.nodes);
  status["trackers"] = trackersOf(moment.trackers);
  return linesOf(status);
}

void StatusFile::write(const std::string& text) try {
  const std::scoped_lock hold(mutex_);
  if (!hasEnded_) WholeFile(file_).commit(text);
} catch (const NotWritten& error) {
  if (!std::exchange(hasFailed_, true))
    log::warn(fmt::format("{}: {}. The session goes on.", error.what(), error.reason()));
}

void StatusFile::end() {
  const std::scoped_lock hold(mutex_);
  if (std::exchange(hasEnded_, true)) return;
  WholeFile(file_).commit(linesOf(statusOf("ended")));
}

}  // namespace carom
