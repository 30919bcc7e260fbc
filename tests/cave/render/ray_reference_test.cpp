// Walls as they are drawn against rays traced backwards and meshes solved by halving
// (reference/ray_reference.h): every body's silhouette at 1920 × 1920, to a pixel.
#include "reference/ray_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "app/scenario/scenario.h"
#include "cave/scene/scene_builder.h"
#include "cave/silhouettes.h"
#include "engine/light/mesh_emission.h"
#include "places.h"

namespace carom {
namespace {

using namespace test;

// ---- shipped scenarios ----------------------------------------------------------------------------------

/// A scenario being played, and the few bodies of it that are looked at.
struct Game {
  Scenario scenario;
  std::vector<WorldLine> lines;       // of all bodies, in the scene's order
  std::vector<ReferenceBody> bodies;  // the target first
  Scene scene;                        // of these alone, each with its number
  Scene fineScene;                    // the same, its pucks with the reference's mesh
};

/// The pucks of the first collisions, the one that turns first before all others; without collisions, the
/// first pucks.
std::vector<std::size_t> interestingPucks(const Scenario& scenario, const Billiard& billiard) {
  constexpr std::size_t kMost = 4;
  std::vector<std::size_t> pucks;
  const auto add = [&](std::size_t puck) {
    if (pucks.size() < kMost && std::find(pucks.begin(), pucks.end(), puck) == pucks.end())
      pucks.push_back(puck);
  };
  for (const GameEvent& collision : billiard.events()) {
    for (const Turn& turn : collision.turns) add(turn.puck);
  }
  for (std::size_t i = 0; i < scenario.billiard.pucks.size(); ++i) add(i);
  return pucks;
}

Game play(const std::filesystem::path& file) {
  Game game{readScenario(file), {}, {}, {}, {}};
  const BilliardSetup& setup = game.scenario.billiard;
  constexpr double kUntil_s = 8.0;
  Billiard billiard(setup);
  billiard.advanceTo(kUntil_s);
  game.lines.assign(billiard.worldLines().begin(), billiard.worldLines().end());
  for (const ScriptedBody& body : game.scenario.bodies) game.lines.push_back(body.worldLine);

  const auto pathOf = [](const auto& mesh) { return mesh ? mesh->string() : std::string(); };
  std::vector<BodyLooks> pucks, told;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const auto& mesh = game.scenario.puckMeshes[i];
    pucks.push_back({setup.pucks[i].name, mesh ? mesh->file.string() : "", setup.pucks[i].radius_m,
                     setup.pucks[i].height_m, setup.pucks[i].outline_m, mesh ? mesh->place : std::nullopt});
  }
  for (const ScriptedBody& body : game.scenario.bodies)
    told.push_back({body.name, pathOf(body.mesh), 0.0, 0.0, {}, {}});
  const Scene whole = buildScene(setup, pucks, told);
  game.scene.bodyCount = whole.bodyCount;
  game.fineScene.bodyCount = whole.bodyCount;

