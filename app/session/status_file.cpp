#include "app/session/status_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "app/file_keys/session_languages.h"
#include "app/rig/rig_viewers.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

constexpr std::chrono::seconds kEvery{1};

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

nlohmann::ordered_json nodesIn(const std::vector<LatencyView::Node>& all) {
  auto nodes = nlohmann::ordered_json::array();
  for (const LatencyView::Node& node : all) {
    nodes.push_back({{"name", node.name},
                     {"late_ms", {{"median", 1e3 * node.late.median_s}, {"p99", 1e3 * node.late.p99_s}}},
                     {"frame_lock", kLockStates[static_cast<std::size_t>(node.lock)]}});
  }
  return nodes;
}

nlohmann::ordered_json missingOf(const std::vector<MissingNode>& all) {
  auto missing = nlohmann::ordered_json::array();
  for (const MissingNode& node : all) missing.push_back({{"name", node.name}, {"walls", node.walls}});
  return missing;
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

nlohmann::ordered_json linkOf(const LinkReport& link) {
  return {{"room", link.room},
          {"with", link.other},
          {"state", wordFor(link.state)},
          {"round_trip_ms", {{"median", 1e3 * link.roundTrip.median_s}, {"p99", 1e3 * link.roundTrip.p99_s}}},
          {"slack_s", link.slack_s},
          {"apart_m", link.apart_m},
          {"pace", link.pace},
          {"waiting", link.waiting},
          {"strokes_in", link.strokesIn},
          {"strokes_out", link.strokesOut},
          {"put_off", link.putOff},
          {"sent_kB_s", link.sent_kB_s},
          {"received_kB_s", link.received_kB_s},
          {"same_until_s", link.sameUntil_s},
          {"own_s", link.own_s},
          {"others_s", link.others_s}};
}

}  // namespace

StatusFile::StatusFile(std::filesystem::path file, const Cluster& cluster)
    : cluster_(cluster),
      writer_(std::move(file), [this] { return text("playing"); }),
      onLeaving_([this] { end(); }) {}

StatusFile::~StatusFile() {
  try {
    end();
  } catch (const NotWritten& error) {
    log::warn(error.what());
  }
}

void StatusFile::play(const Rig& rig, const std::string& game, const std::filesystem::path& session,
                      const std::vector<std::string>& languages) {
  const std::scoped_lock hold(mutex_);
  latest_.rig = rig.title;
  latest_.missing = rig.missing;
  latest_.game = game;
  latest_.session = session.string();
  latest_.viewers = namesOf(rig.viewers);
  latest_.languages = languages;
}

void StatusFile::watch(const FrameSource& source, FrameStatistics& statistics) {
  source_ = &source;
  statistics_ = &statistics;
}

void StatusFile::shown(const Decision& decision) {
  const auto now = Clock::now();
  const FrameRecord& record = decision.frame.record;
  frame_ = record.number;
  frameAt_ = now.time_since_epoch().count();
  if (now < next_) return;
  const std::unique_lock hold(mutex_, std::try_to_lock);
  if (!hold) return;  // it is being read: the next frame will do
  next_ = now + kEvery;
  const bool isFirst = !std::exchange(latest_.hasFrame, true);
  latest_.session_s = record.display_s;
  latest_.walls = record.controls;
  for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer)
    latest_.languageOf[viewer] = record.viewers[viewer].language;
  if (statistics_) latest_.nodes = statistics_->numbers(record).nodes;
  if (source_) {
    SourceStatus status = source_->status();
    latest_.trackers = std::move(status.trackers);
    latest_.link = std::move(status.link);
  }
  if (isFirst) writer_.writeSoon();
}

/// Returns the status in words: `state`, or "starting" before the first frame.
std::string StatusFile::text(const char* state) {
  Moment moment;
  {
    const std::scoped_lock hold(mutex_);
    moment = latest_;
  }
  const Clock::duration age = Clock::now().time_since_epoch() - Clock::duration(frameAt_);
  const bool isPlaying = std::string_view(state) == "playing";
  nlohmann::ordered_json status = statusOf(isPlaying && !moment.hasFrame ? "starting" : state);
  if (!moment.missing.empty()) status["missing"] = missingOf(moment.missing);
  if (!moment.hasFrame) return linesOf(status);
  status["rig"] = moment.rig;
  status["game"] = moment.game;
  status["session"] = moment.session;
  status["frame"] = frame_.load();
  status["frame_age_s"] = std::round(10.0 * std::chrono::duration<double>(age).count()) / 10.0;
  const int late = cluster_.lateRank();
  if (late >= 0) status["waits_for"] = cluster_.nameOf(late);
  status["session_s"] = moment.session_s;
  status["walls"] = wordsFor(moment.walls);
  for (auto& [key, language] : languagesByViewer(moment.languages, moment.languageOf, moment.viewers))
    status[key] = language;
  status["nodes"] = nodesIn(moment.nodes);
  status["trackers"] = trackersOf(moment.trackers);
  if (moment.link) status["link"] = linkOf(*moment.link);
  return linesOf(status);
}

void StatusFile::end() {
  writer_.end([this] { return text("ended"); });
}

}  // namespace carom
