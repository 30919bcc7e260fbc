// Whether nodes that show different things are found out.
#include "cave/record/frame_digest.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

constexpr std::size_t kSwitchesField = 3;

TEST(FrameDigest, EachOfTheOperatorsChoicesCounts) {
  ASSERT_STREQ(FrameDigest::kFields[kSwitchesField], "switches");
  const FrameState plain;
  for (const WallControls& controls :
       {WallControls{Shown::calibrationPattern, 0, 0}, WallControls{Shown::alignmentPattern, 0, 0},
        WallControls{Shown::session, 1, 0}, WallControls{Shown::session, 0, 1}}) {
    FrameState other;
    other.record.controls = controls;
    const FrameDigest expected = digestOf(plain, {}), found = digestOf(other, {});
    for (std::size_t field = 0; field < FrameDigest::kFields.size(); ++field) {
      EXPECT_EQ(expected.fields[field] != found.fields[field], field == kSwitchesField)
          << FrameDigest::kFields[field];
    }
  }
}

TEST(FrameDigest, HowACollisionActsCounts) {
  constexpr std::size_t kEventsField = 6;
  ASSERT_STREQ(FrameDigest::kFields[kEventsField], "new events");
  FrameState plain, atOnce, sides;
  for (FrameState* state : {&plain, &atOnce, &sides}) state->events.emplace_back();
  atOnce.events[0].withoutDelay = true;
  sides.events[0].sideOnSide = true;
  const std::uint64_t digests[]{digestOf(plain, {}).fields[kEventsField],
                                digestOf(atOnce, {}).fields[kEventsField],
                                digestOf(sides, {}).fields[kEventsField]};
  EXPECT_NE(digests[0], digests[1]);
  EXPECT_NE(digests[0], digests[2]);
  EXPECT_NE(digests[1], digests[2]);
}

}  // namespace
}  // namespace carom