  const auto partOf = [&](std::size_t body) {
    return std::find_if(
               whole.parts.begin(), whole.parts.end(),
               [&](const ScenePart& part) { return part.body == body && part.paint != Paint::shadow; })
        ->mesh;
  };
  std::vector<std::size_t> chosen = interestingPucks(game.scenario, billiard);
  for (std::size_t i = 0; i < told.size() && i < 2; ++i) {
    if (!std::isfinite(game.scenario.bodies[i].worldLine.appears_s())) chosen.push_back(pucks.size() + i);
  }
  for (const std::size_t i : chosen) {
    const int number = static_cast<int>(game.bodies.size()) + 1;
    const bool builtIn = i < pucks.size() && pucks[i].meshPath.empty();
    const bool isDisc = builtIn && pucks[i].outline_m.empty();
    game.bodies.push_back(isDisc ? puckBody(number, game.lines[i], pucks[i].radius_m, pucks[i].height_m)
                                 : meshBody(number, game.lines[i], *partOf(i + 1)));
    test::addNumbered(game.scene, whole, i + 1, number);
    test::addNumbered(game.fineScene, whole, i + 1, number);
    if (builtIn) game.fineScene.parts.back().mesh = test::polyData(game.bodies.back().fine);
  }
  return game;
}

/// Whether the game has so many corners that to trace them all takes minutes: games of bodies with corners
/// are traced in CornerReference.
bool hasManyCorners(const Scenario& scenario) {
  constexpr std::size_t kMost = 16;
  std::size_t corners = 0;
  for (const Puck& puck : scenario.billiard.pucks) corners += puck.outline_m.size();
  return corners > kMost;
}

/// Whether the game has soft pucks, which take minutes to play and are seen by their rows (SeenRows,
/// SoftPictures).
bool isSoft(const Scenario& scenario) {
  return std::any_of(scenario.billiard.pucks.begin(), scenario.billiard.pucks.end(),
                     [](const Puck& puck) { return puck.soft.has_value(); });
}

/// Times of the target (c t) to look at: before its first bounce, during it, after it; or one if there is
/// none.
std::vector<double> interestingTimes(const ReferenceBody& target, const Vec3& fromTarget_m, double c_m_s) {
  if (target.legs.size() == 1) return {c_m_s * 1.0};
  const double turn = target.legs[1].turn.t, step = 0.02;
  const auto legAt = [&](double t) {
    const reference::Eye eye = lookAt(target, t, fromTarget_m, Vec3(0.0), c_m_s).eye(c_m_s);
    return reference::commonLeg(test::knownTo(eye, target.legs), target.rim, eye);
  };
  double before = turn - step, after = turn + step;
  for (int i = 0; i < 200 && legAt(before) != 0; ++i) before -= step;
  for (int i = 0; i < 200 && legAt(after).value_or(0) == 0; ++i) after += step;
  std::vector<double> turning;
  for (double t = before; t < after; t += 0.2 * step) {
    if (!legAt(t)) turning.push_back(t);
  }
  const double during = turning.empty() ? turn : turning[turning.size() / 2];
  return {before, during, after};
}

/// How much further than half a metre to stand from a body: round ones are divided for eyes outside them.
double distanceFor(const ReferenceBody& target) {
  double reach_m = 0.0;
  for (const Vec3& d : target.rim) reach_m = std::max(reach_m, glm::length(d));
  return target.shape ? std::max(1.0, reach_m / 0.15) : 1.0;
}

class RayReference : public testing::Test {
 protected:
  Graphics graphics_;
};

TEST_F(RayReference, SilhouettesOfEveryShippedScenario) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  }
  EXPECT_GE(files.size(), 2U);
  Comparison all, allFine;
  for (const std::filesystem::path& file : files) {
    if (hasManyCorners(readScenario(file)) || isSoft(readScenario(file))) continue;
    const Game game = play(file);
    if (game.bodies.empty()) continue;
    const double c_m_s = game.scenario.billiard.lightSpeed_m_s;
    const Vec3 fromTarget_m = distanceFor(game.bodies.front()) * Vec3(0.12, -0.45, 0.3);
    WallRenderer renderer(graphics_, game.scene, c_m_s, 1);
    WallRenderer fineRenderer(graphics_, game.fineScene, c_m_s, 1);
    Comparison of;
    for (const double t : interestingTimes(game.bodies.front(), fromTarget_m, c_m_s)) {
      for (const Vec3& beta : {Vec3(0.0), 0.7 * glm::normalize(Vec3(0.8, 0.6, 0.1)),
                               0.95 * glm::normalize(fromTarget_m + Vec3(0.1, 0.0, 0.0))}) {
        SCOPED_TRACE(testing::Message() << file.filename() << ", target as at " << t / c_m_s
                                        << " s, observer at " << glm::length(beta) << " c");
        const test::Look look = lookAt(game.bodies.front(), t, fromTarget_m, beta, c_m_s);
        const Wall wall = wallTowards(look, game.bodies.front(), c_m_s);
        const auto views = viewsOn(wall, game.bodies, look, c_m_s);
        if (views.empty()) continue;
        const Comparison picture = compare(test::drawn(graphics_, renderer, game.lines, look, wall), views);
        EXPECT_GT(picture.lit, 0);
        EXPECT_LT(picture.worst_px, kSilhouette_px);
        EXPECT_LT(picture.turningShare, kFacetShare);
        of.add(picture);
        if (picture.turningBodies == 0) continue;
        const Comparison fine = compare(test::drawn(graphics_, fineRenderer, game.lines, look, wall), views);
        EXPECT_LT(std::max(fine.worst_px, fine.worstTurning_px), kSilhouette_px) << "drawn finely";
        allFine.add(fine);
      }
    }
    of.print(file.filename().c_str());
    EXPECT_GE(of.bodies, 1) << file;
    all.add(of);
  }
  all.print("all scenarios");
  allFine.print("those with a body in the middle of a bounce, drawn finely");
  EXPECT_GT(all.tracedBodies, 10);
  EXPECT_GE(all.turningBodies, 3);
}

