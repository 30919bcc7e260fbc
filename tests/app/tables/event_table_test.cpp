// Events in any frame: the order of two collisions far apart, and when their light arrives.
#include "app/tables/event_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/scenario/scenario.h"
#include "engine/spacetime/lorentz.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
constexpr double kRounding = 1e-12;  // of metres and seconds of order one

const std::vector<std::string> kNobody;

GameEvent flashAt(const Event& at, std::uint64_t number = 0) {
  GameEvent event;
  event.number = number;
  event.at = at;
  return event;
}

/// The first two collisions of the shipped scenario.
std::vector<GameEvent> twoCushions() {
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/two-cushions.toml");
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(2.0);
  std::vector<GameEvent> events;
  for (const GameEvent& event : billiard.events()) {
    if (event.kind == EventKind::puckCushion && events.size() < 2) events.push_back(event);
  }
  return events;
}

// A hand's stroke is no row of the scenario: it goes by the puck that it strikes.
TEST(EventTable, AStrokeOfAHandIsNamedByItsPuck) {
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/two-cushions.toml");
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(0.5);
  const Event hand{0.2, {0.1, -0.9, 0.5}};
  billiard.strike({1, hand.t_s, hand.r_m, {0.05, 0.0}});
  billiard.advanceTo(3.0);
  std::vector<std::string> pucks, flashes;
  for (const Puck& puck : scenario.billiard.pucks) pucks.push_back(puck.name);
  for (const Flash& flash : scenario.billiard.flashes) flashes.push_back(flash.name);
  std::size_t strokes = 0;
  for (const EventRow& row : eventRows(billiard.events(), pucks, flashes, Vec3(0.0), kC_m_s)) {
    if (row.event.kind != EventKind::stroke) continue;
    ++strokes;
    EXPECT_EQ(row.who, pucks[1]);
    EXPECT_NEAR(row.event.at.t_s, hand.t_s, kRounding) << "at the hand";
    EXPECT_LT(glm::distance(row.event.at.r_m, hand.r_m), kRounding);
  }
  EXPECT_EQ(strokes, 1u);
}

TEST(EventTable, TwoCushionsAtOnceComeInEitherOrderForThoseWhoMove) {
  const std::vector<GameEvent> events = twoCushions();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].at.t_s, events[1].at.t_s) << "equal bits";
  EXPECT_EQ(events[0].at.r_m.x, -events[1].at.r_m.x);
  const std::uint64_t right = events[0].at.r_m.x > 0.0 ? events[0].number : events[1].number;
  const double length_m = 2.0 * std::abs(events[0].at.r_m.x), gamma = 1.0 / std::sqrt(1.0 - 0.25);
  for (const double beta : {0.0, 0.5, -0.5}) {
    const std::vector<EventRow> rows = eventRows(events, kNobody, kNobody, {beta, 0.0, 0.0}, kC_m_s);
    EXPECT_EQ(rows[0].order, 1u);
    EXPECT_EQ(rows[1].order, 1u) << "they share their place";
    ASSERT_TRUE(rows[0].toNext);
    EXPECT_FALSE(rows[1].toNext);
    EXPECT_EQ(rows[0].toNext->separation, Separation::spacelike);
    EXPECT_NEAR(rows[0].toNext->length_m, std::hypot(length_m, 0.5), kRounding) << "0.5 m apart across";
    EXPECT_EQ(*rows[0].toNext->beta, Vec3(0.0)) << "at once for who rests";
    const EventRow& ahead = rows[0].event.number == right ? rows[0] : rows[1];
    const EventRow& behind = rows[0].event.number == right ? rows[1] : rows[0];
    // t' = γ (t − β x/c): what lies ahead of the moving one comes first.
    const double apart_s = beta == 0.0 ? 0.0 : gamma * beta * length_m / kC_m_s;
    EXPECT_NEAR(behind.moving.t_s - ahead.moving.t_s, apart_s, kRounding);
    EXPECT_EQ(ahead.movingOrder, beta < 0.0 ? 2u : 1u) << beta;
    EXPECT_EQ(behind.movingOrder, beta > 0.0 ? 2u : 1u) << beta;
  }
}

