// What spacetime in the room costs: seven pucks and ten seconds of their game on one wall for one eye, above
// the same frame without it; the frames in which new knots come; and the memory of a hundred pucks for a
// minute.
//
// Needs an X display: tests/with_display build/release/bin/sculpture_bench

#include <benchmark/benchmark.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "cave/display/eye_renderer.h"
#include "cave/frame/bodies.h"
#include "cave/scene/scene_builder.h"
#include "counted_new.h"
#include "engine/billiard/billiard.h"
#include "resident_bytes.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42, kShown_s = 10.0;

Graphics& graphics() {
  static Graphics graphics;
  return graphics;
}

/// Pucks in rows on a table, of which one in three moves.
struct Game {
  BilliardSetup setup;
  Scene scene;
  World world;

  Game(int pucks, double until_s) {
    setup.lightSpeed_m_s = kC_m_s;
    setup.board = Board{2.84, 1.42};
    std::vector<BodyLooks> looks;
    const int columns = static_cast<int>(std::ceil(std::sqrt(2.0 * pucks)));
    for (int i = 0; i < pucks; ++i) {
      const Vec2 place_m(2.6 * (i % columns + 0.5) / columns - 1.3,
                         1.2 * (i / columns + 0.5) / (0.5 * columns + 1) - 0.6);
      const double beta = i % 3 == 0 ? 0.5 : 0.0, angle = 2.4 * i;
      setup.pucks.push_back(
          {std::to_string(i), 0.0305, 0.02, 0.2, place_m, beta * Vec2(std::cos(angle), std::sin(angle))});
      looks.push_back({setup.pucks.back().name, "", 0.0305, 0.02});
      scene.sculpted.bodies.push_back(
          {kFirstPuck + static_cast<std::size_t>(i), setup.pucks.back(), glm::vec3(0.5F)});
    }
    SculptedGame sculpted = scene.sculpted;
    sculpted.half_m = {1.42, 0.71};
    sculpted.hasCushions = true;
    sculpted.top_m = 0.02;
    scene = buildScene(setup, looks);
    scene.sculpted = sculpted;
    Billiard billiard(setup);
    billiard.advanceTo(until_s);
    world.histories.push_back(restingWorldLine(kC_m_s));
    for (const WorldLine& line : billiard.worldLines()) world.histories.push_back(line);
    world.events.assign(billiard.events().begin(), billiard.events().end());
  }

  /// Returns the game as it is known at a board time.
  World worldAt(double t_s) const {
    World then = world;
    for (WorldLine& line : then.histories) line.truncateFrom(t_s);
    std::erase_if(then.events, [&](const GameEvent& event) { return event.at.t_s > t_s; });
    return then;
  }
};

/// A person in the middle of a room of 3 m, beside the table; the glass stands to the right.
FrameRecord recordAt(double t_s, double past_s, double scale) {
  FrameRecord record;
  record.boardFromRoom = Lorentz(kC_m_s);
  record.pucks = 7;
  record.views.spacetime = 1;
  record.sculpture.place = {{{0.9, 0.9, 0.0}, {1.0, 0.0, 0.0, 0.0}}, 2.2, scale, past_s, {}};
  ObserverView& observer = record.viewers[0].observer;
  observer.headFromBoard = Lorentz::boost({-0.1, 0.1, 0.0}, kC_m_s);
  observer.properTime_s = t_s;
  for (EyeView* eye : {&observer.left, &observer.middle, &observer.right})
    *eye = {{t_s, {0.0, -1.6, 0.85}}, {0.0, 0.0, 1.6}};
  return record;
}

Wall frontWall() {
  Wall wall;
  wall.lowerLeft_m = {-1.5, 1.5, 0.0};
  wall.lowerRight_m = {1.5, 1.5, 0.0};
  wall.upperLeft_m = {-1.5, 1.5, 3.0};
  wall.pixels = {600, 600};
  return wall;
}

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// One eye on one wall, with the glass and without, in turn.
class Eyes {
 public:
  explicit Eyes(const Game& game)
      : with_(graphics(), game.scene, kC_m_s), without_(graphics(), game.scene, kC_m_s) {}

  void draw(bool isShown, FrameRecord record, const World& world) {
    record.views.spacetime = isShown ? 1 : 0;
    drawBy(isShown ? with_ : without_, record, world);
  }

  /// Draws a frame without the glass with both.
  void drawWithout(FrameRecord record, const World& world) {
    record.views.spacetime = 0;
    for (EyeRenderer* renderer : {&with_, &without_}) drawBy(*renderer, record, world);
  }

