#include "engine/spacetime/simultaneity.h"

#include <gtest/gtest.h>

#include "engine/light_speed.h"
#include "engine/random_world.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

using test::kC_m_s;

TEST(Simultaneity, TheNamedObserverIndeedSeesThemAtOnceOrAtOnePlace) {
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Displacement d{random.in(-3, 3), random.inBox(3.0)};
    SCOPED_TRACE(testing::Message() << "dt " << d.dt_s << " dr " << d.dr_m.x << " " << d.dr_m.y << " "
                                    << d.dr_m.z);
    const Relation relation = relationOf(d, kC_m_s);
    ASSERT_TRUE(relation.beta);
    ASSERT_LT(glm::length(*relation.beta), 1.0);
    const Vec3 u = uFromBeta(*relation.beta);
    const Displacement theirs = Lorentz::boost(u, kC_m_s).inverse() * d;
    const double rounding_m = 1e-14 * gammaFromU(u) * 10.0;  // of coordinates below 10 m, stretched by gamma
    if (relation.separation == Separation::spacelike) {
      ASSERT_NEAR(kC_m_s * theirs.dt_s, 0.0, rounding_m);
      ASSERT_NEAR(glm::length(theirs.dr_m), relation.length_m, rounding_m);
    } else {
      ASSERT_EQ(relation.separation, Separation::timelike);
      ASSERT_NEAR(glm::length(theirs.dr_m), 0.0, rounding_m);
      ASSERT_NEAR(kC_m_s * std::abs(theirs.dt_s), relation.length_m, rounding_m);
    }
  }
}

TEST(Simultaneity, NobodyUpsetsTheOrderOfTimelikeEventsAndSomeoneThatOfSpacelikeOnes) {
  test::Random random(4);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const Displacement d{random.in(0.1, 3), random.inBox(3.0)};
    const Relation relation = relationOf(d, kC_m_s);
    bool upset = false;
    for (int observer = 0; observer < 400; ++observer) {
      upset = upset || (Lorentz::boost(random.u(0.999), kC_m_s).inverse() * d).dt_s < 0.0;
    }
    if (relation.separation == Separation::timelike) {
      ASSERT_FALSE(upset) << "dt " << d.dt_s << " dr " << glm::length(d.dr_m);
    } else if (glm::length(*relation.beta) < 0.5) {
      ASSERT_TRUE(upset) << "dt " << d.dt_s << " dr " << glm::length(d.dr_m);
    }
  }
}

TEST(Simultaneity, LightIsToldFromBothInEveryDirection) {
  test::Random random(5);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const Vec3 dr_m = random.inBox(3.0);
    const Relation relation = relationOf({glm::length(dr_m) / kC_m_s, dr_m}, kC_m_s);
    EXPECT_EQ(relation.separation, Separation::lightlike);
    EXPECT_EQ(relation.length_m, 0.0);
    EXPECT_FALSE(relation.beta);
  }
  EXPECT_EQ(relationOf({0.0, Vec3(0.0)}, kC_m_s).separation, Separation::lightlike)
      << "one event with itself";
}

}  // namespace
}  // namespace carom
