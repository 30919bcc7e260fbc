// The hall: as large as its board asks for, and closed.
#include "cave/scene/hall_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "cave/scene/scene_edges.h"

namespace carom {
namespace {

using test::boardOf;
using test::edgesOf;
using test::kPucks;

TEST(Scene, ALargeBoardGetsALargerHall) {
  double widest = 0.0;
  for (const ScenePart& part : buildScene(boardOf(10.0, 10.0), kPucks).parts)
    widest = std::max(widest, part.mesh->GetBounds()[1]);
  EXPECT_NEAR(widest, 10.0, 1e-6);
}

// Floor, walls and ceiling close the hall: where their cells differed, slow light would open cracks.
TEST(Scene, TheHallHasNoCracks) {
  for (const std::size_t most : {std::size_t{1}, std::size_t{80000}}) {
    Tessellation tessellation;
    tessellation.mostVertices = most;
    std::vector<ScenePart> shell;
    for (const ScenePart& part : buildScene(boardOf(2.84, 1.42), {}, {}, {}, tessellation).parts) {
      if (part.paint == Paint::floor || part.paint == Paint::panels) shell.push_back(part);
    }
    ASSERT_EQ(shell.size(), 6U);
    for (const auto& [ends, count] : edgesOf(shell)) {
      ASSERT_EQ(count, 2) << ends[0] << ", " << ends[1] << ", " << ends[2] << " µm";
    }
  }
}

}  // namespace
}  // namespace carom
