#pragma once
// The motion of the platform: its thrust at each moment, as steered by hand, as the tour prescribes, or on
// the way home.
//
// All times here are game seconds (the viewer's, times the pace of Observers::step), measured as proper time
// of the platform at the head. They equal the viewer's time while they stand and run slightly faster while
// they walk, so a trip that ends at rest does so however the viewer walks meanwhile. Motion is the exact sum
// of hyperbolae (Observers::step), split where one ends inside a frame.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "app/scenario/scenario.h"
#include "app/viewer/thrust_way.h"
#include "cave/record/hand_view.h"
#include "cave/texts/saying.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observers.h"

namespace carom {

/// The input to the platform's motion in one frame, combined from all devices.
struct DriveWish {
  /// Fraction of the strongest thrust, in the room's axes (the rig's); a length above 1 asks for more than
  /// available.
  Vec3 steer{0.0};
  bool brake = false;     ///< held down
  bool home = false;      ///< requested in this frame
  double turn_rad = 0.0;  ///< of the room about the vertical through the head, anticlockwise from above
};

/// Returns whether anything is wished.
inline bool asksForAnything(const DriveWish& wish) {
  return wish.steer != Vec3(0.0) || wish.brake || wish.home || wish.turn_rad != 0.0;
}

class PlatformMotion {
 public:
  /// Sets home to the platform's initial position in the scenario, but at rest. If `begins`, a tour that
  /// starts at once does so; a continued session resumes neither the tour nor the way home.
  PlatformMotion(const Scenario& scenario, const RoomAxes& axes, bool begins);

  /// Starts the scenario's tour with the next frame, at its first leg. The platform must be at rest or move
  /// as in the scenario's initial state, otherwise the tour would end elsewhere; if it does not, a message
  /// says so.
  void setOut() { tour_.isDue = true; }

  /// Advances the observers by dτ of the fastest while their tracked heads move to `heads`, as in
  /// Observers::step. The platform follows the wish of observer `steering`, or else its current manoeuvre.
  void advance(const DriveWish& wish, double dtau_s, double pace, std::span<const Head> heads,
               Observers& observers, std::size_t steering = 0);

  const DriveView& view() const { return view_; }  ///< of the last frame; thrust is the mean over it
  /// Returns and clears the message since the last call; empty if there is none.
  texts::Saying takeNotice() { return std::exchange(notices_.latest, {}); }

 private:
  /// A constant thrust, or a turn about the head, of duration `for_s`.
  struct Manoeuvre {
    double for_s = 0.0;
    Vec3 thrust_m_s2{0.0};
    double turn_rad = 0.0;
    Vec3 turnAxisInRoom{0.0};
  };
  /// A frame in which the heads move from where `before` has them to `heads`.
  struct Frame {
    const Observers& before;
    std::span<const Head> heads;
    double person_s;  ///< proper time of the fastest observer
    double pace;
    std::size_t steering;

    /// Returns the frame's duration in the room's time with this thrust. It runs evenly meanwhile.
    double platform_s(const Vec3& thrust_m_s2 = Vec3(0.0)) const {
      return before.roomTimeOf_s(person_s, heads, pace, thrust_m_s2, steering);
    }
  };
  /// The rest of a frame; the observers have lived the part before it.
  struct Left {
    const Frame& frame;
    const Observers& observers;
    double share;

    /// Returns its duration in the room's time with this thrust.
    double platform_s(const Vec3& thrust_m_s2 = Vec3(0.0)) const { return lasts_s(share, thrust_m_s2); }
    double person_s() const { return share * frame.person_s; }
    /// Returns how long a part of the frame, which begins here, lasts; for one observer it is in proportion.
    double lasts_s(double part, const Vec3& thrust_m_s2) const;
    /// Returns the part of the frame that lasts `for_s`, less than the rest.
    double partThatLasts(double for_s, const Vec3& thrust_m_s2) const;
    template <typename Gain>
    Vec3 meanOf(const Gain& gain_m_s) const;
  };

  void apply(const DriveWish& wish);
  void begin(const Observers& observers);
  void endTour(const Observers& observers);
  Manoeuvre next(const DriveWish& wish, const Observers& observers, const Vec3& headInRoom_m,
                 const Left& left);
  Manoeuvre steered(const Vec3& steer, const Observers& observers, const Left& left);
  Manoeuvre coast(const Observers& observers, const Left& left);
  Manoeuvre stopAtWall(const Observers& observers, const Left& left);
  bool staysInHall(const Lorentz& boardFromRoom, const Vec3& place_m) const;
  Manoeuvre brake(const Observers& observers, const Left& left) const;
  Manoeuvre returnHome(const Observers& observers, const Vec3& headInRoom_m, const Left& left);
  Manoeuvre alongWay(const Left& left);
  void leaveWay(DriveMode mode);

  double c_m_s_, strongest_m_s2_, most_u_;
  std::size_t steering_ = 0;  ///< the observer about whom the room turns, and for whom its thrust is given
  Vec3 up_;                   ///< of the room
  std::optional<glm::dvec2>
      halfHall_m_;       ///< how far the head may go from the table's centre; empty: anywhere
  Pose boardFromHome_;   ///< of the room at rest, at home
  Vec3 atStart_u_{0.0};  ///< of the room in the scenario's initial state
  /// Steered by hand at some time; otherwise the scenario intends any distance from the table.
  bool steered_ = false;
  /// The scenario's flight.
  struct Tour {
    std::vector<Thrust> thrusts;
    bool isDue = false;                        ///< it begins with the next frame
    bool hasSetOut = false;                    ///< its first thrust has begun
    std::size_t by = 0;                        ///< the observer whose clock times it
    double setOut_s = 0.0, setOutOwn_s = 0.0;  ///< board time and that clock's at the first thrust
  } tour_;
  ThrustWay way_;
  DriveView view_;
  struct Notices {
    texts::Saying latest;
    bool saidStrongest = false, saidFastest = false, saidFar = false, saidWall = false;

    void sayOnce(bool& said, const texts::Saying& words) {
      if (!said) latest = words;
      said = true;
    }
  } notices_;
};

}  // namespace carom
