// Once its lists have found their size, choosing chunks allocates nothing.
#include <gtest/gtest.h>

#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "cave/bodies/visible_chunks.h"
#include "cave/frame/bodies.h"
#include "cave/scene/scene_builder.h"
#include "counted_new.h"

namespace carom {
namespace {

TEST(SteadyCulling, AllocatesNothing) {
  constexpr double kC_m_s = 1.42;
  BilliardSetup setup;
  setup.board = Board{2.84, 1.42};
  const std::vector<BodyLooks> looks{{"white", "", 0.03, 0.02}};
  const Scene scene = buildScene(setup, looks, {}, {}, {0.001, 5000});
  const SceneChunks chunks(scene);
  VisibleChunks visible(chunks);
  const Lorentz headFromBoard = Lorentz::boost({0.3, 0.5, 0.0}, kC_m_s);
  const WorldLine puck({{0.0, {0.2, 0.1, 0.01}}, {0.4, 0.0, 0.0}, 0.0, {}, 0.0}, kC_m_s, scene.reach_m[1]);
  std::vector<BodyView> bodies(2);
  const glm::dmat4 projection = glm::perspective(1.5, 1.0, 0.03, 5000.0);
  std::size_t before = 0, chosen = 0;
  for (int frame = 0; frame < 20; ++frame) {
    if (frame == 1) before = test::allocationCount();
    const Event eye{0.1 * frame, {0.0, -1.6, 0.85}};
    viewBody(restingWorldLine(kC_m_s), eye, headFromBoard, bodies[0]);
    const std::size_t ofWorldLine = test::allocationCount();
    viewBody(puck, eye, headFromBoard, bodies[1]);
    visible.look(bodies, ViewFrame(headFromBoard, {}));
    for (const double angle_rad : {0.0, 1.5, 3.0}) {
      visible.choose(glm::rotate(projection, angle_rad, glm::dvec3(0.0, 1.0, 0.0)));
      chosen += visible.chosen().size();
    }
    const std::size_t allocated = test::allocationCount() - ofWorldLine;
    EXPECT_TRUE(frame == 0 || allocated == 0) << "frame " << frame << ": " << allocated;
  }
  EXPECT_GT(test::allocationCount(), before) << "making a world line is counted";
  EXPECT_GT(chosen, 0U);
}

}  // namespace
}  // namespace carom
