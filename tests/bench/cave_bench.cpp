// What relativity costs in drawing: frames of four walls for two eyes, with and without; and a million
// vertices on the way through the vertex shader and on the way through the CPU.
//
// Needs an X display: tests/with_display build/release/bin/cave_bench

#include <benchmark/benchmark.h>
#include <vtk_glew.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cave/bodies/seen_rows.h"
#include "cave/frame/bodies.h"
#include "cave/frame/hall.h"
#include "cave/gl/gl_objects.h"
#include "cave/mesh/mesh_builder.h"
#include "cave/render/wall_renderer.h"
#include "cave/scene/scene_builder.h"
#include "engine/light/mesh_emission.h"
#include "engine/soft/row_recorder.h"
#include "engine/soft/soft_play.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
constexpr int kSide_px = 960;
constexpr Switches kAllOn{1, 1, 1, 1, 1};
constexpr Switches kUnsolved{0, 0, 1, 0, 0};  // the shader has all to do but the solve

/// Walls of a room of 3 m around its origin: front, left, right, floor.
std::array<Wall, 4> walls(int side_px) {
  const auto wall = [side_px](const glm::dvec3& lowerLeft, const glm::dvec3& lowerRight,
                              const glm::dvec3& upperLeft) {
    Wall w;
    w.lowerLeft_m = lowerLeft;
    w.lowerRight_m = lowerRight;
    w.upperLeft_m = upperLeft;
    w.pixels = {side_px, side_px};
    return w;
  };
  return {wall({-1.5, 1.5, 0}, {1.5, 1.5, 0}, {-1.5, 1.5, 3}),
          wall({-1.5, -1.5, 0}, {-1.5, 1.5, 0}, {-1.5, -1.5, 3}),
          wall({1.5, 1.5, 0}, {1.5, -1.5, 0}, {1.5, 1.5, 3}),
          wall({-1.5, -1.5, 0}, {1.5, -1.5, 0}, {-1.5, 1.5, 0})};
}

/// A scene, its bodies' world lines, and two eyes of a head that walks beside the board.
class Room {
 public:
  Room(Graphics& graphics, const Scene& scene, std::vector<WorldLine> histories, int side_px = kSide_px)
      : graphics_(graphics),
        scene_(scene),
        histories_(std::move(histories)),
        bodies_(scene.bodyCount),
        walls_(carom::walls(side_px)),
        pictures_(makePictures(side_px)) {
    for (const ScenePart& part : scene.parts) vertices_ += part.mesh->GetNumberOfPoints();
  }

  /// One for each state of the switches: then nothing is rebuilt while we measure.
  std::unique_ptr<WallRenderer> makeRenderer() const {
    return std::make_unique<WallRenderer>(graphics_, scene_, kC_m_s, 1);
  }

  /// Lets the head go at another place on the board and, to the left, at another speed over c.
  void put(const glm::dvec3& between_m, double beta) {
    between_m_ = between_m;
    beta_ = beta;
    turnSpeed(0.0);
  }

  /// Lets the head go on at another speed, so that nothing that rests looks as it did.
  void turnSpeed(double phase_rad) {
    headFromBoard_ = Lorentz::boost({-beta_ + 0.02 * std::sin(phase_rad), 0.1, 0.05}, kC_m_s);
  }

  /// One frame: four walls, two eyes.
  void draw(WallRenderer& renderer, const Switches& switches, double t_s) {
    for (const double side : {-0.032, 0.032}) {
      const EyeView eye{{t_s, between_m_ + glm::dvec3(side, 0.0, 0.0)}, {side, 0.0, 1.6}};
      for (std::size_t body = 0; body < bodies_.size(); ++body) {
        viewBody(histories_[body], eye.observation, headFromBoard_, bodies_[body], switches);
      }
      renderer.look(headFromBoard_, eye, bodies_, switches);
      std::array<WallPicture, 4> shown;
      for (std::size_t i = 0; i < walls_.size(); ++i)
        shown[i] = {&walls_[i], pictures_[(side > 0.0 ? 4 : 0) + i].get(), {}, nullptr};
      renderer.draw(shown, eye.positionInRoom_m);
    }
  }

