#pragma once
// The platform's drive: what thrust it has, moment by moment, as it is steered, told or sent home.
//
// Everything here counts the game's seconds (the person's, times the pace of Observer::step), and of those
// the platform's own where the head is: they are the person's as long as they stand, and a little more than
// theirs while they walk about. A way that ends at rest therefore does so whatever the person does meanwhile.
// Motion is the exact sum of hyperbolae (Observer::step), split where one ends inside a frame.

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/scenario.h"
#include "cave/frame/hand_view.h"
#include "cave/frame/notice.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// What hands ask of the drive in one frame. Merged from all devices.
struct DriveWish {
  Vec3 steer{0.0};  ///< share of the strongest thrust, in the room's axes (the rig's); longer than 1 asks for
                    ///< more than there is
  bool brake = false;  ///< while it is held
  bool home = false;   ///< asked for in this frame
};

class PlatformMotion {
 public:
  /// At home where the scenario's platform starts, but at rest. With `begins`, a tour that starts at once
  /// does; a session that goes on does not go on with a tour or with the way home.
  PlatformMotion(const Scenario& scenario, const RoomAxes& axes, bool begins);

  /// Sets out on the scenario's tour with the next frame, from its first leg; from rest, or as the scenario
  /// begins, or it would end elsewhere: else it says so.
  void setOut() { setsOut_ = true; }

  /// The observer lives on for dτ while the tracked head moves from `before`, where Observer has it, to
  /// `head`, as in Observer::step; the platform does what is wished, or what it is about.
  void live(const DriveWish& wish, double dtau_s, double pace, const Head& before, const Head& head,
            Observer& observer);

  const DriveView& view() const { return view_; }  ///< of the last frame; thrust: the mean over it
  /// What it has to say since it was asked last; empty: nothing.
  Notice news() { return std::exchange(notice_, {}); }

 private:
  /// A constant thrust, or a turn about the head, for so long.
  struct Manoeuvre {
    double for_s = 0.0;
    Vec3 thrust_m_s2{0.0};
    double turn_rad = 0.0;
    Vec3 turnAxisInRoom{0.0};
  };
  /// A thrust of the way at hand, in the room's axes; it follows the one before it.
  struct Thrust {
    double for_s = 0.0;
    Vec3 thrust_m_s2{0.0};
  };
  /// What is left of a frame.
  struct Left {
    double platform_s = 0.0;
    double person_s = 0.0;  ///< on their own clock, as they feel it
  };

  void obey(const DriveWish& wish);
  void begin(const Observer& observer);
  void endTour(const Observer& observer);
  Manoeuvre next(const DriveWish& wish, const Observer& observer, const Vec3& headInRoom_m, const Left& left);
  Manoeuvre steered(const Vec3& steer, const Observer& observer, double left_s);
  Manoeuvre brake(const Observer& observer, double left_s) const;
  Manoeuvre returnHome(const Observer& observer, const Vec3& headInRoom_m, const Left& left);
  Manoeuvre alongWay(double left_s);
  void planTrip(const Vec3& wayInRoom_m);
  void take(std::span<const Thrust> way);
  void leaveWay(DriveMode mode);
  void sayOnce(bool& said, std::string_view words);

  double c_m_s_, strongest_m_s2_;
  Pose boardFromHome_;   ///< of the room, at rest
  Vec3 atStart_u_{0.0};  ///< of the room, as the scenario begins
  bool setsOut_ = false;
  bool steered_ = false;  ///< by hands, ever: who is led far away by the scenario is meant to be
  double setOutBoard_s_ = 0.0, setOutOwn_s_ = 0.0;  ///< when the tour began
  std::vector<Thrust> tour_, way_;
  std::size_t push_ = 0;   ///< of the way: the one at hand,
  double pushed_s_ = 0.0;  ///< and how much of it is over
  DriveView view_;
  Notice notice_;
  bool saidStrongest_ = false, saidFastest_ = false, saidFar_ = false;
};

}  // namespace carom
