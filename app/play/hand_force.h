#pragma once
// The force device of one viewer's hand in a session: it gets the laws of the game, measures the draw of the
// cue, and lets blows be felt when they are seen.

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/hand/hand_input.h"
#include "app/hand/hand_laws.h"
#include "app/play/seen_blows.h"
#include "cave/record/frame_state.h"
#include "devices/force/force_channel.h"

namespace carom {

/// Something that the device did in a frame: "force draw" and "0.085 m, 3.1 N, 0.12 J".
struct ForceNote {
  std::string_view what;  ///< with static lifetime
  std::string value;
  texts::Saying said = {};  ///< in the room, too; empty: nothing is said
};

class HandForce {
 public:
  /// `rig`'s axes and the setup of the device; `channel` leads to it.
  HandForce(const ForceSetup& setup, const RoomAxes& axes, std::unique_ptr<ForceChannel> channel);

  /// Begins a game.
  void play(const BilliardSetup& game);

  /// Lets the draw of the hand be what the device measures, and of a unit of rapidity a d0. What other
  /// devices than the one of the hand draw stays as it is.
  void draw(HandInput& hand);

  /// Tells the device what holds now, after the frame's strokes: the cue, while `view` draws it back, or the
  /// puck that a lesson lets one hold. Fills in the force that is felt. The device may push only while `hand`
  /// or its own button is held.
  struct Holding {
    double mass_kg = 0.0;
    Vec3 betaInRoom{0.0};  ///< of the puck
  };
  void post(const HandInput& hand, bool buttonHeld, const std::optional<Holding>& holding, double now_s,
            ViewerState& own);

  /// The hand has struck a puck, at which the stroke arrives at a board time.
  void struck(std::size_t puck, double arrives_s) { blows_.struck(puck, arrives_s); }
  /// Adds the blows that are seen in this frame, which the walls show at its display time.
  void see(std::span<const GameEvent> events, const FrameRecord& record, std::size_t viewer);

  /// Returns the notes since the last call.
  std::vector<ForceNote> takeNotes() { return std::exchange(notes_, {}); }
  /// 0 N at once, at the end of a session, whatever ends it. Says and returns why, if the device pushed. May
  /// be called from any thread.
  std::vector<ForceNote> finish();

 private:
  void tell(std::string_view what, const texts::Saying& said);
  void note(const HandView& view);
  void noteHeld(const std::optional<Holding>& holding, bool isHeld);
  bool isFelt(const HandInput& hand) const;
  std::span<const Blow> current(double now_s);

  ForceSetup setup_;
  RoomAxes axes_;
  std::unique_ptr<ForceChannel> channel_;
  BilliardSetup const* game_ = nullptr;
  std::optional<HandLaws> laws_;
  SeenBlows blows_;
  std::vector<Blow> felt_;  ///< that are not over
  std::vector<ForceNote> notes_;
  std::mutex reporting_;  ///< over what the channel reports, and the next member
  std::uint64_t falls_ = 0;
  bool saidStiffness_ = false, wasPulling_ = false;
  bool feels_ = false;              ///< the hand that aims is the one at the device
  double shown_kg_ = 0.0;           ///< of the puck that is held; 0: nothing yet
  Vec3 base_m_{0.0}, wish_m_{0.0};  ///< where the hand of a simulated device was at a press, and wants to be
};

}  // namespace carom
