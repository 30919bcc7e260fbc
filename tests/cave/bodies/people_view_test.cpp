#include "cave/bodies/people_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cave/marks/spacetime_marks.h"
#include "cave/scene/person_model.h"
#include "cave/scene/scene_builder.h"
#include "engine/light_speed.h"
#include "engine/linked/told.h"

namespace carom {
namespace {

using test::kC_m_s;

struct PeopleView : testing::Test {
  PeopleView() {
    BilliardSetup setup;
    setup.lightSpeed_m_s = kC_m_s;
    scene = buildScene(setup, {});
    addPeople(scene);
    bodies.resize(scene.bodyCount);
    // Two people; the second looks along y, walks along x at 0.3 m/s, and draws the cue back against −x.
    for (std::size_t person = 0; person < 2; ++person) {
      paths.emplace_back(kC_m_s);
      for (int i = 0; i < 300; ++i) {
        const double t_s = i / 30.0;
        ToldMoment moment;
        moment.person = person;
        moment.head = {t_s, {2.0 + 0.3 * t_s * static_cast<double>(person), 1.0, 0.9}};
        moment.hand = {t_s, moment.head.r_m + Vec3(-0.3, 0.2, -0.4)};
        moment.properTime_s = t_s;
        moment.facing_rad = 0.5 * std::numbers::pi;
        moment.hasHand = moment.hasCue = person;
        moment.cue_rad = std::numbers::pi;
        paths.back().add(moment);
      }
    }
  }

  /// The place at which the eye sees a point of a body, in the head's frame.
  glm::dvec3 seen(std::size_t body, const Vec3& offset_m) const {
    const BodyView& view = bodies[body];
    const auto vertex = emissionIn(view, offset_m);
    return seenFromEye(view, vertex);
  }

  Scene scene;
  std::vector<ToldPath> paths;
  std::vector<BodyView> bodies;
  ObserverView observer;
  EyeView eye{{8.0, {-1.0, 0.5, 0.85}}, {}, {}};
};

TEST_F(PeopleView, AHeadIsWhereItsLightComesFrom) {
  for (const double beta : {0.0, 0.6}) {
    observer.headFromBoard = Lorentz::boost(uFromBeta({beta, 0.0, 0.0}), kC_m_s).inverse();
    const SeenPeople people = viewPeople(scene, paths, {}, observer, eye, bodies);
    ASSERT_EQ(people.count, 2U);
    for (const ToldView& person : people.all()) {
      const std::size_t body = bodyOf(scene, person.moment->person, PersonBody::head);
      const Vec3 expected_m = (observer.headFromBoard * (person.head - eye.observation)).dr_m;
      EXPECT_LT(glm::distance(seen(body, Vec3(0.0)), expected_m), 1e-9) << beta;
      const double away_s = glm::distance(person.head.r_m, eye.observation.r_m) / kC_m_s;
      EXPECT_NEAR(person.head.t_s + away_s, 8.0, 1e-12);
    }
  }
}

TEST_F(PeopleView, WhoeverStandsLooksAndPointsAsTheyWereToldTo) {
  observer.headFromBoard = Lorentz(kC_m_s);
  viewPeople(scene, paths, {}, observer, eye, bodies);
  const std::size_t head = bodyOf(scene, 0, PersonBody::head), cue = bodyOf(scene, 1, PersonBody::cue);
  const Vec3 nose_m = seen(head, {0.05, 0.0, 0.0}) - seen(head, Vec3(0.0));
  EXPECT_LT(glm::distance(nose_m, Vec3(0.0, 0.05, 0.0)), 1e-9);
  const Vec3 tip_m = seen(cue, {0.05, 0.0, 0.0}) - seen(cue, Vec3(0.0));
  EXPECT_LT(tip_m.x, -0.03);
  EXPECT_NEAR(tip_m.y, 0.0, 1e-9);
}

TEST_F(PeopleView, WhoHasNoHandNorCueIsDrawnWithoutAndWhoIsNotSeenNotAtAll) {
  observer.headFromBoard = Lorentz(kC_m_s);
  viewPeople(scene, paths, {}, observer, eye, bodies);
  const auto isSeen = [&](std::size_t person, PersonBody part) {
    return !bodies[bodyOf(scene, person, part)].legs.empty();
  };
  EXPECT_TRUE(isSeen(0, PersonBody::head) && isSeen(1, PersonBody::head));
  EXPECT_TRUE(isSeen(1, PersonBody::hand) && isSeen(1, PersonBody::cue));
  EXPECT_FALSE(isSeen(0, PersonBody::hand) || isSeen(0, PersonBody::cue) || isSeen(2, PersonBody::head));
  eye.observation.t_s = 1.0;  // their light is not there yet
  EXPECT_EQ(viewPeople(scene, paths, {}, observer, eye, bodies).count, 0U);
  EXPECT_FALSE(isSeen(0, PersonBody::head) || isSeen(1, PersonBody::cue));
}

TEST_F(PeopleView, WithoutRetardationTheyStandWhereTheyWereLastToldOf) {
  observer.headFromBoard = Lorentz(kC_m_s);
  Switches switches;
  switches.retardation = 0;
  eye.observation.t_s = 50.0;
  const SeenPeople people = viewPeople(scene, paths, switches, observer, eye, bodies);
  ASSERT_EQ(people.count, 2U);
  EXPECT_EQ(people.people[1].head.r_m, paths[1].moments().back().head.r_m);
  const Vec3 expected_m = people.people[1].head.r_m - eye.observation.r_m;
  EXPECT_LT(glm::distance(seen(bodyOf(scene, 1, PersonBody::head), Vec3(0.0)), expected_m), 1e-9);
}

// The clock of each, and above it the name of who has one.
TEST_F(PeopleView, ANameStandsAboveTheClock) {
  observer.headFromBoard = Lorentz(kC_m_s);
  observer.middle = eye;
  for (std::size_t person = 0; person < 2; ++person) {
    ToldMoment last = paths[person].moments().back();
    last.setName(person == 0 ? std::string_view("Anna") : kUnnamed);
    last.kind = ToldKind::begins;
    paths[person].add(last);
  }
  eye.observation.t_s = observer.middle.observation.t_s = 20.0;
  const SeenPeople people = viewPeople(scene, paths, {}, observer, eye, bodies);
  MarkContext sight{observer, eye, {}, {}, 0, {}, bodies, {}, {}};
  sight.people = people.all();
  LabelLayout crowd(sight);
  MarkBuffer batch;
  addPeopleClocks(sight, scene.firstPerson, crowd, batch);
  constexpr std::size_t kCorners = 24;  // of a plate
  ASSERT_EQ(batch.corners().size(), 3 * kCorners);
  const auto middle_m = [&](std::size_t plate) { return glm::vec3(batch.corners()[plate * kCorners].plate); };
  EXPECT_LT(std::abs(middle_m(1).x - middle_m(0).x) + std::abs(middle_m(1).y - middle_m(0).y), 1e-6);
  EXPECT_GT(middle_m(1).z - middle_m(0).z, StandingPlate::kPlateHeight_m);
  EXPECT_GT(middle_m(0).z, people.people[0].head.r_m.z - eye.observation.r_m.z + 0.2);
}

}  // namespace
}  // namespace carom
