#include "app/files/scenario.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "app/files/toml_file.h"
#include "app/input_faults.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

using test::Fault;
using test::TemporaryFolder;

constexpr double kRounding = 1e-12;  // of metres and seconds of order one

Scenario read(const std::string& text) {
  const TemporaryFolder folder;
  return readScenario(folder.file("given.toml", text));
}

std::string numberText(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string puckText(const std::string& name, double radius_m, Vec2 position_m, Vec2 beta) {
  return "[[puck]]\nname = '" + name + "'\nradius_m = " + numberText(radius_m) +
         "\nmass_kg = 1\nposition_m = [" + numberText(position_m.x) + ", " + numberText(position_m.y) +
         "]\nbeta = [" + numberText(beta.x) + ", " + numberText(beta.y) + "]\n";
}

TEST(Scenario, ReadsTheThreePucks) {
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  EXPECT_EQ(scenario.title, "Three pucks");
  EXPECT_EQ(scenario.billiard.lightSpeed_m_s, 1.42);
  ASSERT_TRUE(scenario.billiard.board);
  EXPECT_EQ(scenario.billiard.board->length_m, 2.84);
  EXPECT_EQ(scenario.billiard.board->width_m, 1.42);
  ASSERT_EQ(scenario.billiard.pucks.size(), 3u);
  EXPECT_EQ(scenario.billiard.pucks[0].name, "white");
  EXPECT_EQ(scenario.billiard.pucks[0].beta, Vec2(0.8, 0.0));
  EXPECT_EQ(scenario.observer.position_m, Vec3(0.0, -1.6, -0.75));
  EXPECT_NEAR(scenario.observer.facing_rad, std::numbers::pi / 2, kRounding);
}

TEST(Scenario, ReadsTasksAndLamps) {
  const std::string pucks = puckText("white", 0.03, {0, 0}, {0, 0}) + puckText("red", 0.03, {0.3, 0}, {0, 0});
  const std::string task = "[[task]]\nname = 'a'\ntext = 'b'\nstars_j = [0.1, 0.2]\n";
  const Scenario scenario =
      read("light_speed_m_s = 1\n" + pucks + task +
           "goal = { hit-both = ['red', 'white'] }\nworld = 'measured'\n" +
           "[[lamp]]\nposition_m = [1, 2, 3]\non_s = 4\ncolour = [1, 0.5, 0]\npower = 2\n");
  ASSERT_EQ(scenario.tasks.size(), 1u);
  EXPECT_EQ(scenario.tasks[0].goal.kind, TaskGoal::Kind::hitBoth);
  EXPECT_EQ(scenario.tasks[0].goal.pucks, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(scenario.tasks[0].world, TaskWorld::measured);
  ASSERT_EQ(scenario.lamps.size(), 1u);
  EXPECT_EQ(scenario.lamps[0].light, glm::vec3(2.0F, 1.0F, 0.0F));
  const auto refused = [&](const std::string& rest) {
    EXPECT_THROW(read("light_speed_m_s = 1\n" + pucks + task + rest), InputErrors) << rest;
  };
  refused("");
  refused("goal = {}\n");
  refused("goal = { hit = 'blue' }\n");
  refused("goal = { hit-both = ['red'] }\n");
  refused("goal = { hit-both = ['red', 'red'] }\n");
  refused("goal = { hit = 'red', cushions = 2 }\n");
  refused("goal = { cushions = 0 }\n");
  refused("goal = { hit = 'red' }\nworld = 'flat'\n");
  refused("goal = { hit = 'red' }\n" + task + "goal = { hit = 'red' }\n");
}

// The wheel's mesh is painted in sectors, an even number, and its lesson offers two effects.
TEST(Scenario, ReadsTheSectorsOfAMeshAndTheEffectsOfALesson) {
  const std::string wheel = test::contentOf(CAROM_CONFIG_DIR "/scenarios/rolling-wheel.toml");
  const auto with = [&](const std::string& old, const std::string& other) {
    std::string text = wheel;
    text.replace(text.find(old), old.size(), other);
    return text;
  };
  const Scenario scenario = read(wheel);
  EXPECT_EQ(scenario.puckMeshes.at(0)->sectors, 8);
  EXPECT_EQ(scenario.lesson->plan.effects, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(read(with("sectors = 8", "")).puckMeshes.at(0)->sectors, 0);
  EXPECT_THROW(read(with("sectors = 8", "sectors = 7")), InputErrors);
  EXPECT_THROW(read(with("mesh = \"models/wheel.obj\"", "")), InputErrors);
  EXPECT_THROW(read(with("\"retardation\", \"contraction\"", "\"retardaton\"")), InputErrors);
}

TEST(Scenario, EveryShippedFileIsRight) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    SCOPED_TRACE(entry.path());
    EXPECT_NO_THROW(readScenario(entry.path()));
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST(Scenario, LeavesOutWhatIsOptional) {
  const Scenario scenario = read("light_speed_m_s = 2\n" + puckText("a", 1.0, {0, 0}, {0, 0}));
  EXPECT_FALSE(scenario.billiard.board);
  EXPECT_EQ(scenario.billiard.rules.puckRestitution, 1.0);
  EXPECT_EQ(scenario.billiard.rules.cushionRestitution, 1.0);
  EXPECT_EQ(scenario.billiard.rules.friction_m_s2, 0.0);
  EXPECT_EQ(scenario.billiard.rules.collisionEvent, CollisionEvent::centre);
  EXPECT_EQ(scenario.observer.position_m, Vec3(0.0, -1.6, -0.75));
  EXPECT_FALSE(scenario.puckMeshes.at(0));
}

TEST(Scenario, TakesFlashes) {
  const Scenario scenario = read(
      "light_speed_m_s = 2\n[[flash]]\nat_s = 3\nr_m = [0, -0.9, 0.3]\n"
      "[[flash]]\nname = 'lamp'\nat_s = 0\nr_m = [1, 2, 3]\n");
  const std::vector<Flash>& flashes = scenario.billiard.flashes;
  ASSERT_EQ(flashes.size(), 2u);
  EXPECT_EQ(flashes[0].name, "flash 1");
  EXPECT_EQ(flashes[0].at.t_s, 3.0);
  EXPECT_EQ(flashes[0].at.r_m, Vec3(0, -0.9, 0.3));
  EXPECT_EQ(flashes[1].name, "lamp");
}

TEST(Scenario, TakesStrokes) {
  const Scenario scenario =
      read("light_speed_m_s = 2\n" + puckText("a", 1.0, {0, 0}, {0, 0}) +
           "[[stroke]]\nat_s = 3\nfrom_m = [0, -0.9, 0.3]\npuck = 'a'\nmomentum_kg_m_s = [0.1, 0]\n");
  ASSERT_EQ(scenario.billiard.strokes.size(), 1u);
  EXPECT_EQ(scenario.billiard.strokes[0].puck, 0u);
  EXPECT_EQ(scenario.billiard.strokes[0].at_s, 3.0);
  EXPECT_EQ(scenario.billiard.strokes[0].from_m, Vec3(0, -0.9, 0.3));
  EXPECT_EQ(scenario.billiard.strokes[0].momentum_kg_m_s, Vec2(0.1, 0.0));
}

// A scripted body: where it was is compared with a walk along its legs from the told event in small steps.
class ScriptedBodyTest : public ::testing::TestWithParam<double> {
 protected:
  static constexpr double kC_m_s = 1.3;
  const std::vector<double> froms_s{-1e300, -2.0, 1.5, 3.0};
  const std::vector<Vec3> betas{{0.5, 0, 0}, {0, -0.7, 0.1}, {-0.3, 0.3, 0.3}, {0, 0, 0}};

  Vec3 betaAt(double t_s) const {
    std::size_t leg = 0;
    while (leg + 1 < betas.size() && froms_s[leg + 1] <= t_s) ++leg;
    return betas[leg];
  }
  /// Place change and proper time from a to b; no turn falls inside a step.
  std::pair<Vec3, double> walk(double a_s, double b_s) const {
    constexpr int kSteps = 1 << 14;
    const double h_s = (b_s - a_s) / kSteps;
    Vec3 way_m(0.0);
    double clock_s = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 beta = betaAt(a_s + (i + 0.5) * h_s);
      way_m += beta * (kC_m_s * h_s);
      clock_s += std::sqrt(1.0 - glm::dot(beta, beta)) * h_s;
    }
    return {way_m, clock_s};
  }
};

TEST_P(ScriptedBodyTest, PassesItsEventOnWhicheverLegHoldsIt) {
  const double at_s = GetParam();
  for (const bool appears : {false, true}) {
    const std::string text =
        "light_speed_m_s = 1.3\n[[body]]\nname = 'rod'\nat = { t_s = " + numberText(at_s) +
        ", r_m = [0.1, 0.2, 0.3] }\n" + (appears ? "appears_s = -1.0\n" : "") +
        "[[body.leg]]\nbeta = [0.5, 0, 0]\n[[body.leg]]\nfrom_s = -2\nbeta = [0, -0.7, 0.1]\n"
        "[[body.leg]]\nfrom_s = 1.5\nbeta = [-0.3, 0.3, 0.3]\n[[body.leg]]\nfrom_s = 3\nbeta = [0, 0, 0]\n";
    const WorldLine line = read(text).bodies.at(0).worldLine;
    ASSERT_EQ(line.knots().size(), 4u);
    const double kStepError = 8.0 / (1 << 14);  // a turn may fall inside one step of the walk
    for (const double t_s : {-4.0, -2.0, -0.5, 0.0, 1.5, 2.5, 4.0}) {
      const Motion motion = line.at(t_s);
      EXPECT_NEAR(glm::distance(motion.event.r_m, Vec3(0.1, 0.2, 0.3) + walk(at_s, t_s).first), 0.0,
                  kStepError)
          << t_s;
      EXPECT_NEAR(motion.properTime_s, walk(appears ? -1.0 : 0.0, t_s).second, kStepError) << t_s;
    }
    EXPECT_NEAR(glm::distance(line.at(at_s).event.r_m, Vec3(0.1, 0.2, 0.3)), 0.0, kRounding);
    for (std::size_t i = 1; i < 4; ++i) {
      EXPECT_EQ(line.knots()[i].turn.t_s, froms_s[i]);
      EXPECT_EQ(line.knots()[i].signal.t_s, froms_s[i]) << "the news starts at the centre's turn";
      EXPECT_EQ(line.knots()[i].signal.r_m, line.knots()[i].turn.r_m);
    }
    EXPECT_EQ(line.appears_s(), appears ? -1.0 : -std::numeric_limits<double>::infinity());
  }
}

INSTANTIATE_TEST_SUITE_P(OnEveryLeg, ScriptedBodyTest,
                         ::testing::Values(-3.5, -2.0, 0.7, 1.5, 2.0, 3.0, 5.0));

// Reference for overlapping ellipses: does a point of one's rim or its centre lie inside the other?
struct Ellipse {
  Vec2 centre_m, beta;
  double radius_m;
  double levelAt(Vec2 p_m) const {  // 1 on the rim
    const Vec2 d_m = p_m - centre_m;
    const double gamma2 = 1.0 / (1.0 - glm::dot(beta, beta));
    return std::sqrt(glm::dot(d_m, d_m) + gamma2 * glm::dot(d_m, beta) * glm::dot(d_m, beta)) / radius_m;
  }
  Vec2 rim(double angle) const {
    const Vec2 n(std::cos(angle), std::sin(angle));
    return centre_m + n / levelAt(centre_m + n);
  }
};

/// The least level of `b` on or inside `a`, below 1 where they overlap.
double leastLevel(const Ellipse& a, const Ellipse& b) {
  constexpr int kRimPoints = 20000;
  double least = a.levelAt(b.centre_m) < 1.0 ? 0.0 : b.levelAt(a.centre_m);
  for (int i = 0; i < kRimPoints; ++i) {
    least = std::min(least, b.levelAt(a.rim(2.0 * std::numbers::pi * i / kRimPoints)));
  }
  return least;
}

TEST(Scenario, RefusesExactlyThePucksThatOverlap) {
  std::mt19937_64 random(20240611);
  const auto in = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  int apart = 0, overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const auto beta = [&] {
      const double speed = 1.0 - std::pow(10.0, in(-4.0, 0.0)), angle = in(0.0, 2.0 * std::numbers::pi);
      return Vec2(speed * std::cos(angle), speed * std::sin(angle));
    };
    const Ellipse a{{in(-1, 1), in(-1, 1)}, beta(), in(0.2, 1.5)},
        b{{in(-1, 1), in(-1, 1)}, beta(), in(0.2, 1.5)};
    const double level = leastLevel(a, b);
    constexpr double kSampling = 0.01;  // the reference's own error: too near to call
    if (std::abs(level - 1.0) < kSampling) continue;
    const std::string text = "light_speed_m_s = 1\n" + puckText("a", a.radius_m, a.centre_m, a.beta) +
                             puckText("b", b.radius_m, b.centre_m, b.beta);
    if (level > 1.0) {
      EXPECT_NO_THROW(read(text)) << text;
      ++apart;
    } else {
      EXPECT_THROW(read(text), InputErrors) << text;
      ++overlapping;
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(overlapping, 50);
}

TEST(Scenario, PucksAndCushionsMayTouch) {
  EXPECT_NO_THROW(read("light_speed_m_s = 1\n[board]\nlength_m = 2\nwidth_m = 2\n" +
                       puckText("a", 0.3, {-0.3, 0.7}, {0, 0}) + puckText("b", 0.3, {0.3, 0.7}, {0, 0})));
  // Contracted to 60 % along its motion a puck fits where it would not at rest.
  EXPECT_NO_THROW(read("light_speed_m_s = 1\n[board]\nlength_m = 2\nwidth_m = 2\n" +
                       puckText("a", 0.5, {0.7, 0}, {0.8, 0})));
  EXPECT_THROW(read("light_speed_m_s = 1\n[board]\nlength_m = 2\nwidth_m = 2\n" +
                    puckText("a", 0.5, {0.71, 0}, {0.8, 0})),
               InputErrors);
}

class ScenarioFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(ScenarioFaults, ArePlacedAndExplained) { test::expectExplained(GetParam(), read); }

const std::string kHead = "light_speed_m_s = 1\n";
const std::string kPuck =
    "[[puck]]\nname = 'a'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, 0]\n";
const std::string kOther =
    "[[puck]]\nname = 'b'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0, 1]\nbeta = [0, 0]\n";

INSTANTIATE_TEST_SUITE_P(
    All, ScenarioFaults,
    ::testing::Values(
        Fault{"no light", "title = 'x'\n", 1, 1, "light_speed_m_s is missing"},
        Fault{"light stands still", "light_speed_m_s = 0\n", 1, 19, "above 0"},
        Fault{"light runs back", "light_speed_m_s = -1.42\n", 1, 19, "above 0"},
        Fault{"endless", "light_speed_m_s = inf\n", 1, 19, "is inf"},
        Fault{"junk after a number", "light_speed_m_s = 1\n[board]\nlength_m = 0/05\nwidth_m = 1\n", 3, 13,
              "expected digit"},
        Fault{"unknown table", kHead + "[bord]\nx = 1\n", 2, 2, "expected 'board'?"},
        Fault{"board without width", kHead + "[board]\nlength_m = 1\n", 2, 1, "width_m is missing"},
        Fault{"restitution", kHead + "[physics]\npuck_restitution = 1.5\n", 3, 20, "from 0 to 1"},
        Fault{"collision event", kHead + "[physics]\ncollision_event = \"center\"\n", 3, 19,
              "'centre' or 'contact'"},
        Fault{"friction", kHead + "[physics]\nfriction_m_s2 = 5\n" + kPuck, 3, 17, "expected below 5"},
        Fault{
            "faster than light",
            kHead +
                "[[puck]]\nname = 'a'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0.8, 0.6]\n",
            7, 8, "below light"},
        Fault{
            "text for a number",
            kHead + "[[puck]]\nname = 'a'\nradius_m = '1'\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, 0]\n",
            4, 12, "is a text"},
        Fault{"same name",
              kHead + kPuck +
                  "[[body]]\nname = 'a'\nat = { t_s = 0, r_m = [0, 0, 0] }\n[[body.leg]]\nbeta = [0, 0, 0]\n",
              9, 8, "taken in line 3"},
        Fault{"overlap",
              kHead + kPuck +
                  "[[puck]]\nname = 'b'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0.1, 0]\nbeta = [0, 0]\n",
              12, 14, "overlaps puck 'a'"},
        Fault{"off the table", kHead + "[board]\nlength_m = 1\nwidth_m = 1\n" + kOther, 9, 14,
              "over the y cushion"},
        Fault{"mesh",
              kHead + "[[puck]]\nname = 'a'\nradius_m = 1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, "
                      "0]\nmesh = 'no.obj'\n",
              8, 8, "no.obj"},
        Fault{"empty mesh",
              kHead + "[[puck]]\nname = 'a'\nradius_m = 1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, "
                      "0]\nmesh = ''\n",
              8, 8, "empty"},
        Fault{"stroke of nobody",
              kHead + kPuck + "[[stroke]]\nat_s = 1\npuck = 'c'\nmomentum_kg_m_s = [1, 0]\n", 10, 8,
              "no puck 'c'"},
        Fault{"stroke before the game",
              kHead + kPuck + "[[stroke]]\nat_s = -1\npuck = 'a'\nmomentum_kg_m_s = [1, 0]\n", 9, 8,
              "from 0"},
        Fault{"flash before the game", kHead + "[[flash]]\nat_s = -1\nr_m = [0, 0, 0]\n", 3, 8, "from 0"},
        Fault{"flash nowhere", kHead + "[[flash]]\nat_s = 1\n", 2, 1, "r_m is missing"},
        Fault{"flash of a puck's name", kHead + kPuck + "[[flash]]\nname = 'a'\nat_s = 1\nr_m = [0, 0, 0]\n",
              9, 8, "is taken"},
        Fault{"no legs", kHead + "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\n", 2, 1,
              "[[body.leg]]"},
        Fault{"empty legs", kHead + "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\nleg = []\n", 5,
              7, "[[body.leg]]"},
        Fault{"no event", kHead + "[[body]]\nname = 'r'\n[[body.leg]]\nbeta = [0, 0, 0]\n", 2, 1,
              "at is missing"},
        Fault{"legs out of order",
              kHead +
                  "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\n[[body.leg]]\nbeta = [0, 0, 0]\n"
                  "[[body.leg]]\nfrom_s = 2\nbeta = [0, 0, 0]\n[[body.leg]]\nfrom_s = 2\nbeta = [0, 0, 0]\n",
              11, 10, "after the leg before it"},
        Fault{"first leg from",
              kHead + "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\n[[body.leg]]\nfrom_s = "
                      "2\nbeta = [0, 0, 0]\n",
              6, 10, "first leg"},
        Fault{"friction below 0", kHead + "[physics]\npuck_friction = -1\n", 3, 17, "from 0"},
        Fault{"friction of no number", kHead + "[physics]\ncushion_friction = nan\n", 3, 20, "is nan"},
        Fault{"tangential restitution", kHead + "[physics]\ntangential_restitution = 2\n", 3, 26,
              "from 0 to 1"},
        Fault{"endless spin deceleration", kHead + "[physics]\nspin_deceleration_m_s2 = inf\n", 3, 26,
              "is inf"},
        Fault{"rim faster than light", kHead + kPuck + "spin_rad_s = -12\n", 8, 14,
              "the rim would move at 1.2 c, expected less than 10 rad/s"},
        Fault{"rim at light speed", kHead + kPuck + "spin_rad_s = 10\n", 8, 14, "at 1 c"},
        Fault{"too much spin", kHead + kPuck + "spin_kg_m2_s = 1e8\n", 8, 16, "as fast as light"},
        Fault{"spin said twice", kHead + kPuck + "spin_rad_s = 1\nspin_kg_m2_s = 0.1\n", 9, 16,
              "one of them"},
        Fault{"inertia of nothing", kHead + kPuck + "inertia = 0\n", 8, 11, "above 0"},
        Fault{"inertia too small for numbers", kHead + kPuck + "inertia = 1e-12\n", 8, 11, "at least 1e-06"},
        Fault{"inertia above a hoop's", kHead + kPuck + "inertia = 1.5\n", 8, 11, "to 1"},
        Fault{"stroke beside the puck",
              kHead + kPuck + "[[stroke]]\nat_s = 1\npuck = 'a'\nmomentum_kg_m_s = [1, 0]\noffset_m = 0.11\n",
              12, 12, "beside puck 'a', expected at most its radius, 0.1 m"},
        Fault{"observer at light speed", kHead + "[observer]\nbeta = [1, 0, 0]\n", 3, 8, "below light"}),
    [](const auto& tested) {
      std::string name = tested.param.what;
      std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
      return name;
    });

}  // namespace
}  // namespace carom
