#pragma once
// The directors decide what each frame shows.

#include "app/input/desk_controls.h"
#include "app/input/keys.h"
#include "app/session/frame_source.h"

namespace carom {

class DisplayWalls;

/// The director of all ranks but rank 0. It decides nothing: these ranks receive rank 0's decision.
class Director {
 public:
  virtual ~Director() = default;

  /// Decides the next frame. On entry, `decision` is that of the previous frame.
  virtual void decide(const FrameTimes& /*times*/, const WindowInput& /*input*/, Decision& /*decision*/) {}

  const OperatorSettings& settings() const { return settings_; }

 protected:
  OperatorSettings settings_;
};

/// Rank 0's director: applies the commands of keys, console and hand devices to the operator's settings, then
/// asks the source for the frame.
class FrameLeader : public Director {
 public:
  /// Leads the frames of `source`, beginning with `settings`. `windows` are the walls whose windows take
  /// mouse input; if null, all desktop devices are ignored, so that a run in simulated time does not depend
  /// on them. `source` and `windows` must outlive this object.
  FrameLeader(FrameSource& source, KeysOf keys, const OperatorSettings& settings,
              const DisplayWalls* windows);

  void decide(const FrameTimes& times, const WindowInput& input, Decision& decision) override;

  /// Returns the commands to apply with the next frame; callers add theirs here.
  Commands& inbox() { return inbox_; }

  /// Replaces the settings when another game starts.
  void begin(const OperatorSettings& settings) { settings_ = settings; }

  /// Returns the scenario to play after this game and clears it; empty if none was requested.
  std::string takeNextGame() { return std::exchange(nextGame_, {}); }

 private:
  void obey(const Command& command, Decision& decision);

  FrameSource& source_;
  KeysOf keys_;
  const DisplayWalls* windows_;
  DeskControls desk_;  ///< kept between games, so that held buttons and keys stay held
  Commands inbox_, obeyed_;
  std::string nextGame_;
};

}  // namespace carom
