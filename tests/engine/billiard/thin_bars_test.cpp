// Two thin bodies that meet fast: by the time at which light has told their centres, they are deep in each
// other or behind each other. They part on the side on which they met.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "engine/billiard/billiard.h"
#include "engine/corner_games.h"
#include "engine/light_speed.h"
#include "engine/sampled_body.h"

namespace carom {
namespace {

using test::bodyOf, test::kC_m_s, test::rectangle, test::SampledBody;

constexpr double kGameEnds_s = 4.0;

/// One body on all its legs, with c = 1.
class PlayedBody {
 public:
  PlayedBody(const Puck& puck, const WorldLine& line) {
    for (const Knot& knot : line.knots()) {
      const double gamma = std::sqrt(1.0 + glm::dot(knot.u, knot.u));
      const Vec21 start{knot.turn.t_s * kC_m_s, knot.turn.r_m.x, knot.turn.r_m.y};
      legs_.emplace_back(puck.outline_m, start, knot.u / gamma, knot.spin.omega_rad_s / kC_m_s, puck.radius_m,
                         knot.spin.angle_rad);
    }
  }
  const SampledBody& at(double t) const {
    std::size_t k = 0;
    while (k + 1 < legs_.size() && legs_[k + 1].start.t <= t) ++k;
    return legs_[k];
  }
  Vec21 centreAt(double t) const { return at(t).eventAt({0.0, 0.0}, test::boost({0.0, 0.0}), t); }

 private:
  std::vector<SampledBody> legs_;
};

/// The way of a point as it lies to a body: by which side it has come in, and whether it has gone out by one
/// that looks the other way, and not come back.
class SampledWay {
 public:
  void moveTo(const glm::dvec2& place, const std::vector<glm::dvec2>& corners) {
    if (started_) cross(place, corners);
    place_ = place, started_ = true;
  }
  bool isBehind() const { return behind_; }

 private:
  struct Crossing {
    double at;
    glm::dvec2 normal;
    bool in;
  };
  void cross(const glm::dvec2& to, const std::vector<glm::dvec2>& corners) {
    std::vector<Crossing> crossings;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const glm::dvec2 side = corners[(k + 1) % corners.size()] - corners[k];
      const glm::dvec2 normal = glm::dvec2{side.y, -side.x} / glm::length(side);
      const double before = glm::dot(normal, place_ - corners[k]), after = glm::dot(normal, to - corners[k]);
      if ((before > 0.0) == (after > 0.0)) continue;
      const double at = before / (before - after);
      const double along = glm::dot(place_ + (to - place_) * at - corners[k], side) / glm::dot(side, side);
      if (along >= 0.0 && along <= 1.0) crossings.push_back({at, normal, before > 0.0});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& one, const Crossing& other) { return one.at < other.at; });
    for (const Crossing& one : crossings) {
      if (one.in && !behind_) cameIn_ = one.normal;
      behind_ = !one.in && glm::dot(one.normal, cameIn_) < -1e-6;
    }
  }

  glm::dvec2 place_{0.0}, cameIn_{0.0};
  bool started_ = false, behind_ = false;
};

glm::dvec2 placeIn(const SampledBody& body, const Vec21& event) {
  const Vec21 x = body.restPlace(event);
  const double a = -body.angle - body.turning * x.t;
  return {x.x * std::cos(a) - x.y * std::sin(a), x.x * std::sin(a) + x.y * std::cos(a)};
}

/// Returns whether one of two centres has come through the other body, and has not come back in the end.
bool areThrough(const BilliardSetup& setup, const Billiard& game) {
  std::vector<PlayedBody> bodies;
  for (std::size_t i = 0; i < 2; ++i) bodies.emplace_back(setup.pucks[i], game.worldLines()[i]);
  std::array<SampledWay, 2> ways;
  for (double t = 0.0; t <= kGameEnds_s * kC_m_s; t += 5e-4)
    for (int i = 0; i < 2; ++i)
      ways[i].moveTo(placeIn(bodies[1 - i].at(t), bodies[i].centreAt(t)), setup.pucks[1 - i].outline_m);
  return ways[0].isBehind() || ways[1].isBehind();
}