// ---- random flights -------------------------------------------------------------------------------------

Flyer plainPuck(const WorldLine& line, double radius_m, double height_m, Drawn drawn) {
  Scene plain;
  plain.parts = puckParts(radius_m, height_m, 1, glm::vec3(1.0F));
  if (drawn == Drawn::fine)
    plain.parts.back().mesh = test::polyData(reference::puckMesh(radius_m, height_m, 4));
  Flyer flyer{{puckBody(1, line, radius_m, height_m)}, {}};
  flyer.scene.bodyCount = 2;
  test::addNumbered(flyer.scene, plain, 1, 1);
  return flyer;
}

TEST_F(RayReference, StraightFlightsUpTo99HundredthsOfLight) {
  const auto line = [](test::Random& random, double radius_m) {
    const std::array<double, 3> speeds{0.6, 0.9, 0.99};
    const double speed = speeds[static_cast<std::size_t>(random.in(0.0, 3.0))];
    const Knot knot{{0.0, random.inBox(0.5)}, uFromBeta(random.direction() * speed), 0.0, {}, 0.0};
    return WorldLine(knot, kC_m_s, radius_m);
  };
  const auto flyer = [](const WorldLine& straight, double radius_m, double height_m) {
    return plainPuck(straight, radius_m, height_m, Drawn::builtIn);
  };
  const Comparison all = compareRandom(graphics_, 61, 30, line, flyer,
                                       [](const ReferenceBody&, const reference::Eye&) { return true; });
  all.print("straight flights");
  EXPECT_EQ(all.tracedBodies, 30);
}

TEST_F(RayReference, BodiesInTheMiddleOfABounceUpToNineTenthsOfLight) {
  const auto line = [](test::Random& random, double radius_m) {
    return randomWorldLine(random, kC_m_s, radius_m, 1 + static_cast<int>(random.in(0.0, 3.0)), 0.3, 0.9);
  };
  const auto flyer = [](const WorldLine& bouncing, double radius_m, double height_m) {
    return plainPuck(bouncing, radius_m, height_m, Drawn::fine);
  };
  const Comparison all = compareRandom(graphics_, 62, 18, line, flyer, inABounce);
  all.print("in the middle of a bounce");
  EXPECT_EQ(all.turningBodies, 18);
}

// ---- random spins ---------------------------------------------------------------------------------------

constexpr int kWidestSpinning_px = 300;

/// The fastest that a rim goes on any leg, over c.
double fastestRim(const WorldLine& line) {
  double rim = 0.0;
  for (const Knot& knot : line.knots())
    rim = std::max(rim, std::abs(knot.spin.omega_rad_s) * line.radius_m() / line.lightSpeed_m_s());
  return rim;
}

/// The number of chords, twelve times a power of two, that show a circle that turns at f to 0.3 pixels. From
/// the side, what is seen at E has turned by M = E − f sin E (Kepler): where the rim approaches, a chord of
/// 2M there goes over 2E, and leaves the circle by 1 − cos E of the radius.
std::size_t chordsFor(double f) {
  const double E = std::sqrt(2.0 * 0.3 / (0.5 * kWidestSpinning_px));
  std::size_t chords = 12;
  while (static_cast<double>(chords) < std::numbers::pi / (E - f * std::sin(E))) chords *= 2;
  return chords;
}

/// The built-in puck in as many chords around as a rim at f needs at each radius, and in rings that follow
/// bent spokes.
reference::Mesh spinningPuckMesh(double radius_m, double height_m, double f) {
  const auto profile = reference::puckProfile(radius_m, height_m, {32, 1, 4, 1, 32});
  std::vector<std::size_t> around;
  for (const auto& place : profile) around.push_back(chordsFor(f * place[0] / radius_m));
  return reference::turnedMesh(profile, around);
}

