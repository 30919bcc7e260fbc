// Once things have found their size, a frame of the engine allocates nothing.

#include <gtest/gtest.h>

#include "counted_new.h"
#include "engine/light/point_emission.h"
#include "engine/light/ring_view.h"
#include "engine/meshes.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

TEST(SteadyFrame, RigidBodiesAllocateNothing) {
  test::Random random(61);
  const test::Cloud cloud = test::randomCloud(random, 100, 0.1);
  const WorldLine line = test::randomWorldLine(random, kC_m_s, 0.1, 20, 0.3, 0.9);
  RigidMeshView view(line, cloud.points());
  test::SeenCloud seen(100);
  std::size_t allocations = 0;
  for (int round = 0; round < 2; ++round) {  // the first round finds the longest chain of legs
    const std::size_t before = test::allocationCount();
    for (double t_s = -1.0; t_s < 9.0; t_s += 1.0 / 60.0) {
      view.look({t_s, {0.3, 0.2, 0.1}}, Lorentz(kC_m_s));
      view.see(0, seen.points());
    }
    allocations = test::allocationCount() - before;
  }
  EXPECT_EQ(allocations, 0U);
}

// However many legs a world line has: so a row of an hour's export costs what a row of a minute's costs.
TEST(SteadyFrame, AnObservationOfAPointAllocatesNothing) {
  test::Random random(63);
  for (const int legs : {10, 1000}) {
    const WorldLine line = test::randomWorldLine(random, kC_m_s, 0.1, legs, 0.3, 0.9);
    const Vec3 offset_m = random.inBall(0.1);
    const PointEmission point(line, offset_m);
    const double end_s = line.knots().back().turn.t_s + 1.0;
    for (double part = 0.0; part <= 1.0; part += 1.0 / 64.0) {
      SCOPED_TRACE(testing::Message() << legs << " legs, at " << part);
      const Event eye{part * end_s, {0.3, 0.2, 0.1}};
      const std::size_t before = test::allocationCount();
      const std::optional<Emission> seen = point.seenAt(eye, Lorentz(kC_m_s));
      ASSERT_EQ(test::allocationCount(), before);
      const std::optional<Emission> alone = emission(line, offset_m, eye, Lorentz(kC_m_s));
      ASSERT_TRUE(seen && alone);
      ASSERT_EQ(seen->event.t_s, alone->event.t_s);
      ASSERT_EQ(seen->properTime_s, alone->properTime_s);
    }
  }
}

TEST(SteadyFrame, SampledMeshesAllocateNothingEvenWhileTheyAreRecorded) {
  test::Random random(62);
  const test::Cloud cloud = test::randomCloud(random, 500, 0.1);
  const std::vector<float> simultaneous(500);
  VertexRing ring(500, 100, kC_m_s);
  RingView view(ring);
  test::SeenCloud seen(500);
  std::size_t before = 0;
  for (int frame = 0; frame < 600; ++frame) {  // the ring fills, overflows, and is trimmed
    if (frame == 10) before = test::allocationCount();
    const double t_s = frame / 60.0;
    ring.append({{t_s, {0.2 * std::sin(t_s), 0.0, 0.0}}, simultaneous, cloud.x, cloud.y, cloud.z});
    const Event eye{frame < 300 ? 0.5 : t_s, {0.0, -0.5, 0.3}};
    ring.trim({&eye, 1});
    view.look(eye, Lorentz(kC_m_s));
    view.see(0, seen.points());
  }
  EXPECT_EQ(test::allocationCount() - before, 0U);
}

}  // namespace
}  // namespace carom
