// Nothing in the loop allocates.

#include <gtest/gtest.h>

#include <cmath>

#include "counted_new.h"
#include "devices/force/force_loop.h"
#include "devices/force/force_mailbox.h"
#include "devices/force/simulated_force.h"

namespace carom {
namespace {

TEST(ForceAllocations, ThereAreNoneInATick) {
  const ForceLimits limits;
  for (const auto kind : {ForceLaw::Kind::cue, ForceLaw::Kind::heldPuck}) {
    ForceLoop loop(limits);
    SimulatedForce device(limits);
    ForceMailbox<ForceLaw> laws;
    ForceMailbox<ForceReport> reports;
    ForceLaw law;
    law.kind = kind;
    law.held = true;
    law.cue = {0.403, 0.08, 0.5};
    law.puck = {0.2, 1.42, {0.7, 0.0, 0.0}, 600.0, 0.0};
    const std::size_t before = test::allocationCount();
    for (int i = 0; i < 5000; ++i) {
      const double now_s = i * 1e-3;
      law.posted_s = now_s;
      laws.post(law);
      device.wish({-0.1 * std::sin(now_s), 0.0, 0.0});
      device.write(loop.tick(now_s, device.read(now_s), laws.look()));
      reports.post(loop.report());
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(reports.look().active);
  }
}

}  // namespace
}  // namespace carom
