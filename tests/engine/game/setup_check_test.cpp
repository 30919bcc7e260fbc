#include "engine/game/setup_check.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

BilliardSetup soundSetup() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{2.0, 1.0};
  setup.pucks = {{"one", 0.05, 0.02, 0.2, {-0.5, 0.0}, {0.6, 0.0}},
                 {"two", 0.05, 0.02, 0.2, {0.5, 0.0}, {0.0, 0.0}}};
  setup.strokes = {{1, 0.5, Vec3(0.0, 0.0, 0.3), {0.1, 0.0}}};
  setup.flashes = {{"lamp", {1.0, {0.0, 0.0, 0.5}}}};
  return setup;
}

/// What the check says; empty if it says nothing.
std::string wordsOn(const BilliardSetup& setup) {
  try {
    checkSetup(setup);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(SetupCheck, SaysWhatCannotBePlayed) {
  using Change = std::function<void(BilliardSetup&)>;
  const struct {
    const char* says;  // empty: it can be played
    Change change;
  } kCases[] = {
      {"", [](BilliardSetup&) {}},
      {"", [](BilliardSetup& s) { s.board.reset(); }},
      {"", [](BilliardSetup& s) { s.pucks.clear(), s.strokes.clear(); }},
      {"light speed 0", [](BilliardSetup& s) { s.lightSpeed_m_s = 0.0; }},
      {"light speed nan", [](BilliardSetup& s) { s.lightSpeed_m_s = kNaN; }},
      {"light speed inf", [](BilliardSetup& s) { s.lightSpeed_m_s = kInfinity; }},
      {"board of -2 m", [](BilliardSetup& s) { s.board->length_m = -2.0; }},
      {"board of 2 m by 0 m", [](BilliardSetup& s) { s.board->width_m = 0.0; }},
      {"", [](BilliardSetup& s) { s.rules.puckRestitution = 0.0; }},
      {"restitution 1.5", [](BilliardSetup& s) { s.rules.puckRestitution = 1.5; }},
      {"restitution -1", [](BilliardSetup& s) { s.rules.cushionRestitution = -1.0; }},
      {"friction -1", [](BilliardSetup& s) { s.rules.friction_m_s2 = -1.0; }},
      {"friction nan", [](BilliardSetup& s) { s.rules.friction_m_s2 = kNaN; }},
      {"", [](BilliardSetup& s) { s.rules.friction_m_s2 = 20.0; }},
      {"its rim would outrun light", [](BilliardSetup& s) { s.rules.friction_m_s2 = 21.0; }},
      {"puck \"two\": radius 0", [](BilliardSetup& s) { s.pucks[1].radius_m = 0.0; }},
      {"puck \"two\": height -1", [](BilliardSetup& s) { s.pucks[1].height_m = -1.0; }},
      {"puck \"two\": mass nan", [](BilliardSetup& s) { s.pucks[1].mass_kg = kNaN; }},
      {"puck \"one\": position", [](BilliardSetup& s) { s.pucks[0].position_m.y = kInfinity; }},
      {"",
       [](BilliardSetup& s) {
         s.pucks[0].beta = {0.0, 0.99999};
       }},
      {"expected less than 1",
       [](BilliardSetup& s) {
         s.pucks[0].beta = {0.6, 0.8};
       }},
      {"puck \"one\": beta", [](BilliardSetup& s) { s.pucks[0].beta.x = kNaN; }},
      {"two pucks are named \"one\"", [](BilliardSetup& s) { s.pucks[1].name = "one"; }},
      {"the +x cushion", [](BilliardSetup& s) { s.pucks[1].position_m.x = 0.96; }},
      {"the -y cushion", [](BilliardSetup& s) { s.pucks[1].position_m.y = -0.96; }},
      {"",
       [](BilliardSetup& s) { s.pucks[0].position_m.x = -0.959; }},  // contracted: R sqrt(1 − 0.36) = 0.04
      {"the -x cushion", [](BilliardSetup& s) { s.pucks[0].position_m.x = -0.961; }},
      {"overlap at t = 0", [](BilliardSetup& s) { s.pucks[1].position_m.x = -0.411; }},
      {"", [](BilliardSetup& s) { s.pucks[1].position_m.x = -0.409; }},  // 0.04 + 0.05 apart
      {"stroke 0: there is no puck 7 among 2", [](BilliardSetup& s) { s.strokes[0].puck = 7; }},
      {"stroke 0 on puck \"two\": at -1 s", [](BilliardSetup& s) { s.strokes[0].at_s = -1.0; }},
      {"stroke 0 on puck \"two\": expected numbers", [](BilliardSetup& s) { s.strokes[0].from_m->z = kNaN; }},
      {"stroke 0 on puck \"two\": expected numbers",
       [](BilliardSetup& s) { s.strokes[0].momentum_kg_m_s.x = kInfinity; }},
      {"flash \"lamp\": expected numbers", [](BilliardSetup& s) { s.flashes[0].at.r_m.y = kNaN; }},
  };
  for (const auto& [says, change] : kCases) {
    BilliardSetup setup = soundSetup();
    change(setup);
    const std::string words = wordsOn(setup);
    EXPECT_TRUE(*says == '\0' ? words.empty() : words.find(says) != std::string::npos)
        << "expected \"" << says << "\", got \"" << words << '"';
  }
}

// By going round the one's contracted rim and asking of each point whether it lies in the other.
TEST(SetupCheck, DiscsOverlapWhereAPointLiesInBoth) {
  test::Random random(3);
  int apart = 0, overlapping = 0;
  const auto isIn = [](const Puck& puck, const Vec2& point) {
    const Vec2 d = point - puck.position_m;
    const double gamma2 = 1.0 / (1.0 - glm::dot(puck.beta, puck.beta)), along = glm::dot(puck.beta, d);
    return glm::dot(d, d) + gamma2 * along * along < puck.radius_m * puck.radius_m;  // in its rest frame
  };
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const auto puck = [&] {
      const double beta = random.in(0.0, 0.95), angle = random.in(0.0, 6.3);
      return Puck{"",
                  random.in(0.02, 0.1),
                  0.02,
                  0.2,
                  {random.in(-0.1, 0.1), random.in(-0.1, 0.1)},
                  {beta * std::cos(angle), beta * std::sin(angle)}};
    };
    const Puck a = puck(), b = puck();
    // The rim and what is inside it, as rings.
    bool touches = false, touchesLarger = false;
    for (int ring = 0; ring <= 40; ++ring) {
      for (int step = 0; step < 400; ++step) {
        const double angle = 2.0 * std::numbers::pi * step / 400.0, radius = a.radius_m * ring / 40.0;
        const Vec2 rest{radius * std::cos(angle), radius * std::sin(angle)};
        const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(a.beta, a.beta));
        const Vec2 d = rest - a.beta * (glm::dot(a.beta, rest) * gamma / (gamma + 1.0));
        touches = touches || isIn(b, a.position_m + d);
        Puck larger = b;
        larger.radius_m += 0.05 * (a.radius_m + b.radius_m);
        touchesLarger = touchesLarger || isIn(larger, a.position_m + d);
      }
    }
    if (touches != touchesLarger) continue;  // too near to say
    ++(touches ? overlapping : apart);
    EXPECT_EQ(overlapOnBoard(a, b, 1.42), touches);
    EXPECT_EQ(overlapOnBoard(b, a, 1.42), touches);
  }
  EXPECT_TRUE(apart > 30 && overlapping > 30) << apart << " apart, " << overlapping << " overlapping";
}

}  // namespace
}  // namespace carom