 private:
  void drawBy(EyeRenderer& renderer, FrameRecord record, const World& world) {
    record.number = ++number_;
    const PicturedWall wall{&wall_, &picture_, nullptr, wall_.pixels.x / 2};
    const ObserverView& observer = record.viewers[0].observer;
    renderer.draw(record, world, observer, observer.middle, {&wall, 1});
    glFinish();
  }

  Wall wall_ = frontWall();
  RenderTarget picture_{wall_.pixels};
  EyeRenderer with_, without_;
  std::uint64_t number_ = 0;
};

// Counters, milliseconds of processor in the median: a frame with the glass, one without, and the difference;
// and how often a frame with it allocates.
void wallEye(benchmark::State& state) {
  graphics().makeCurrent();
  const Game game(7, 20.0);
  Eyes eyes(game);
  std::vector<double> with_s, without_s;
  double t_s = 12.0;
  const World world = game.worldAt(20.0);
  for (int i = 0; i < 5; ++i)
    for (const bool isShown : {false, true})
      eyes.draw(isShown, recordAt(t_s, 0.8 * kShown_s, 2.2 / (kShown_s * kC_m_s)), world);
  std::size_t allocated = 0;
  for (auto _ : state) {
    t_s = t_s < 16.0 ? t_s + 1.0 / 60.0 : 12.0;
    const FrameRecord record = recordAt(t_s, 0.8 * kShown_s, 2.2 / (kShown_s * kC_m_s));
    double before_s = processor_s();
    eyes.draw(false, record, world);
    without_s.push_back(processor_s() - before_s);
    before_s = processor_s();
    const std::size_t allocations = test::allocationCount();
    eyes.draw(true, record, world);
    allocated = test::allocationCount() - allocations;
    with_s.push_back(processor_s() - before_s);
  }
  state.counters["with_ms"] = 1e3 * medianOf(with_s);
  state.counters["without_ms"] = 1e3 * medianOf(without_s);
  state.counters["glass_ms"] = 1e3 * (medianOf(with_s) - medianOf(without_s));
  state.counters["allocations"] = static_cast<double>(allocated);
}

// The tubes alone, frame by frame, through ten seconds of the game. Counters, milliseconds: of the frames in
// which nothing new comes in the median, and of those with new knots, the most and in the mean.
void newKnots(benchmark::State& state) {
  const Game game(7, 20.0);
  std::vector<double> still_s, knots_s;
  for (auto _ : state) {
    std::vector<GrowingTube> tubes(game.setup.pucks.size());
    std::size_t knots = 0;
    for (double t_s = 8.0; t_s < 18.0; t_s += 1.0 / 60.0) {
      const World world = game.worldAt(t_s);
      std::size_t now = 0;
      for (const WorldLine& line : world.histories) now += line.knots().size();
      const double before_s = processor_s();
      for (std::size_t i = 0; i < tubes.size(); ++i)
        tubes[i].follow(game.setup.pucks[i], world.histories[kFirstPuck + i], kShown_s, t_s, 0.0, 0x1p-10);
      if (t_s > 8.0) (now > knots ? knots_s : still_s).push_back(processor_s() - before_s);
      knots = now;
    }
  }
  state.counters["still_ms"] = 1e3 * medianOf(still_s);
  state.counters["knots_ms"] = 1e3 * medianOf(knots_s);
  state.counters["most_ms"] = 1e3 * *std::max_element(knots_s.begin(), knots_s.end());
}

// Counter: megabytes that the first frame of a hundred pucks and a minute takes, of this process and its
// driver.
void memory(benchmark::State& state) {
  graphics().makeCurrent();
  const Game game(100, 70.0);
  Eyes eyes(game);
  const FrameRecord record = recordAt(65.0, 60.0, 2.2 / (75.0 * kC_m_s));
  eyes.drawWithout(record, game.world);
  const std::size_t before = test::residentBytes();
  for (auto _ : state) eyes.draw(true, record, game.world);
  std::size_t knots = 0;
  for (const WorldLine& line : game.world.histories) knots += line.knots().size();
  state.counters["knots"] = static_cast<double>(knots);
  state.counters["MB"] = 1e-6 * static_cast<double>(test::residentBytes() - before);
}

BENCHMARK(wallEye)->Unit(benchmark::kMillisecond)->Iterations(120);
BENCHMARK(newKnots)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(memory)->Unit(benchmark::kMillisecond)->Iterations(3);

}  // namespace
}  // namespace carom

BENCHMARK_MAIN();
