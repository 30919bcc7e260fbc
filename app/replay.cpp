#include "app/replay.h"

#include <fmt/format.h>

#include <memory>

#include "app/keys.h"
#include "app/person.h"
#include "app/session_file.h"
#include "app/stage.h"
#include "devices/trace.h"

namespace carom {
namespace {

/// Where a replay's frames come from, on rank 0.
class Source {
 public:
  virtual ~Source() = default;
  /// The next frame, its record marked if it is the last.
  virtual void next(FrameState& state) = 0;
};

/// As it was seen.
class AsRecorded : public Source {
 public:
  AsRecorded(SessionFile& session, Clock& clock) : session_(session), clock_(clock) {
    more_ = session_.next(ahead_);
  }

  void next(FrameState& state) override {
    std::swap(state, ahead_);
    more_ = session_.next(ahead_);
    state.record.last = !more_;
    if (!begun_) start_s_ = state.record.display_s - clock_.now_s();
    begun_ = true;
    clock_.sleepUntil(state.record.display_s - start_s_);
  }

 private:
  SessionFile& session_;
  Clock& clock_;
  FrameState ahead_;
  bool more_ = false;
  bool begun_ = false;
  double start_s_ = 0.0;
};

/// The same game for somebody else, whose head a trace tells. All of the game's history is brought with the
/// first frame: this person's board time is their own.
class SeenByAnother : public Source {
 public:
  SeenByAnother(SessionFile& session, const Stage& stage, const std::filesystem::path& trace, Clock& clock)
      : stage_(stage),
        person_(rigWith(stage.rig, trace), stage.scenario, std::chrono::steady_clock::now()),
        pacer_(clock, stage.rig.display_hz, stage.rig.displayLatency_s),
        end_s_(lengthOf_s(trace)) {
    // Played through, so that what strokes took back is gone.
    std::vector<WorldLine> histories = stage.histories;
    for (FrameState frame; session.next(frame);) applyFrame(frame, histories);
    for (std::size_t body = 0; body < histories.size(); ++body) {
      const auto known = stage.histories[body].knots().size();
      for (const Knot& knot : histories[body].knots().subspan(known)) game_.push_back({body, knot});
    }
  }

  void next(FrameState& state) override {
    const FrameTimes times = pacer_.next();
    state.record = {};
    state.record.number = times.number;
    state.record.display_s = times.display_s;
    state.record.observer = person_.at(times, stage_.rig.head.eyeSeparation_m);
    state.record.last = times.display_s + times.step_s > end_s_;
    state.knots.clear();
    std::swap(state.knots, game_);
    pacer_.drawn();
    pacer_.swapped();
  }

 private:
  static Rig rigWith(Rig rig, const std::filesystem::path& trace) {
    TrackerSetup& tracker = rig.trackers[rig.head.sensor.tracker];
    tracker = {};
    tracker.kind = TrackerKind::recorded;
    tracker.source = trace;
    rig.head.sensor.sensor = 0;
    rig.head.eyesFromSensor = {};
    return rig;
  }
  static double lengthOf_s(const std::filesystem::path& trace) {
    const std::vector<TrackerSample> samples = readTrace(trace);
    return samples.back().time_s - samples.front().time_s;
  }

  const Stage& stage_;
  Person person_;
  Pacer pacer_;
  double end_s_;
  std::vector<BodyKnot> game_;
};

void showFrames(Cluster& cluster, Stage& stage, Source* source, const ReplayOptions& options) {
  FrameState state;
  for (bool ended = false; !ended;) {
    if (source) source->next(state);
    cluster.share(state);
    applyFrame(state, stage.histories);
    stage.walls->draw(state.record, stage.histories);
    stage.walls->show();
    if (options.capture) stage.walls->capture(*options.capture, state.record.number);
    const bool wanted = cluster.swapTogether(state, stage.histories, wantsToEnd(stage.graphics->poll()));
    stage.walls->swap();
    if (source && (state.record.number + 1) % 30 == 0)
      fmt::print(stderr, "frame {}\n", state.record.number + 1);
    ended = wanted || state.record.last;
  }
}

void replay(Cluster& cluster, const ReplayOptions& options) {
  std::unique_ptr<SessionFile> session;
  StageOptions inputs;
  inputs.capture = options.capture;
  inputs.noWindow = options.noWindow;
  together(cluster, [&] {
    if (cluster.rank() > 0) return;
    session = std::make_unique<SessionFile>(options.session);
    if (!session->frames())
      throw std::runtime_error(
          fmt::format("session file {}: it ended before its first frame", options.session.string()));
    if (options.observer) readTrace(*options.observer);
    inputs.rig = {session->facts().rig, session->facts().rigText};
    inputs.scenario = {session->facts().scenario, session->facts().scenarioText};
  });
  shareInputs(cluster, inputs);
  Stage stage = openStage(cluster, inputs);

  std::unique_ptr<Clock> clock;
  std::unique_ptr<Source> source;
  together(cluster, [&] {
    if (cluster.rank() > 0) return;
    if (options.noWindow) {
      clock = std::make_unique<SimulatedClock>();
    } else {
      clock = std::make_unique<SteadyClock>(std::chrono::steady_clock::now());
    }
    if (options.observer) {
      source = std::make_unique<SeenByAnother>(*session, stage, *options.observer, *clock);
    } else {
      source = std::make_unique<AsRecorded>(*session, *clock);
    }
  });
  showFrames(cluster, stage, source.get(), options);
  if (source && options.capture) fmt::print(stderr, "The pictures are in {}.\n", options.capture->string());
}

}  // namespace

int runReplay(const ReplayOptions& options) {
  return runOnCluster([&](Cluster& cluster) { replay(cluster, options); });
}

}  // namespace carom
