#pragma once
// The directors decide what each frame shows.

#include "app/class_server/class_desk.h"
#include "app/input/desk_controls.h"
#include "app/input/keys.h"
#include "app/live/frame_source.h"
#include "app/session/programme.h"

namespace carom {

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
  /// Leads the frames of `source`, beginning with `settings`; the next visitor begins with `firstGame` or, if
  /// that is empty, with the game that they name. `patience_s`: the next visitor is welcomed after so long
  /// without a sign of life; empty: never. `desk`: the devices of the desk; a run in simulated time has none,
  /// so that it does not depend on them. `source` must outlive this object.
  FrameLeader(FrameSource& source, KeysOf keys, const OperatorSettings& settings, DeskDevices desk,
              std::optional<double> patience_s = {}, const std::string& firstGame = {});

  void decide(const FrameTimes& times, const WindowInput& input, Decision& decision) override;

  /// Lets a class take part from now on: its teacher moves the lesson. It must outlive this object.
  void teach(ClassDesk& classroom) { classroom_ = &classroom; }

  /// From now on no game is played but those that `isAllowed` says (app/session/programme.h).
  void allowOnly(Programme::Allowed isAllowed) { programme_.allowOnly(std::move(isAllowed)); }

  /// Returns the commands to apply with the next frame; callers add theirs here.
  Commands& inbox() { return inbox_; }

  /// Replaces the settings when another game starts.
  void begin(const OperatorSettings& settings) {
    settings_ = settings;
    inbox_.clear();  // of the game before
    handed_.clear();
    fromSource_ = 0;
    programme_.begin();
  }

  /// Returns which game follows by itself, and when.
  std::optional<Programme::Following> following(double now_s) {
    return programme_.following(now_s, settings_.playing);
  }

  /// Returns the game to play after this one and clears it.
  NextGame takeNextGame() {
    darkens_s_.reset();
    return std::exchange(nextGame_, {});
  }

 private:
  void applyCommand(const Command& given, Decision& decision, std::size_t viewer = 0);
  void followProgramme(bool acted, const DeskInput& desk, Decision& decision);
  void followClass(Decision& decision);
  void askWhetherStillThere(Decision& decision) const;
  void choose(NextGame next);
  void endGame(Decision& decision);

  FrameSource& source_;
  ClassDesk* classroom_ = nullptr;  ///< null: there is none
  KeysOf keys_;
  DeskDevices desk_;  ///< kept between games, so that held buttons and keys stay held
  Commands inbox_, applied_;
  std::vector<HandCommand> handed_;  ///< by the hands in the frame before
  std::size_t fromSource_ = 0;       ///< number of commands in the inbox that the source has given
  std::string firstGame_;
  NextGame nextGame_;
  bool awaitsShot_ = false;          ///< the next game follows by itself, after the best shot
  std::optional<double> darkens_s_;  ///< since when the walls go dark before the next game, session clock
  Programme programme_;
  std::optional<PointedWall> mouseWas_;
};

}  // namespace carom
