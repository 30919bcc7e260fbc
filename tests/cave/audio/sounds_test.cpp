// The clicks of events.
#include "cave/audio/sounds.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace carom {
namespace {

// Clicks can be told apart: each dies away, and crosses zero as often as its pitch says.
TEST(Clicks, SoundUnlike) {
  const auto crossings = [](EventKind kind) {
    const std::vector<short> samples = clickOf(kind);
    EXPECT_EQ(samples.front(), 0);
    EXPECT_LT(std::abs(samples.back()), 200) << "no crack at its end";
    int count = 0;
    for (std::size_t i = 1; i < samples.size() / 8; ++i)
      count += (samples[i] > 0) != (samples[i - 1] > 0) ? 1 : 0;
    return count;
  };
  EXPECT_GT(crossings(EventKind::puckPuck), 2 * crossings(EventKind::stroke));
  EXPECT_GT(crossings(EventKind::stroke), 2 * crossings(EventKind::puckCushion));
}

}  // namespace
}  // namespace carom
