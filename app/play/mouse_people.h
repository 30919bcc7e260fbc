#pragma once
// Heads and wands that mouse and keys move, in the place of a room's trackers: for a dry run of the room.
//
//   arrows               walk, as the head faces
//   Page Up, Page Down   raise and lower the head
//   Delete, End          turn head and wand to the left and to the right
//   mouse                head and wand turn to the place on a wall that it points to; its left button is the
//                        wand's button 0, and what the mouse moves on the cloth meanwhile the wand moves, too
//
// They move the viewer over whose walls the mouse was last; the others stand still beside that one. Nobody
// walks through a wall. The rest of the mouse and the keys is as at a desk (app/input/desk_controls.h).

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/input/desk_input.h"
#include "app/rig/rig.h"
#include "devices/tracker/tracker.h"

namespace carom {

class MousePeople {
 public:
  static constexpr double kWalk_m_s = 0.7, kTurn_rad_s = 1.0;
  static constexpr double kNearestWall_m = 0.1;  ///< of a head
  static constexpr double kFarthest_m = 5.0;     ///< from where they begin
  static constexpr double kReach_m = 0.7;        ///< how far a wand can be drawn

  /// Puts every viewer of the rig where the trackers' person would stand, one beside the other.
  explicit MousePeople(const Rig& rig);

  /// Goes on to session time `now_s` with the desk's input, which is that of `viewer`.
  void move(const DeskInput& desk, std::size_t viewer, double now_s);

  /// Returns their only tracker, with the sensors that the rig's viewers name. This object must outlive it.
  std::unique_ptr<Tracker> tracker() const;

 private:
  class Sensors;
  struct Person {
    int headSensor = 0, handSensor = 0;
    Vec3 eyes_m{0.0}, velocity_m_s{0.0};
    Vec3 forward{0.0};              ///< unit vector of the gaze
    Vec3 along{0.0};                ///< unit vector of the wand
    std::optional<Vec3> pointed_m;  ///< where the mouse points to on a wall
    bool followsMouse = false;      ///< the gaze is where the mouse points to
    bool isHeld = false;            ///< the wand's button
    Vec3 pressed_m{0.0};            ///< where the mouse pointed to on the cloth when the button went down
    Vec3 drawn_m{0.0};              ///< of the wand, from its place before the body
  };
  /// A wall's plane.
  struct Plane {
    Vec3 place_m, normal;
  };

  void walk(const DeskInput& desk, double step_s, Person& person) const;
  void look(const DeskInput& desk, double step_s, Person& person) const;
  void draw(bool isHeld, double step_s, Person& person) const;
  Vec3 inside(const Vec3& place_m) const;
  Vec3 level(const Vec3& forward) const;
  Vec3 wand_m(const Person& person) const;
  std::optional<Vec3> onCloth(const Person& person) const;
  glm::dquat facing(const Vec3& forward) const;

  RoomAxes axes_;
  Vec3 start_m_;
  std::vector<Plane> walls_;  ///< those that face the start
  std::vector<Person> people_;
  double moved_s_ = 0.0;
};

}  // namespace carom
