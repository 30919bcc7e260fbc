// The billiard against exact cases: first contact and outcome of two pucks, and of a puck and the cushions,
// from an oracle of 50 digits.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/billiard/billiard.h"
#include "exact_cases.h"

namespace carom {
namespace {

using Json = nlohmann::json;

Vec2 pair(const Json& json) { return {json[0].get<double>(), json[1].get<double>()}; }

// Written so that NaN fails.
#define EXPECT_WITHIN(value, expected, tolerance)            \
  EXPECT_TRUE(std::abs((value) - (expected)) <= (tolerance)) \
      << #value " = " << (value) << ", expected " << (expected)

void expectEvent(const Event& event, const Json& expected, double tolerance, const char* what) {
  SCOPED_TRACE(what);
  EXPECT_WITHIN(event.t_s, expected["t"].get<double>(), tolerance);
  EXPECT_WITHIN(event.r_m.x, expected["r"][0].get<double>(), tolerance);
  EXPECT_WITHIN(event.r_m.y, expected["r"][1].get<double>(), tolerance);
}

void expectVelocity(const Vec2& beta, double c, const Json& expected, double tolerance) {
  EXPECT_WITHIN(beta.x * c, expected[0].get<double>(), tolerance);
  EXPECT_WITHIN(beta.y * c, expected[1].get<double>(), tolerance);
}

BilliardSetup pairSetup(const Json& input, CollisionEvent convention) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = input["c"];
  setup.rules.collisionEvent = convention;
  for (const char* name : {"1", "2"}) {
    const Json& p = input["pucks"][setup.pucks.size()];
    setup.pucks.push_back({name, p["R"], 0.02, p["m"], pair(p["r"]), pair(p["v"]) / setup.lightSpeed_m_s});
  }
  return setup;
}

TEST(BilliardCases, twoPucks) {
  const Json all = test::exactCases("puck_collisions.json");
  for (const Json& one : all) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const double tolerance = one["tol_abs"];
    const Json& expected = one["expected"];
    for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
      const bool centre = convention == CollisionEvent::centre;
      SCOPED_TRACE(centre ? "centre" : "contact");
      const BilliardSetup setup = pairSetup(one["input"], convention);
      const double c = setup.lightSpeed_m_s;
      Billiard billiard(setup);
      if (expected["status"] != "hit") {
        billiard.advanceTo(1e6);
        EXPECT_EQ(billiard.events().size(), 0u);
        continue;
      }
      const double check_s = expected["t_check"];
      billiard.advanceTo(check_s);
      ASSERT_EQ(billiard.events().size(), 1u);
      const GameEvent& collision = billiard.events()[0];
      const Json& cov = expected["frames"]["cov"];
      expectEvent(collision.at, cov["contact"], tolerance, "contact");
      const Json& state = expected["state_at_t_check"][centre ? "delayed" : "contact"];
      for (std::size_t i = 0; i < 2; ++i) {
        SCOPED_TRACE(i);
        const Turn& turn = collision.turns[i];
        expectEvent(turn.event, cov[centre ? "centre_delayed" : "centre_contact"][i], tolerance, "turn");
        if (centre) {
          EXPECT_WITHIN(turn.properTime_s, cov["tau_delayed"][i].get<double>(), tolerance);
        }
        expectVelocity(turn.betaAfter, c, cov["v_after"][i], tolerance);
        const Vec3 at = billiard.worldLines()[i].at(check_s).event.r_m;
        EXPECT_WITHIN(at.x, state[i][0].get<double>(), tolerance);
        EXPECT_WITHIN(at.y, state[i][1].get<double>(), tolerance);
      }
    }
  }
}

TEST(BilliardCases, twoPucksWithRestitution) {
  const Json all = test::exactCases("puck_collisions.json");
  for (const Json& one : all) {
    if (one["expected"]["status"] != "hit") continue;
    SCOPED_TRACE(one["id"].get<std::string>());
    for (const Json& restitution : one["expected"]["restitution_cov"]) {
      BilliardSetup setup = pairSetup(one["input"], CollisionEvent::centre);
      setup.rules.puckRestitution = restitution["e"];
      Billiard billiard(setup);
      billiard.advanceTo(one["expected"]["t_check"]);
      ASSERT_GE(billiard.events().size(), 1u);
      for (std::size_t i = 0; i < 2; ++i) {
        expectVelocity(billiard.events()[0].turns[i].betaAfter, setup.lightSpeed_m_s,
                       restitution["impulse"]["v_after"][i], one["tol_abs"]);
      }
    }
  }
}