/// From the first body to the second: the way in which the first contact has pushed the second.
Vec2 firstPush(const Billiard& game) {
  const auto celerity = [](const Vec2& beta) { return beta / std::sqrt(1.0 - glm::dot(beta, beta)); };
  const Turn& turn = game.events()[0].turns[1];
  return glm::normalize(celerity(turn.betaAfter) - celerity(turn.betaBefore));
}

BilliardSetup twoBars(Puck left, Puck right, double leftBeta, double rightBeta, double beside_m) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  left.position_m = {-0.5, 0.0}, left.beta = {leftBeta, 0.0};
  right.position_m = {0.5, beside_m}, right.beta = {rightBeta, 0.0};
  setup.pucks = {left, right};
  return setup;
}

struct Tally {
  int sentApart = 0;    // by their first contact
  int comeThrough = 0;  // of these
  std::size_t mostEvents = 0;
};

// Bodies of which the first contact drives the centres apart stay on their sides. Long after that the second
// is where it was pushed, or it has got there round the first one: bars that turn roll over each other's
// ends.
void play(const BilliardSetup& setup, Tally& tally) {
  Billiard game(setup);
  game.advanceTo(kGameEnds_s);
  tally.mostEvents = std::max(tally.mostEvents, game.events().size());
  if (game.events().empty()) return;
  const auto& turns = game.events()[0].turns;
  const Vec2 push = firstPush(game);
  if (!(glm::dot(turns[1].betaAfter - turns[0].betaAfter, push) > 0.05)) return;
  ++tally.sentApart;
  const auto place = [&](int i) { return game.worldLines()[i].at(kGameEnds_s).event.r_m; };
  const Vec2 apart{place(1).x - place(0).x, place(1).y - place(0).y};
  if (!(glm::dot(apart, push) > 0.0) && areThrough(setup, game)) ++tally.comeThrough;
}

TEST(ThinBars, ThatMeetFaceToFacePartAsTheyCame) {
  for (const double thick_m : {0.01, 0.03, 0.05}) {
    for (const double beta : {0.3, 0.6, 0.9, 0.99}) {
      for (const double beside_m : {0.0, 0.01, 0.02, 0.04}) {
        SCOPED_TRACE(testing::Message()
                     << thick_m << " m thick at " << beta << " c, " << beside_m << " m beside");
        const Puck bar = bodyOf("left", rectangle(thick_m, 0.12));
        Puck other = bar;
        other.name = "right";
        Tally tally;
        play(twoBars(bar, other, beta, -beta, beside_m), tally);
        EXPECT_EQ(tally.comeThrough, 0);
        EXPECT_LE(tally.mostEvents, 40u);
      }
    }
  }
}

// A few get through where spins carry their ends past each other before light has told the centres.
TEST(ThinBars, PartOnTheSideOnWhichTheyMet) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Tally tally;
  for (int n = 0; n < 300; ++n) {
    Puck left = bodyOf("left", rectangle(uniform(0.01, 0.05), uniform(0.03, 0.12)));
    Puck right = bodyOf("right", rectangle(uniform(0.01, 0.05), uniform(0.03, 0.12)));
    const double fast = uniform(0.0, 1.0) < 0.3 ? 0.99 : 0.9;
    if (n % 2 == 1) {
      for (Puck* puck : {&left, &right})
        puck->spin_kg_m2_s = spinOfRim_kg_m2_s(*puck, uniform(-0.9, 0.9), kC_m_s);
    }
    if (n % 3 == 2) right.mass_kg *= std::pow(10.0, uniform(-1.0, 1.0));
    const double leftBeta = uniform(0.05, fast), rightBeta = -uniform(0.0, fast);
    BilliardSetup setup = twoBars(left, right, leftBeta, rightBeta, uniform(-0.06, 0.06));
    if (n % 5 == 4) setup.rules.puckRestitution = uniform(0.0, 1.0);
    play(setup, tally);
  }
  EXPECT_GT(tally.sentApart, 150);
  EXPECT_LE(tally.comeThrough, tally.sentApart / 40);
}

}  // namespace
}  // namespace carom
