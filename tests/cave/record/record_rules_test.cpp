// What a frame, its knots, its events and what is told of people may hold: the first impossible field is
// named.
#include "cave/record/record_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace carom {
namespace {

const double kNaN = std::nan("");

template <typename Expect>
std::string complaint(const Expect& expect) {
  try {
    expect();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing is wrong";
}

template <typename Change>
std::string ofKnot(const Change& change) {
  Knot knot;
  change(knot);
  return complaint([&] { expectPossible(knot); });
}

template <typename Change>
std::string ofEvent(const Change& change) {
  GameEvent event;
  event.turns.push_back({});
  change(event);
  return complaint([&] { expectPossible(event, 2); });
}

TEST(RecordRules, NumbersOfKnotsAreFinite) {
  EXPECT_EQ(ofKnot([](Knot&) {}), "nothing is wrong");
  EXPECT_EQ(ofKnot([](Knot& knot) { knot.u.y = kNaN; }), "a knot's u_y is nan, expected a finite number");
  EXPECT_EQ(ofKnot([](Knot& knot) { knot.turn.t_s = std::numeric_limits<double>::infinity(); }),
            "a knot's t_s is inf, expected a finite number");
  EXPECT_EQ(ofKnot([](Knot& knot) { knot.turn.r_m.z = kNaN; }),
            "a knot's z_m is nan, expected a finite number");
}

TEST(RecordRules, EventsHaveTheirKindsAndTurnPucksOfTheGame) {
  EXPECT_EQ(ofEvent([](GameEvent&) {}), "nothing is wrong");
  EXPECT_EQ(ofEvent([](GameEvent& event) { event.kind = static_cast<EventKind>(9); }),
            "an event's kind is 9, expected 0 to 8");
  EXPECT_EQ(ofEvent([](GameEvent& event) { event.cushion = static_cast<Cushion>(4); }),
            "an event's cushion is 4, expected 0 to 3");
  EXPECT_EQ(ofEvent([](GameEvent& event) { event.turns[0].puck = 2; }),
            "an event turns puck 2, expected one of 2 from 0");
  EXPECT_EQ(ofEvent([](GameEvent& event) { event.turns[0].betaAfter.x = kNaN; }),
            "an event's beta_after_x is nan, expected a finite number");
  EXPECT_EQ(ofEvent([](GameEvent& event) { event.turns[0].spinAfter_kg_m2_s = kNaN; }),
            "an event's spin_after_kg_m2_s is nan, expected a finite number");
}

TEST(RecordRules, PeopleAreThoseOfARoom) {
  ToldMoment moment;
  EXPECT_NO_THROW(expectPossible(moment));
  moment.hasHand = 2;
  EXPECT_EQ(complaint([&] { expectPossible(moment); }), "a person's has_hand is 2, expected 0 to 1");
  moment.hasHand = 1;
  moment.person = kMostViewers;
  EXPECT_EQ(complaint([&] { expectPossible(moment); }).find("a person's number is"), 0U);
}

TEST(RecordRules, OfAFrameTheFirstImpossibleFieldIsNamed) {
  FrameRecord record;
  const auto said = [&] { return complaint([&] { expectPossible(record, 1.42); }); };
  EXPECT_EQ(said(), "board_from_room_ has light at 1 m/s, expected the game's 1.42");
  record.viewerCount = 0;
  EXPECT_EQ(said().find("viewers is 0, expected 1 to"), 0U) << said();
  record.display_s = kNaN;
  EXPECT_EQ(said(), "display_s is nan, expected a finite number");
  record.last = 2;
  EXPECT_EQ(said(), "last is 2, expected 0 to 1");
}

}  // namespace
}  // namespace carom
