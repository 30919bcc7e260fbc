#pragma once
// The directors decide what each frame shows.

#include "app/input/desk_controls.h"
#include "app/input/keys.h"
#include "app/session/frame_source.h"
#include "app/session/idle_watch.h"

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

/// The game to play after this one.
struct NextGame {
  std::string file;               ///< scenario; empty: none was requested
  bool isForNextVisitor = false;  ///< all settings are as the session began
};

/// Rank 0's director: applies the commands of keys, console and hand devices to the operator's settings, then
/// asks the source for the frame.
class FrameLeader : public Director {
 public:
  /// Leads the frames of `source`, beginning with `settings`; the next visitor begins with the game that they
  /// name. `patience_s`: the next visitor is welcomed after so long without a sign of life; empty: never.
  /// `windows` are the walls whose windows take mouse input; if null, all desktop devices are ignored, so
  /// that a run in simulated time does not depend on them. `source` and `windows` must outlive this object.
  FrameLeader(FrameSource& source, KeysOf keys, const OperatorSettings& settings, const DisplayWalls* windows,
              std::optional<double> patience_s = {});

  void decide(const FrameTimes& times, const WindowInput& input, Decision& decision) override;

  /// Returns the commands to apply with the next frame; callers add theirs here.
  Commands& inbox() { return inbox_; }

  /// Replaces the settings when another game starts.
  void begin(const OperatorSettings& settings) {
    settings_ = settings;
    inbox_.clear();  // of the game before
    fromSource_ = 0;
  }

  /// Lets the next visitor begin with this scenario instead of that of the first settings.
  void beginVisitsWith(std::string game) { firstGame_ = std::move(game); }

  /// Returns the game to play after this one and clears it.
  NextGame takeNextGame() { return std::exchange(nextGame_, {}); }

 private:
  void obey(const Command& command, Decision& decision);
  bool isAbandoned(bool acted, const DeskInput& desk, const Decision& decision);

  FrameSource& source_;
  KeysOf keys_;
  const DisplayWalls* windows_;
  DeskControls desk_;  ///< kept between games, so that held buttons and keys stay held
  Commands inbox_, obeyed_;
  std::size_t fromSource_ = 0;  ///< number of commands in the inbox that the source has given
  std::string firstGame_;
  NextGame nextGame_;
  IdleWatch idle_;
  std::optional<PointedWall> mouseWas_;
};

}  // namespace carom
