#include "app/play/mouse_people.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "devices/setup/tracker_setup.h"

namespace carom {
namespace {

constexpr double kSoftly_s = 0.15;      // within which they begin to walk, and stop
constexpr double kLongestStep_s = 0.1;  // longer pauses are no time to walk in
constexpr double kGaze_rad_s = 4.0;     // how fast a head turns to the mouse
constexpr double kSteepest = 0.966;     // sine of the steepest gaze, 75 degrees
constexpr double kBack_s = 0.1;         // within which a wand returns
constexpr double kBeside_m = 0.6;       // between two people
constexpr double kCloth_m = 0.75;       // above the floor, in all games but few
const Vec3 kGrip_m{0.2, -0.35, 0.35};   // of the wand, from the eyes: right, up, ahead

/// Returns the unit vector on the way from one unit vector to another, at most `most_rad` from the first.
Vec3 turnedTo(const Vec3& from, const Vec3& to, double most_rad) {
  const double angle_rad = std::acos(std::clamp(glm::dot(from, to), -1.0, 1.0));
  if (angle_rad <= most_rad) return to;
  const Vec3 aside = to - glm::dot(to, from) * from;
  if (!(glm::length(aside) > 1e-9)) return from;  // the opposite: it may turn either way, at the next motion
  return std::cos(most_rad) * from + std::sin(most_rad) * glm::normalize(aside);
}

}  // namespace

class MousePeople::Sensors : public Tracker {
 public:
  explicit Sensors(const MousePeople& people) : people_(people) {}

  void poll(double now_s, std::vector<TrackerSample>& samples) override {
    for (const Person& person : people_.people_) {
      samples.push_back({now_s, person.headSensor, {person.eyes_m, people_.facing(person.forward)}, true});
      samples.push_back(
          {now_s, person.handSensor, {people_.wand_m(person), people_.facing(person.along)}, true});
    }
  }

  void takeInputs(std::vector<Reading>& inputs) override {
    for (const Person& person : people_.people_) {
      Reading trigger;
      trigger.kind = Reading::Kind::button;
      trigger.sensor = person.handSensor;
      trigger.value = person.isHeld ? 1.0 : 0.0;
      inputs.push_back(trigger);
    }
  }

 private:
  const MousePeople& people_;
};

MousePeople::MousePeople(const Rig& rig) : axes_(rig.axes), start_m_(rig.axes.up * kStandingEyes_m) {
  for (const Wall& wall : rig.walls) {
    const Plane plane{wall.lowerLeft_m, normalOf(wall)};
    if (glm::dot(plane.normal, start_m_ - plane.place_m) > kNearestWall_m) walls_.push_back(plane);
  }
  for (const ViewerSetup& viewer : rig.viewers) {
    Person person;
    person.headSensor = viewer.head.sensor.sensor;
    person.handSensor = viewer.hand ? viewer.hand->sensor : -1;
    person.eyes_m = inside(start_m_ + kBeside_m * static_cast<double>(people_.size()) * axes_.right);
    person.forward = person.along = axes_.forward;
    people_.push_back(person);
  }
}

std::unique_ptr<Tracker> MousePeople::tracker() const { return std::make_unique<Sensors>(*this); }

void MousePeople::move(const DeskInput& desk, std::size_t viewer, double now_s) {
  const double step_s = std::clamp(now_s - std::exchange(moved_s_, now_s), 0.0, kLongestStep_s);
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const DeskInput& own = i == viewer ? desk : DeskInput{};
    walk(own, step_s, people_[i]);
    look(own, step_s, people_[i]);
    draw(own.mouseHeld, step_s, people_[i]);
  }
}

void MousePeople::walk(const DeskInput& desk, double step_s, Person& person) const {
  const Vec3 ahead = level(person.forward), right = glm::cross(ahead, axes_.up);
  Vec3 wish = desk.walk.x * right + desk.walk.y * ahead + desk.walk.z * axes_.up;
  if (glm::length(wish) > 1.0) wish = glm::normalize(wish);
  person.velocity_m_s += (1.0 - std::exp(-step_s / kSoftly_s)) * (kWalk_m_s * wish - person.velocity_m_s);
  person.eyes_m = inside(person.eyes_m + step_s * person.velocity_m_s);
}