/// A puck with marked sectors: 1, the others are 2.
Flyer markedPuck(const WorldLine& line, double radius_m, double height_m) {
  const reference::Mesh mesh = spinningPuckMesh(radius_m, height_m, fastestRim(line));
  Flyer flyer;
  flyer.scene.bodyCount = 2;
  for (const bool marked : {true, false}) {
    const int number = marked ? 1 : 2;
    ReferenceBody body = puckBody(number, line, radius_m, height_m);
    body.fine = reference::marksOf(mesh, marked);
    body.marked = marked;
    Scene part;
    part.parts.push_back({1, test::polyData(body.fine), Paint::lamp, glm::vec3(1.0F), 0.0F});
    test::addNumbered(flyer.scene, part, 1, number);
    flyer.bodies.push_back(std::move(body));
  }
  return flyer;
}

/// Rims at 0.6, 0.9 and 0.99 c in turn, either way round, on every leg; centres at up to 0.9 c.
struct SpinningFlights {
  int bounces = 0;
  double slowing_1_s = 0.0;
  int made = 0;
  WorldLine operator()(test::Random& random, double radius_m) {
    const std::array<double, 3> rims{0.6, 0.9, 0.99};
    const double rim = rims[static_cast<std::size_t>(made++ % 3)];
    return test::spun(random, randomWorldLine(random, kC_m_s, radius_m, bounces, 0.3, 0.9), rim, slowing_1_s,
                      rim);
  }
};

TEST_F(RayReference, SpinningPucksBeforeAndAfterBounces) {
  const auto settled = [](const ReferenceBody& body, const reference::Eye& eye) {
    return !inABounce(body, eye);
  };
  for (const double slowing_1_s : {0.0, 1.5}) {
    const Comparison all = compareRandom(graphics_, 65, 9, SpinningFlights{1, slowing_1_s}, markedPuck,
                                         settled, kWidestSpinning_px);
    all.print("spinning, before and after bounces");
    EXPECT_EQ(all.tracedBodies, 18);
  }
}

TEST_F(RayReference, SpinningPucksInTheMiddleOfABounce) {
  const Comparison all =
      compareRandom(graphics_, 66, 9, SpinningFlights{2}, markedPuck, inABounce, kWidestSpinning_px);
  all.print("spinning, in the middle of a bounce");
  EXPECT_EQ(all.turningBodies, 18);
}

// The two ways of the reference share no step: rays in the body's rest frame, halving on the board.
TEST(RayReferenceItself, RaysAndHalvingAgree) {
  test::Random random(63);
  double worst_px = 0.0;
  int covered = 0;
  for (int i = 0; i < 18; ++i) {
    const double radius_m = random.in(0.05, 0.15);
    WorldLine line = randomWorldLine(random, kC_m_s, radius_m, i % 3, 1.5, 0.9);
    if (i >= 12) line = test::spun(random, line, 0.9, i % 2 == 0 ? 0.0 : 0.5);
    ReferenceBody body = puckBody(1, line, radius_m, radius_m);
    if (i >= 12) body.marked = true;
    const test::Look look =
        lookAt(body, kC_m_s * (line.knots().back().turn.t_s + 1.0), random.direction() * random.in(0.5, 1.0),
               random.direction() * 0.7, kC_m_s);
    const reference::Screen screen = test::screenOf(wallTowards(look, body, kC_m_s), look.inRoom_m);
    const ReferenceView view(body, look.eye(kC_m_s), screen);
    if (!view.traced() || view.behind()) continue;
    const auto legs = test::knownTo(look.eye(kC_m_s), body.legs);
    const reference::SeenMesh mesh(legs, body.marked ? reference::marksOf(body.fine, true) : body.fine,
                                   look.eye(kC_m_s), screen);
    std::optional<reference::SeenMesh> others;
    if (body.marked) others.emplace(legs, reference::marksOf(body.fine, false), look.eye(kC_m_s), screen);
    const auto halvedAt = [&](double x, double y) {
      const auto here = mesh.depthAt(x, y), other = others ? others->depthAt(x, y) : std::nullopt;
      return other && here && *other < *here ? std::nullopt : here;
    };
    const auto [left, right, bottom, top] = view.box();
    for (int k = 0; k < 2000; ++k) {
      const double x = random.in(left, right), y = random.in(bottom, top);
      const auto ray = view.tracedDepth(x, y), halved = halvedAt(x, y);
      if (ray.has_value() != halved.has_value()) {
        const auto agrees = [&](double px, double py) {
          return halvedAt(px, py).has_value() == ray.has_value();
        };
        worst_px = std::max(worst_px, distanceTo_px(agrees, x, y));
      } else if (ray) {
        ++covered;
        // 288 flat sectors: the sagitta R (1 − cos(π/288)), as a share of the distance, seen at a slant.
        ASSERT_NEAR(*ray / *halved, 1.0, 3e-3) << "case " << i << " at " << x << " " << y;
      }
    }
  }
  std::printf("rays and halving: outlines within %.2f px, %d depths compared\n", worst_px, covered);
  EXPECT_LT(worst_px, 0.3);
  EXPECT_GT(covered, 3000);
}