// The file's table is [0, Lx] × [0, Ly].
TEST(BilliardCases, cushions) {
  const Json all = test::exactCases("puck_cushion.json");
  const char* const walls[] = {"right", "left", "top", "bottom"};
  for (const Json& one : all) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const Json& input = one["input"];
    const double tolerance = one["tol_abs"];
    const Vec2 table = pair(input["table"]);
    for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
      const bool centre = convention == CollisionEvent::centre;
      for (const double e : {1.0, 0.8, 0.5, 0.0}) {
        BilliardSetup setup;
        setup.lightSpeed_m_s = input["c"];
        setup.board = Board{table.x, table.y};
        setup.rules.collisionEvent = convention;
        setup.rules.cushionRestitution = e;
        setup.pucks = {{"one", input["R"], 0.02, 1.0, pair(input["r"]) - 0.5 * table,
                        pair(input["v"]) / setup.lightSpeed_m_s}};
        Billiard billiard(setup);
        billiard.advanceTo(20.0);
        ASSERT_GE(billiard.events().size(), 1u);
        const GameEvent& collision = billiard.events()[0];
        const std::string wall = walls[static_cast<int>(*collision.cushion)];
        const Json& first = one["expected"]["first_wall"];
        EXPECT_EQ(wall, first[centre ? "puck/centre_delayed" : "board/centre_contact"].get<std::string>());
        const Json& expected = one["expected"]["walls"][wall];
        const Json& events = expected[centre ? "puck" : "board"];
        Event contact = collision.at, turn = collision.turns[0].event;
        for (Event* event : {&contact, &turn}) event->r_m += Vec3(0.5 * table.x, 0.5 * table.y, 0.0);
        expectEvent(contact, events["contact"], tolerance, "contact");
        expectEvent(turn, events[centre ? "centre_delayed" : "centre_contact"], tolerance, "turn");
        if (centre) {
          EXPECT_WITHIN(collision.turns[0].properTime_s, events["centre_delayed"]["tau"].get<double>(),
                        tolerance);
        }
        for (const Json& after : expected["v_after"]) {
          if (after["e"] != e) continue;
          expectVelocity(collision.turns[0].betaAfter, setup.lightSpeed_m_s, after["impulse"]["v"],
                         tolerance);
        }
      }
    }
  }
}

// A puck hits an equal one at rest with impact parameter b: angles from the incoming direction, and the
// velocities in the frame where it comes along x.
TEST(BilliardCases, scatter) {
  const Json all = test::exactCases("known_results.json");
  for (const Json& one : all) {
    if (one["kind"] != "scatter") continue;
    SCOPED_TRACE(one["id"].get<std::string>());
    const Json &input = one["input"], &expected = one["expected"];
    const double R = input["R"], tolerance = one["tol"];
    BilliardSetup setup;
    setup.lightSpeed_m_s = input["c"];
    setup.pucks = {{"1", R, 0.02, 1.0, {-5.0 * R, input["b_over_R"].get<double>() * R}, {input["beta"], 0.0}},
                   {"2", R, 0.02, 1.0, {0.0, 0.0}, {0.0, 0.0}}};
    Billiard billiard(setup);
    billiard.advanceTo(200.0);
    ASSERT_EQ(billiard.events().size(), 1u);
    const Vec2 v1 = billiard.events()[0].turns[0].betaAfter, v2 = billiard.events()[0].turns[1].betaAfter;
    expectVelocity(v1, setup.lightSpeed_m_s, expected["v1_after"], tolerance);
    expectVelocity(v2, setup.lightSpeed_m_s, expected["v2_after"], tolerance);
    EXPECT_WITHIN(std::atan2(std::abs(v1.y), v1.x), expected["theta1"].get<double>(), tolerance);
    EXPECT_WITHIN(std::atan2(std::abs(v2.y), v2.x), expected["theta2"].get<double>(), tolerance);
  }
}

}  // namespace
}  // namespace carom