  /// The first wall for one eye alone, drawn to the end.
  void drawOneView(WallRenderer& renderer, const Switches& switches, double t_s) {
    const EyeView eye{{t_s, between_m_ - glm::dvec3(0.032, 0.0, 0.0)}, {-0.032, 0.0, 1.6}};
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      viewBody(histories_[body], eye.observation, headFromBoard_, bodies_[body], switches);
    }
    renderer.look(headFromBoard_, eye, bodies_, switches);
    renderer.draw(walls_[0], eye.positionInRoom_m, *pictures_[0]);
    glFinish();
  }

  double vertices() const { return static_cast<double>(vertices_); }
  const Lorentz& headFromBoard() const { return headFromBoard_; }
  const WorldLine& history(std::size_t body) const { return histories_[body]; }

 private:
  Graphics& graphics_;
  const Scene& scene_;
  std::vector<WorldLine> histories_;
  std::vector<BodyView> bodies_;
  vtkIdType vertices_ = 0;
  glm::dvec3 between_m_{0.0, -1.6, 0.85};  // the eyes, on the board
  double beta_ = 0.5;
  Lorentz headFromBoard_ = Lorentz::boost({-beta_, 0.1, 0.05}, kC_m_s);
  std::array<Wall, 4> walls_;
  std::array<std::unique_ptr<RenderTarget>, 8> pictures_;

  static std::array<std::unique_ptr<RenderTarget>, 8> makePictures(int side_px) {
    std::array<std::unique_ptr<RenderTarget>, 8> pictures;
    for (auto& picture : pictures) picture = std::make_unique<RenderTarget>(glm::ivec2(side_px));
    return pictures;
  }
};

using Seconds = std::chrono::duration<double>;

template <typename Function>
double secondsOf(const Function& function) {
  const auto start = std::chrono::steady_clock::now();
  function();
  return Seconds(std::chrono::steady_clock::now() - start).count();
}

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Three pucks at 0.5 to 0.8 c in a hall; they have met cushions and each other by the time of the frames.
struct Game {
  BilliardSetup setup;
  Scene scene;
  std::vector<WorldLine> histories{restingWorldLine(kC_m_s)};

  Game() {
    setup.lightSpeed_m_s = kC_m_s;
    setup.board = Board{2.84, 1.42};
    setup.pucks = {{"white", 0.0305, 0.02, 0.2, {-0.9, 0.0}, {0.8, 0.0}},
                   {"yellow", 0.0305, 0.02, 0.2, {0.49, 0.29}, {0.0, 0.5}},
                   {"red", 0.0305, 0.02, 0.2, {0.48, -0.017}, {0.0, 0.0}}};
    std::vector<BodyLooks> looks;
    for (const Puck& puck : setup.pucks) looks.push_back({puck.name, "", puck.radius_m, puck.height_m});
    scene = buildScene(setup, looks);
    Billiard billiard(setup);
    billiard.advanceTo(12.0);
    for (const WorldLine& line : billiard.worldLines()) histories.push_back(line);
  }
};

/// Twenty pucks that glide side by side at 0.5 c; their rims turn at `rim` c.
struct Twenty {
  Scene scene;
  std::vector<WorldLine> histories{restingWorldLine(kC_m_s)};

  explicit Twenty(double rim) {
    BilliardSetup setup;
    setup.lightSpeed_m_s = kC_m_s;
    std::vector<BodyLooks> looks;
    for (int i = 0; i < 20; ++i) {
      Puck puck{std::to_string(i), 0.05, 0.02, 0.2, {-2.0 + 0.15 * (i / 4), -0.5 + 0.25 * (i % 4)},
                {0.5, 0.0}};
      puck.spin_kg_m2_s = spinAt_kg_m2_s(puck, rim * kC_m_s / puck.radius_m, kC_m_s);
      looks.push_back({puck.name, "", puck.radius_m, puck.height_m});
      setup.pucks.push_back(puck);
    }
    scene = buildScene(setup, looks);
    const Billiard billiard(setup);
    for (const WorldLine& line : billiard.worldLines()) histories.push_back(line);
  }
};

