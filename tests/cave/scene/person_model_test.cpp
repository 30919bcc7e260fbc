#include "cave/scene/person_model.h"

#include <gtest/gtest.h>

#include <vector>

#include "cave/red_green.h"
#include "cave/scene/scene_builder.h"

namespace carom {
namespace {

Scene emptyScene() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  return buildScene(setup, {});
}

Scene sceneWithPeople() {
  Scene scene = emptyScene();
  addPeople(scene);
  return scene;
}

TEST(PersonModel, PeopleAreTheLastBodiesOfAScene) {
  const Scene without = emptyScene();
  EXPECT_EQ(without.firstPerson, 0U);
  const Scene scene = sceneWithPeople();
  EXPECT_EQ(scene.firstPerson, without.bodyCount);
  EXPECT_EQ(scene.bodyCount, without.bodyCount + kMostViewers * kBodiesOfPerson);
  EXPECT_EQ(scene.reach_m.size(), scene.bodyCount);
  std::vector<int> parts(scene.bodyCount);
  for (const ScenePart& part : scene.parts) ++parts.at(part.body);
  for (std::size_t person = 0; person < kMostViewers; ++person) {
    EXPECT_EQ(parts[bodyOf(scene, person, PersonBody::head)], 4);
    EXPECT_EQ(parts[bodyOf(scene, person, PersonBody::hand)], 1);
    EXPECT_EQ(parts[bodyOf(scene, person, PersonBody::cue)], 1);
  }
}

TEST(PersonModel, TheyLookAndPointAlongXAndNothingReachesFartherThanTheSceneSays) {
  const Scene scene = sceneWithPeople();
  for (const ScenePart& part : scene.parts) {
    if (part.body < scene.firstPerson) continue;
    double farthest_m = 0.0;
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      const glm::dvec3 place(part.mesh->GetPoint(i)[0], part.mesh->GetPoint(i)[1], part.mesh->GetPoint(i)[2]);
      farthest_m = std::max(farthest_m, glm::length(place));
    }
    EXPECT_LE(farthest_m, scene.reach_m[part.body]) << part.body;
    const double* bounds = part.mesh->GetBounds();
    EXPECT_NEAR(bounds[2], -bounds[3], 1e-6) << "left and right are alike";
    const bool isGlasses = part.colour == glm::vec3(0.02F);
    if (isGlasses) {
      EXPECT_GT(bounds[1], 0.015) << "before the eyes";
    }
    const bool isCue = part.body == bodyOf(scene, 0, PersonBody::cue);
    if (isCue) {
      EXPECT_GT(bounds[1], -bounds[0]) << "held behind its middle";
    }
  }
}

TEST(PersonModel, CoatsDifferForEyesWithoutRedOrGreenCones) {
  for (std::size_t i = 0; i < kCoatColours.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(test::leastDifference(kCoatColours[i], kCoatColours[j]), 12.0) << i << ", " << j;
}

}  // namespace
}  // namespace carom
