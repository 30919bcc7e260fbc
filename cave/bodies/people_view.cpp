#include "cave/bodies/people_view.h"

#include <cmath>
#include <limits>
#include <memory_resource>
#include <numbers>
#include <optional>

#include "cave/scene/person_model.h"
#include "engine/linked/promise.h"
#include "engine/spacetime/world_line.h"

namespace carom {
namespace {

constexpr double kAppearing_s = 3.0;  // more than light takes across a person

/// Views a body that has always moved as at this knot. Takes no memory but the view's.
void viewRigidly(const Knot& seen, double reach_m, double appears_s, const ObserverView& observer,
                 const EyeView& eye, const Switches& switches, BodyView& view) {
  std::array<std::byte, 4096> bytes;
  std::pmr::monotonic_buffer_resource memory(bytes.data(), bytes.size());
  const WorldLine line(seen, observer.headFromBoard.lightSpeed_m_s(), reach_m, appears_s, &memory);
  viewBody(line, eye.observation, observer.headFromBoard, view, switches);
}

}  // namespace

SeenPeople viewPeople(const Scene& scene, std::span<const ToldPath> paths, const Switches& switches,
                      const ObserverView& observer, const EyeView& eye, std::span<BodyView> bodies) {
  SeenPeople seen;
  if (scene.firstPerson == 0) return seen;
  for (BodyView& body : bodies.subspan(scene.firstPerson)) body.legs.clear();
  const Event& here = eye.observation;
  const double c_m_s = observer.headFromBoard.lightSpeed_m_s();
  const auto since_s = [&](const Event& event) {
    return switches.retardation ? afterLightOf_s(event, here, c_m_s) : here.t_s - event.t_s;
  };
  for (std::size_t number = 0; number < paths.size(); ++number) {
    const std::optional<ToldView> person = paths[number].at(since_s);
    if (!person) continue;
    seen.people.at(seen.count++) = *person;
    const double appears_s = person->head.t_s - person->appears_s < kAppearing_s
                                 ? person->appears_s
                                 : -std::numeric_limits<double>::infinity();
    const auto show = [&](PersonBody part, const Event& at, double angle_rad) {
      const std::size_t body = bodyOf(scene, number, part);
      Knot knot{at, person->u, person->properTime_s, at};
      knot.spin.angle_rad = std::remainder(angle_rad, 2.0 * std::numbers::pi);
      viewRigidly(knot, scene.reach_m[body], appears_s, observer, eye, switches, bodies[body]);
    };
    show(PersonBody::head, person->head, person->moment->facing_rad);
    if (person->handMoment->hasHand) show(PersonBody::hand, person->hand, 0.0);
    if (person->handMoment->hasCue) show(PersonBody::cue, person->hand, person->handMoment->cue_rad);
  }
  return seen;
}

}  // namespace carom