/// A single body of a million vertices, 4 m across, passing the eye at 0.5 c.
struct Million {
  Scene scene;
  std::vector<WorldLine> histories{
      restingWorldLine(kC_m_s),
      WorldLine({{5.0, {0.0, 1.0, 0.0}}, uFromBeta({0.5, 0.0, 0.0}), 0.0, {}, 0.0}, kC_m_s, 3.0)};

  Million() {
    MeshBuilder mesh;
    mesh.addPatch(999, 999, [](double u, double v) {
      return PatchPoint{{4.0 * u - 2.0, 4.0 * v - 2.0, 0.1 * std::sin(20.0 * u)}};
    });
    scene.parts = {{1, mesh.build(), Paint::plain, glm::vec3(0.6F, 0.3F, 0.1F), 0.3F}};
    scene.bodyCount = 2;
    scene.lamps_m = {{{-1.0, 0.0, 1.45}, {0.0, 0.0, 1.45}, {1.0, 0.0, 1.45}}};
  }
};

/// Sheets over the floor, each nearer to the eye than those before: every pixel of each is painted.
Scene sheets(Paint paint, float roughness, int count) {
  Scene scene;
  for (int i = 0; i < count; ++i) {
    MeshBuilder mesh;
    mesh.addPatch(32, 32, [&](double u, double v) {
      const glm::dvec2 place(4.0 * u - 2.0, 4.0 * v - 3.6);
      return PatchPoint{{place, 0.002 * i}, {place, 0.4}};
    });
    scene.parts.push_back({kRestingBody, mesh.build(), paint, glm::vec3(0.5F, 0.4F, 0.3F), roughness});
  }
  scene.bodyCount = 1;
  scene.lamps_m = {{{-1.0, 0.0, 1.45}, {0.0, 0.0, 1.45}, {1.0, 0.0, 1.45}}};
  return scene;
}

/// Draws a frame to its end.
void finish(Room& room, WallRenderer& renderer, const Switches& switches, double t_s) {
  room.draw(renderer, switches, t_s);
  glFinish();
}

/// One state of the switches, drawn and timed.
struct Drawn {
  const char* name;
  Switches switches;
  std::unique_ptr<WallRenderer> renderer;
  std::vector<double> times_s;
  std::vector<double> processor_s;  // of all threads
  GpuTimer card;
};