// Where the solve in float puts the very vertices that are drawn, against halving of their world lines.
TEST(RayReferenceItself, VerticesInTheMiddleOfABounce) {
  test::Random random(64);
  double worst_px = 0.0;
  long vertices = 0, catchingUp = 0, outOfTurn = 0;
  for (int i = 0; i < 120; ++i) {
    const double radius_m = random.in(0.03, 0.15);
    WorldLine line =
        randomWorldLine(random, kC_m_s, radius_m, 1 + static_cast<int>(random.in(0.0, 4.0)), 0.2, 0.9);
    if (i >= 60) line = test::spun(random, line, 0.99, i % 2 == 0 ? 0.0 : 1.5);
    const reference::Mesh mesh =
        test::referenceMesh(*puckParts(radius_m, radius_m, 1, glm::vec3(1.0F)).back().mesh);
    std::vector<float> x, y, z;
    for (const Vec3& p : mesh.points) {
      x.push_back(static_cast<float>(p.x)), y.push_back(static_cast<float>(p.y)),
          z.push_back(static_cast<float>(p.z));
    }
    const ReferenceBody body{1, test::referenceLegs(line), {}, {}, {}};
    const test::Look look =
        lookAt(body, kC_m_s * (line.knots().back().turn.t_s + random.in(-0.05, 0.15)),
               random.direction() * random.in(0.3, 1.0), random.direction() * random.in(0, 0.95), kC_m_s);
    const reference::Eye eye = look.eye(kC_m_s);
    BodyView view;
    viewBody(line, look.observation, look.headFromBoard(kC_m_s), view);
    std::vector<float> seenX(x.size()), seenY(x.size()), seenZ(x.size());
    seePoints(view, {x, y, z}, {seenX, seenY, seenZ, {}, {}});
    for (std::size_t k = 0; k < x.size(); k += 7) {
      const reference::PointLine point(body.legs, mesh.points[k]);
      outOfTurn += line.knots()[0].spin.omega_rad_s != 0.0 && point.newsOutOfTurn() ? 1 : 0;
      const reference::Event emission = point.emission(eye.event);
      const Vec3 exact = eye.seen(emission);
      const Vec3 solved(seenX[k], seenY[k], seenZ[k]);
      // As pixels of a wall that is looked at square: its width is 1920 for 3 m at 1.5 m.
      const double angle = glm::length(glm::cross(exact, solved)) / glm::dot(exact, exact);
      worst_px = std::max(worst_px, angle * kWall_px * kWallDistance_m / kWall_m);
      ASSERT_LT(angle, 1e-4) << "world line " << i << " vertex " << k;
      ASSERT_NEAR(glm::length(solved) / glm::length(exact), 1.0, 1e-4)
          << "world line " << i << " vertex " << k;
      ++vertices;
      catchingUp += point.catchingUpAt(emission.t) ? 1 : 0;
    }
  }
  std::printf(
      "vertices: %ld, %ld of them catching up, the worst %.4f px off; %ld had their news out of turn\n",
      vertices, catchingUp, worst_px, outOfTurn);
  EXPECT_LT(worst_px, 0.05);
  EXPECT_GT(outOfTurn, 100);
  EXPECT_GT(catchingUp, 1000);
}

}  // namespace
}  // namespace carom
