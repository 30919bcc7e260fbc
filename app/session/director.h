#pragma once
// Who decides what the frames show.

#include "app/input/desk.h"
#include "app/input/keys.h"
#include "app/session/frame_source.h"

namespace carom {

class DisplayWalls;

/// Decides nothing: the director of every rank but the first, which is told what the first has decided.
class Director {
 public:
  virtual ~Director() = default;

  /// `decision`: in the beginning, of the frame before.
  virtual void decide(const FrameTimes& /*times*/, const WindowInput& /*input*/, Decision& /*decision*/) {}

  const OperatorSettings& settings() const { return settings_; }

 protected:
  OperatorSettings settings_;
};

/// Rank 0's: has the commands of keys, console and hands change the operator's settings, then asks the source for
/// the frame.
class FrameLeader : public Director {
 public:
  /// `windows`: the walls over whose windows a mouse plays, with the desk's other devices; null: nobody plays, so that
  /// a run in simulated time is the same whatever lies on the desk. Source and walls are used as long as this lives.
  FrameLeader(FrameSource& source, KeysOf keys, const OperatorSettings& settings,
              const DisplayWalls* windows);

  void decide(const FrameTimes& times, const WindowInput& input, Decision& decision) override;

  /// What is put in here is commanded with the next frame.
  Commands& inbox() { return inbox_; }

  /// Another game begins with these settings.
  void begin(const OperatorSettings& settings) { settings_ = settings; }

  /// Returns the scenario to go on with after this game, and forgets it; empty if nobody has asked for any.
  std::string takeNextGame() { return std::exchange(nextGame_, {}); }

 private:
  void obey(const Command& command, Decision& decision);

  FrameSource& source_;
  KeysOf keys_;
  const DisplayWalls* windows_;
  Desk desk_;  ///< what is held stays held from one game to the next
  Commands inbox_, obeyed_;
  std::string nextGame_;
};

}  // namespace carom