TEST(EventTable, LightReachesWhoRestsAfterTheWayOverC) {
  for (const GameEvent& event : twoCushions()) {
    for (const Vec3 place_m : {Vec3(0.0, -1.6, 0.95), Vec3(1.3, 0.2, 0.4), Vec3(-2.0, 1.0, 1.7)}) {
      const double dx = place_m.x - event.at.r_m.x, dy = place_m.y - event.at.r_m.y,
                   dz = place_m.z - event.at.r_m.z;
      const double expected_s = event.at.t_s + std::sqrt(dx * dx + dy * dy + dz * dz) / kC_m_s;
      EXPECT_NEAR(receptionAt(place_m, event.at, kC_m_s).t_s, expected_s, 4e-16 * expected_s);
    }
  }
}

// What is the same for everyone: the interval. And the frame in which a pair happens at once, or at one
// place, is the one that the table names.
TEST(EventTable, TheIntervalIsTheSameInEveryFrame) {
  std::mt19937_64 random(11);
  const auto in = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  for (int i = 0; i < 300; ++i) {
    const std::vector<GameEvent> events{flashAt({in(0, 4), {in(-1, 1), in(-1, 1), in(0, 1)}}, 0),
                                        flashAt({in(0, 4), {in(-1, 1), in(-1, 1), in(0, 1)}}, 1)};
    const Vec3 beta(in(-0.55, 0.55), in(-0.55, 0.55), in(-0.55, 0.55));
    SCOPED_TRACE(testing::Message() << "seed 11, case " << i);
    const std::vector<EventRow> rows = eventRows(events, kNobody, kNobody, beta, kC_m_s);
    const Displacement board = rows[1].event.at - rows[0].event.at, moving = rows[1].moving - rows[0].moving;
    EXPECT_NEAR(interval_m2(moving, kC_m_s), interval_m2(board, kC_m_s), 1e-10);
    const Relation& relation = *rows[0].toNext;
    ASSERT_TRUE(relation.beta);
    const std::vector<EventRow> there = eventRows(events, kNobody, kNobody, *relation.beta, kC_m_s);
    const Displacement d = there[1].moving - there[0].moving;
    const double own_m =
        relation.separation == Separation::timelike ? kC_m_s * std::abs(d.dt_s) : glm::length(d.dr_m);
    const double other_m =
        relation.separation == Separation::timelike ? glm::length(d.dr_m) : kC_m_s * d.dt_s;
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(*relation.beta, *relation.beta));
    EXPECT_NEAR(own_m, relation.length_m, 1e-13 * gamma * gamma * 10.0);
    EXPECT_NEAR(other_m, 0.0, 1e-13 * gamma * gamma * 10.0);
  }
}

// A head that walks straight at β: light that starts at (0, d ahead of it) meets it at t = d/(c (1 + β)), and
// the frame is the first at or after that.
TEST(EventTable, AWalkingHeadReceivesLightBetweenTwoFrames) {
  for (const double beta : {-0.8, -0.3, 0.0, 0.4, 0.95}) {
    const double gamma = 1.0 / std::sqrt(1.0 - beta * beta), step_s = 1.0 / 60.0;
    std::vector<HeadAt> head;
    for (int frame = 0; frame < 600; ++frame) {
      const double t_s = frame * step_s * gamma;
      head.push_back(
          {100u + static_cast<std::uint64_t>(frame), {t_s, {beta * kC_m_s * t_s, 0.0, 0.0}}, frame * step_s});
    }
    const double d_m = 2.0, expected_s = d_m / (kC_m_s * (1.0 + beta));
    const auto seen = receptionBy(head, {0.0, {d_m, 0.0, 0.0}}, kC_m_s);
    ASSERT_TRUE(seen) << beta;
    EXPECT_NEAR(seen->t_s, expected_s, 1e-13) << beta;
    EXPECT_NEAR(*seen->properTime_s, expected_s / gamma, 1e-13) << beta;
    EXPECT_EQ(*seen->frame, 100u + static_cast<std::uint64_t>(std::ceil(expected_s / gamma / step_s)))
        << beta;
    // Before the first frame and after the last nothing is known.
    EXPECT_FALSE(receptionBy(head, {-2.0, {0.0, 0.0, 0.0}}, kC_m_s));
    EXPECT_FALSE(receptionBy(head, {0.0, {1e3, 0.0, 0.0}}, kC_m_s));
  }
  EXPECT_FALSE(receptionBy({}, {0.0, {0.0, 0.0, 0.0}}, kC_m_s));
}

}  // namespace
}  // namespace carom