/// Frames in turn with each state of the switches, so that whatever else the machine does strikes all alike.
/// Counters: median milliseconds a frame, by the wall's clock, of processors and of the graphics card, and
/// the first two over those of the first state. If the head moves, its speed changes from frame to frame.
void measureInTurn(benchmark::State& state, Room& room, bool moves = false) {
  std::array<Drawn, 4> states{{{"euclid", kNoSwitches, {}, {}, {}, {}},
                               {"relativity", {}, {}, {}, {}, {}},
                               {"with_colour", kAllOn, {}, {}, {}, {}},
                               {"unsolved", kUnsolved, {}, {}, {}, {}}}};
  double t_s = 3.0;
  for (Drawn& drawn : states) {
    drawn.renderer = room.makeRenderer();
    finish(room, *drawn.renderer, drawn.switches, t_s);  // compiles
  }
  for (auto _ : state) {
    t_s = t_s < 8.0 ? t_s + 1.0 / 60.0 : 3.0;
    if (moves) room.turnSpeed(10.0 * t_s);
    for (Drawn& drawn : states) {
      const std::clock_t before = std::clock();
      drawn.times_s.push_back(secondsOf([&] {
        drawn.card.begin();
        room.draw(*drawn.renderer, drawn.switches, t_s);
        drawn.card.end();
        glFinish();
      }));
      drawn.processor_s.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
  }
  state.counters["vertices"] = room.vertices();
  for (const Drawn& drawn : states) {
    const std::string name = drawn.name;
    state.counters[name + "_ms"] = 1e3 * medianOf(drawn.times_s);
    state.counters[name + "_cpu_ms"] = 1e3 * medianOf(drawn.processor_s);
    state.counters[name + "_card_ms"] = 1e3 * static_cast<double>(drawn.card.median_s());
    state.counters[name + "_ratio"] = medianOf(drawn.times_s) / medianOf(states[0].times_s);
    state.counters[name + "_cpu_ratio"] = medianOf(drawn.processor_s) / medianOf(states[0].processor_s);
  }
}

Graphics& graphics() {
  static Graphics graphics;
  return graphics;
}

// Four walls of 960 × 960, two eyes, no multisampling.
void frame(benchmark::State& state) {
  graphics().makeCurrent();
  const Game game;
  Room room(graphics(), game.scene, game.histories);
  measureInTurn(state, room);
}

// The same while the head's speed changes: nothing can be kept from the frame before.
void movingFrame(benchmark::State& state) {
  graphics().makeCurrent();
  const Game game;
  Room room(graphics(), game.scene, game.histories);
  measureInTurn(state, room, true);
}

// The same 10 cm before a wall of the hall, at 0.95 c along it: surfaces are divided as finely as they ever
// are.
void nearWall(benchmark::State& state) {
  graphics().makeCurrent();
  const Game game;
  Room room(graphics(), game.scene, game.histories);
  room.put({0.0, 0.5 * Hall().size_m.y - 0.1, 0.85}, 0.95);
  measureInTurn(state, room, true);
}

// `movingFrame` at a size at which pixels cost nothing: what is left is the price of vertices and of
// commands.
void frameWithoutPixels(benchmark::State& state) {
  graphics().makeCurrent();
  const Game game;
  Room room(graphics(), game.scene, game.histories, 16);
  measureInTurn(state, room, true);
}

// The same with nothing in sight: the table lies behind all walls, and there is no hall.
void nothingInSight(benchmark::State& state) {
  graphics().makeCurrent();
  Game game;
  std::erase_if(game.scene.parts, [](const ScenePart& part) { return part.body == kRestingBody; });
  for (WorldLine& line : std::span(game.histories).subspan(kFirstPuck))
    line = WorldLine({{0.0, {0.0, -20.0, 20.0}}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, line.radius_m());
  Room room(graphics(), game.scene, game.histories);
  measureInTurn(state, room);
}

/// Returns how long the processors work on this, in seconds.
template <typename Function>
double processorTimeOf(const Function& function) {
  const std::clock_t before = std::clock();
  function();
  return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
}

// Eight views (four walls, two eyes) in one process beside one view in one process: what a view costs must
// not grow with their number. In turn, with and without the emission solve.
void views(benchmark::State& state) {
  graphics().makeCurrent();
  const Game game;
  Room room(graphics(), game.scene, game.histories);
  const auto solved = room.makeRenderer(), unsolved = room.makeRenderer();
  finish(room, *solved, {}, 3.0);
  finish(room, *unsolved, kUnsolved, 3.0);
  std::vector<double> eight_s, one_s, unsolved_s;
  double t_s = 3.0;
  for (auto _ : state) {
    t_s = t_s < 8.0 ? t_s + 1.0 / 60.0 : 3.0;
    one_s.push_back(processorTimeOf([&] { room.drawOneView(*solved, {}, t_s); }));
    eight_s.push_back(processorTimeOf([&] { finish(room, *solved, {}, t_s); }));
    unsolved_s.push_back(processorTimeOf([&] { finish(room, *unsolved, kUnsolved, t_s); }));
  }
  state.counters["one_cpu_ms"] = 1e3 * medianOf(one_s);
  state.counters["eight_cpu_ms"] = 1e3 * medianOf(eight_s);
  state.counters["eight_to_one"] = medianOf(eight_s) / medianOf(one_s);
  state.counters["solve_share"] = 1.0 - medianOf(unsolved_s) / medianOf(eight_s);
}

// Twenty pucks that spin beside twenty that do not, in turn.
void twentySpinning(benchmark::State& state) {
  graphics().makeCurrent();
  const Twenty still(0.0), spinning(0.9);
  Room stillRoom(graphics(), still.scene, still.histories);
  Room spinningRoom(graphics(), spinning.scene, spinning.histories);
  const auto stillRenderer = stillRoom.makeRenderer(), spinningRenderer = spinningRoom.makeRenderer();
  finish(stillRoom, *stillRenderer, {}, 3.0);
  finish(spinningRoom, *spinningRenderer, {}, 3.0);
  std::vector<double> still_s, spinning_s;
  double t_s = 3.0;
  for (auto _ : state) {
    t_s = t_s < 6.0 ? t_s + 1.0 / 60.0 : 3.0;
    still_s.push_back(processorTimeOf([&] { finish(stillRoom, *stillRenderer, {}, t_s); }));
    spinning_s.push_back(processorTimeOf([&] { finish(spinningRoom, *spinningRenderer, {}, t_s); }));
  }
  state.counters["still_cpu_ms"] = 1e3 * medianOf(still_s);
  state.counters["spinning_cpu_ms"] = 1e3 * medianOf(spinning_s);
  state.counters["ratio"] = medianOf(spinning_s) / medianOf(still_s);
}

// A pixel of one paint, light included: what 32 sheets that fill a wall take more than one, over their
// pixels.
void pixel(benchmark::State& state, Paint paint, float roughness) {
  graphics().makeCurrent();
  const Wall floor = walls(kSide_px)[3];
  RenderTarget picture(floor.pixels);
  const EyeView eye{{3.0, {0.0, -1.6, 1.2}}, {0.0, 0.0, 1.6}};
  const WorldLine history = restingWorldLine(kC_m_s);
  std::vector<BodyView> bodies(1);
  double phase_rad = 0.0;
  const auto draw = [&](WallRenderer& renderer, const Switches& switches) {
    const Lorentz headFromBoard = Lorentz::boost({0.02 * std::sin(phase_rad), 0.01, 0.0}, kC_m_s);
    viewBody(history, eye.observation, headFromBoard, bodies[0], switches);
    renderer.look(headFromBoard, eye, bodies, switches);
    renderer.draw(floor, eye.positionInRoom_m, picture);
    glFinish();
  };
  constexpr int kMany = 32;
  const Scene few = sheets(paint, roughness, 1), many = sheets(paint, roughness, kMany);
  struct Pair {
    const char* name;
    Switches switches;
    WallRenderer few, many;
    std::vector<double> more_s;
  };
  std::array<Pair, 2> pairs{
      {{"relativity_ns", {}, {graphics(), few, kC_m_s, 1}, {graphics(), many, kC_m_s, 1}, {}},
       {"with_colour_ns", kAllOn, {graphics(), few, kC_m_s, 1}, {graphics(), many, kC_m_s, 1}, {}}}};
  for (Pair& pair : pairs) {
    for (WallRenderer* renderer : {&pair.few, &pair.many}) draw(*renderer, pair.switches);  // compiles
  }
  for (auto _ : state) {
    phase_rad += 1.0;
    for (Pair& pair : pairs) {
      const double few_s = processorTimeOf([&] { draw(pair.few, pair.switches); });
      pair.more_s.push_back(processorTimeOf([&] { draw(pair.many, pair.switches); }) - few_s);
    }
  }
  constexpr double kPixels = (kMany - 1.0) * kSide_px * kSide_px;
  for (const Pair& pair : pairs) state.counters[pair.name] = 1e9 * medianOf(pair.more_s) / kPixels;
}

// The same as `frame` with a million vertices.
void million(benchmark::State& state) {
  graphics().makeCurrent();
  const Million body;
  Room room(graphics(), body.scene, body.histories);
  measureInTurn(state, room);
}

// The way through the CPU: a million vertices solved on one thread and handed to OpenGL, for two eyes. A
// frame is then this and what `million` says of unsolved ones.
void millionSolvedAndUploaded(benchmark::State& state) {
  graphics().makeCurrent();
  const Million body;
  Room room(graphics(), body.scene, body.histories);
  constexpr std::size_t kCount = 1000000;
  std::vector<float> offsets(3 * kCount), seen(3 * kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    const double* p = body.scene.parts[0].mesh->GetPoint(static_cast<vtkIdType>(i));
    for (std::size_t k = 0; k < 3; ++k) offsets[k * kCount + i] = static_cast<float>(p[k]);
  }
  const auto third = [&](std::vector<float>& values, std::size_t k) {
    return std::span<float>(values).subspan(k * kCount, kCount);
  };
  const Points points{third(offsets, 0), third(offsets, 1), third(offsets, 2)};
  const SeenPoints places{third(seen, 0), third(seen, 1), third(seen, 2), {}, {}};
  const GlBuffer buffer;
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  BodyView view;
  std::vector<double> solve_s, upload_s;
  for (auto _ : state) {
    for (const double side : {-0.032, 0.032}) {
      solve_s.push_back(secondsOf([&] {
        viewBody(room.history(1), {4.0, {side, -1.6, 0.85}}, room.headFromBoard(), view);
        seePoints(view, points, places);
      }));
      upload_s.push_back(secondsOf([&] {
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(seen.size() * sizeof(float)), seen.data(),
                     GL_STREAM_DRAW);
        glFinish();
      }));
    }
  }
  state.counters["solve_ms"] = 2e3 * medianOf(solve_s);
  state.counters["upload_ms"] = 2e3 * medianOf(upload_s);
}

/// A soft puck of 12 rings that bounces until it has 300 rows.
SoftPast bouncing(const SoftMesh& mesh) {
  SoftPlay play({{{1.0, 0.0}, 0.2}, {{-1.0, 0.0}, 0.2}});
  SoftEntry entry;
  entry.name = "jelly";
  entry.mesh = std::make_shared<const SoftMesh>(mesh);
  entry.mass = 0.2;
  entry.u = {1.25, 0.75, 0.0};
  play.add(entry);
  SoftRows rows;
  std::vector<glm::dvec2> places;
  play.drawnPlaces(0, 0.0, places);
  RowRecorder recorder(1, 0.0, places, false);
  play.watch([&](std::size_t, double time) {
    play.drawnPlaces(0, std::nullopt, places);
    recorder.take(time, places, play.body(0), !play.isAwake(0), rows);
  });
  while (rows.rows.size() < 300) play.playSlice();
  SoftPast past;
  for (std::size_t k = 0; k < 300; ++k)
    past.rows.append(rows.rows[k], std::span(rows.nodes).subspan(k * places.size(), places.size()));
  return past;
}

void ring_view(benchmark::State& state) {
  const SoftMesh mesh = softDisc(0.0305, 12);
  const SoftModel model = softModel(mesh, true, 0.02, 1, glm::vec3(1.0F));
  const SoftPast past = bouncing(mesh);
  const double first_s = past.rows.row(0).time / kC_m_s + 0.3,
               last_s = past.rows.row(299).time / kC_m_s + 0.3;
  SeenRows view;
  std::vector<SeenVertex> seen(model.vertices.size());
  double t_s = first_s;
  for (auto _ : state) {
    t_s = t_s + 1.0 / 60.0 < last_s ? t_s + 1.0 / 60.0 : first_s;
    view.see(model, past, {{t_s, {0.1 * std::sin(5.0 * t_s), -0.3, 0.3}}, Lorentz(kC_m_s)}, Told::nothing,
             seen);
    benchmark::DoNotOptimize(seen.data());
  }
  state.counters["points"] = static_cast<double>(model.points.size());
}

BENCHMARK(ring_view)->Unit(benchmark::kMicrosecond);
BENCHMARK(frame)->Unit(benchmark::kMillisecond);
BENCHMARK(movingFrame)->Unit(benchmark::kMillisecond);
BENCHMARK(nearWall)->Unit(benchmark::kMillisecond);
BENCHMARK(frameWithoutPixels)->Unit(benchmark::kMillisecond);
BENCHMARK(nothingInSight)->Unit(benchmark::kMillisecond);
BENCHMARK(views)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pixel, plain, Paint::plain, 0.1F)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(pixel, cloth, Paint::cloth, 0.0F)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(pixel, wood, Paint::wood, 0.35F)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(pixel, panels, Paint::panels, 0.0F)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(pixel, floor, Paint::floor, 0.05F)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(pixel, puck, Paint::puck, 0.5F)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(twentySpinning)->Unit(benchmark::kMillisecond);
BENCHMARK(million)->Unit(benchmark::kMillisecond);
BENCHMARK(millionSolvedAndUploaded)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace carom

BENCHMARK_MAIN();
