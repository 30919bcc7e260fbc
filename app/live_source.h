#pragma once
// Frames of a game that is being played, for the person whose head is tracked.

#include <chrono>
#include <limits>
#include <memory>
#include <optional>

#include "app/frame_source.h"
#include "app/game.h"
#include "app/journal.h"
#include "app/person.h"
#include "app/stage.h"
#include "cave/pacer.h"

namespace carom {

/// How a session begins.
struct LiveStart {
  std::chrono::steady_clock::time_point sessionStart;  ///< where the session's clock reads zero
  std::unique_ptr<Clock> clock;
  bool swapsWait = false;               ///< of the display (cave/pacer.h)
  std::optional<FrameRecord> before;    ///< the last frame of a session that goes on
  std::optional<std::uint64_t> frames;  ///< so many, then the end
};

class LiveSource : public FrameSource {
 public:
  /// Of `stage`, rig, scenario and histories are used as long as this lives. Throws InputError if a trace is
  /// at fault.
  LiveSource(const Stage& stage, LiveStart start);

  /// Writes the session to this journal from now on; none: it is not written.
  void keep(std::unique_ptr<Journal> journal) { journal_ = std::move(journal); }

  void next(const Controls& controls, FrameState& state) override;
  Deciding deciding() const override { return deciding_; }
  std::optional<std::uint64_t> end() const override;
  void drawn() override;
  void shown(const FrameState& state) override;
  void changed(std::uint64_t number, const ControlChange& change) override;
  void measured(std::span<const LatencyRow> rows) override;

 private:
  void noteDeciding(double begin_s, std::chrono::steady_clock::time_point begun);

  const Stage& stage_;
  std::unique_ptr<Clock> clock_;
  Pacer pacer_;
  Person person_;
  Game game_;
  std::unique_ptr<Journal> journal_;
  std::optional<std::uint64_t> lastFrame_;  ///< its number
  std::optional<ObserverView> frozen_;      ///< the sight that is walked round
  Deciding deciding_;
  double newestSample_s_ = std::numeric_limits<double>::quiet_NaN();  ///< of the head, on the session's clock
};

}  // namespace carom