/// Turns head and wand to where the mouse points to, from when it moves until keys turn them. While the
/// button is held they stay as they are, for the mouse then draws the wand.
void MousePeople::look(const DeskInput& desk, double step_s, Person& person) const {
  if (desk.mouse) {
    if (desk.mouse->onWall_m != person.pointed_m) person.followsMouse = true;
    person.pointed_m = desk.mouse->onWall_m;
  }
  if (desk.look != 0.0) person.followsMouse = false;
  if (person.isHeld) return;
  Vec3 wanted = glm::angleAxis(-desk.look * kTurn_rad_s * step_s, axes_.up) * person.forward;
  if (person.followsMouse) wanted = glm::normalize(*person.pointed_m - person.eyes_m);
  const double rises = std::clamp(glm::dot(wanted, axes_.up), -kSteepest, kSteepest);
  const Vec3 flat = glm::length(wanted - glm::dot(wanted, axes_.up) * axes_.up) > 1e-3
                        ? level(wanted)
                        : level(person.forward);
  wanted = std::sqrt(1.0 - rises * rises) * flat + rises * axes_.up;
  person.forward = turnedTo(person.forward, wanted, kGaze_rad_s * step_s);
  const Vec3 toPointed = person.followsMouse ? *person.pointed_m - wand_m(person) : person.forward;
  if (glm::length(toPointed) > 1e-3) person.along = glm::normalize(toPointed);
}

/// Moves the wand as the mouse moves on the cloth while the button is held; later it returns. A stroke is as
/// strong as the wand is drawn in the frame in which the button goes up, so it stays for that frame.
void MousePeople::draw(bool isHeld, double step_s, Person& person) const {
  const bool wasHeld = std::exchange(person.isHeld, isHeld);
  const std::optional<Vec3> now_m = isHeld ? onCloth(person) : std::nullopt;
  if (isHeld && !wasHeld) person.pressed_m = now_m.value_or(Vec3(0.0));
  if (isHeld && now_m) {
    person.drawn_m = *now_m - person.pressed_m;
    const double drawn_m = glm::length(person.drawn_m);
    if (drawn_m > kReach_m) person.drawn_m *= kReach_m / drawn_m;
  } else if (!isHeld && !wasHeld) {
    person.drawn_m *= std::exp(-step_s / kBack_s);
  }
}

/// Returns the place, or the nearest one that is in front of all walls and not too far away.
Vec3 MousePeople::inside(const Vec3& place_m) const {
  Vec3 inside_m = place_m;
  const double far_m = glm::distance(place_m, start_m_);
  if (far_m > kFarthest_m) inside_m = start_m_ + kFarthest_m / far_m * (place_m - start_m_);
  for (const Plane& wall : walls_) {
    const double before_m = glm::dot(wall.normal, inside_m - wall.place_m);
    if (before_m < kNearestWall_m) inside_m += (kNearestWall_m - before_m) * wall.normal;
  }
  return inside_m;
}

Vec3 MousePeople::level(const Vec3& forward) const {
  return glm::normalize(forward - glm::dot(forward, axes_.up) * axes_.up);
}

Vec3 MousePeople::wand_m(const Person& person) const {
  const Vec3 ahead = level(person.forward), right = glm::cross(ahead, axes_.up);
  return inside(person.eyes_m + kGrip_m.x * right + kGrip_m.y * axes_.up + kGrip_m.z * ahead) +
         person.drawn_m;
}

/// Returns the place on the cloth behind which the person sees what the mouse points to.
std::optional<Vec3> MousePeople::onCloth(const Person& person) const {
  if (!person.pointed_m) return std::nullopt;
  const Vec3 way_m = *person.pointed_m - person.eyes_m;
  const double falls_m = -glm::dot(way_m, axes_.up);
  const double share = (glm::dot(person.eyes_m, axes_.up) - kCloth_m) / falls_m;
  if (!(share > 0.0 && share * glm::length(way_m) < kFarthestOnCloth_m)) return std::nullopt;
  return person.eyes_m + share * way_m;
}

/// Returns the orientation whose forward axis is `forward`, without a tilt to the side.
glm::dquat MousePeople::facing(const Vec3& forward) const {
  const Vec3 right = glm::normalize(glm::cross(forward, axes_.up)), up = glm::cross(right, forward);
  const glm::dmat3 to(right, up, forward), from(axes_.right, axes_.up, axes_.forward);
  return glm::normalize(glm::quat_cast(to * glm::transpose(from)));
}

}  // namespace carom
