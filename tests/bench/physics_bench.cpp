// What a frame of the billiard costs, and how many collisions a second the anticipation plays.

#include <benchmark/benchmark.h>

#include "engine/billiard/billiard.h"
#include "engine/collision/rim_friction.h"
#include "engine/game/setup_check.h"
#include "engine/gas.h"
#include "engine/polygons/corner_contact.h"
#include "engine/random_world.h"
#include "engine/soft/soft_play.h"
#include "resident_bytes.h"

namespace carom {
namespace {

// Pairs of pucks that meet head on again and again between the short cushions, as in the paper's measurement:
// each pair runs along its own lane.
BilliardSetup pairsSetup(int pucks) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{2.84, 1.42};
  for (int i = 0; i < pucks; ++i) {
    const double y = 1.42 * ((i / 2 + 0.5) / ((pucks + 1) / 2) - 0.5);
    const double x = i % 2 == 0 ? -0.7 : 0.7;
    setup.pucks.push_back({std::to_string(i), 0.0305, 0.02, 0.2, {x, y}, {i % 2 == 0 ? 0.8 : -0.8, 0.0}});
  }
  return setup;
}

double moveAll(const Billiard& billiard, double t_s) {
  double sum = 0.0;
  for (const WorldLine& line : billiard.worldLines()) sum += line.at(t_s).event.r_m.x;
  return sum;
}

SoftEntry softDiscAt(double beta, int cells) {
  constexpr double kRadius = 0.0305;
  return {"disc",     std::make_shared<SoftMesh>(softDisc(kRadius, cells)),   {0.5, 0.15}, 0.2,
          {0.0, 0.0}, fourVelocity(beta / std::sqrt(1.0 - beta * beta), 0.0), 0.0,         {}};
}

// A step of a soft disc that rings after a bounce; `node_ns` is its share of a node.
void softStep(benchmark::State& state) {
  const SoftEntry entry = softDiscAt(0.6, static_cast<int>(state.range(0)));
  SoftBody body(entry.mesh, entry.material, entry.mass, entry.centre, entry.u);
  SoftGroup group({&body}, {{{1.0, 0.0}, 0.03}});
  group.advance(0.2);
  std::size_t nodes = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(group.step(1.0));
    nodes += body.size();
  }
  state.counters["node_ns"] = benchmark::Counter(1e-9 * static_cast<double>(nodes),
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// A soft disc at 0.6 c on a cushion, from the contact to 20 of its radii of light later.
void softBounce(benchmark::State& state) {
  for (auto _ : state) {
    SoftPlay play({{{1.0, 0.0}, 0.0305}});
    play.add(softDiscAt(0.6, static_cast<int>(state.range(0))));
    while (play.time() < 20.0 * 0.0305) play.playSlice();
    benchmark::DoNotOptimize(play.totals(0).heat);
  }
}

// A frame in which nothing collides: play on, and every puck's place. The first contact is at 0.59 s.
void idleFrame(benchmark::State& state) {
  Billiard billiard(pairsSetup(static_cast<int>(state.range(0))));
  double t_s = 0.0;
  for (auto _ : state) {
    t_s = t_s < 0.3 ? t_s + 1e-9 : 0.0;
    billiard.advanceTo(t_s);
    benchmark::DoNotOptimize(moveAll(billiard, t_s));
  }
}

// Frames in each of which every pair, or every puck with a cushion, collides at once, in a game that goes on
// and on.
void collisionFrame(benchmark::State& state) {
  const double period_s = 1.13;  // from one to the next
  Billiard billiard(pairsSetup(static_cast<int>(state.range(0))));
  double t_s = 0.7;
  std::size_t collisions = 0, known = 0;
  int frame = 0;
  for (auto _ : state) {
    t_s += period_s;
    billiard.advanceTo(t_s);
    benchmark::DoNotOptimize(moveAll(billiard, t_s));
    collisions += billiard.events().size() - known;
    if (++frame % 64 == 0) billiard.forgetBefore(t_s - 32.0 * period_s);  // as a session does
    known = billiard.events().size();
  }
  state.counters["collisions_a_frame"] =
      static_cast<double>(collisions) / static_cast<double>(state.iterations());
}

// Counts the memory that a gas holds at its start and when 4 N collisions were played, which is not in the
// time.
void gas(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  const double coverage = static_cast<double>(state.range(1)) * 1e-4;
  const std::size_t without = test::residentBytes();
  const auto bytesAPuck = [&] {
    const std::size_t now = test::residentBytes();
    return static_cast<double>(now - std::min(now, without)) / count;
  };
  Billiard billiard(test::gasSetup(count, coverage, 2.5, 1));
  state.counters["bytes_a_puck"] = bytesAPuck();
  double afterFour = 0.0;
  const auto noteFour = [&] {
    const bool passed = billiard.events().size() >= static_cast<std::size_t>(4 * count);
    if (passed && afterFour == 0.0) afterFour = bytesAPuck();
    return passed;
  };
  double t_s = 0.0;
  while (billiard.events().size() < static_cast<std::size_t>(2 * count)) billiard.advanceTo(t_s += 0.01);
  billiard.worldLines();  // legs from before that still wait are not in the time
  std::size_t collisions = 0;
  for (auto _ : state) {
    state.PauseTiming();
    noteFour();
    billiard.forgetBefore(t_s);
    const std::size_t before = billiard.events().size();
    state.ResumeTiming();
    while (billiard.events().size() < before + 20000) billiard.advanceTo(t_s += 0.01);
    benchmark::DoNotOptimize(
        billiard.worldLines().data());  // the lines are complete where they are asked for
    collisions += billiard.events().size() - before;
  }
  state.counters["collisions_a_second"] =
      benchmark::Counter(static_cast<double>(collisions), benchmark::Counter::kIsRate);
  while (afterFour == 0.0 && !noteFour()) billiard.advanceTo(t_s += 0.01), billiard.worldLines();
  state.counters["bytes_a_puck_after_4"] = afterFour;
}

// Kicks of pucks up to 0.9 c and rims up to 0.9 c that never slide; the argument is the tangential
// restitution in hundredths.
void collisionSpin(benchmark::State& state) {
  test::Random random(1);
  const auto puck = [&](double towards) {
    const double beta = random.in(0.0, 0.9), across = random.in(-0.5, 0.5), rim = random.in(-0.9, 0.9);
    const double u = beta / std::sqrt(1.0 - beta * beta);
    const SpinningBody body{0.2, 0.1};
    return SpinningPuck{body, spinOfRim(body, rim), fourVelocity(towards * u, across * u)};
  };
  std::vector<std::array<SpinningPuck, 2>> pairs;
  for (int i = 0; i < 256; ++i) pairs.push_back({puck(1.0), puck(-1.0)});
  const RimRules rules{0.9, std::numeric_limits<double>::infinity(),
                       0.01 * static_cast<double>(state.range(0))};
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& pair = pairs[i++ % pairs.size()];
    const Vec21 sum = pair[0].u + pair[1].u, U = sum * (1.0 / std::sqrt(dot(sum, sum)));
    benchmark::DoNotOptimize(kickSpinningPair(U, cross(U, {1.0, 0.0, 1.0}), pair, rules));
  }
}

std::vector<glm::dvec2> regular(int corners, double radius) {
  std::vector<glm::dvec2> outline;
  for (int k = 0; k < corners; ++k) {
    const double at = 2.0 * M_PI * k / corners;
    outline.push_back({radius * std::cos(at), radius * std::sin(at)});
  }
  return outline;
}

// The first contact of two bodies with so many corners that come from 0.5 m to either side at up to 0.9 c,
// most of them to meet; with the second argument their corners go round at up to 0.5 c.
void cornerContact(benchmark::State& state) {
  const Outline outline(regular(static_cast<int>(state.range(0)), 0.05));
  test::Random random(1);
  const auto body = [&](double side) {
    const double beta = random.in(0.1, 0.9), u = beta / std::sqrt(1.0 - beta * beta);
    MovingShape flight{{0.0, 0.5 * side, random.in(-0.05, 0.05)},
                       fourVelocity(-side * u, 0.0),
                       outline.radius(),
                       &outline,
                       random.in(0.0, 6.0)};
    if (state.range(1) != 0) flight.turning = random.in(-0.5, 0.5) / outline.radius();
    return flight;
  };
  std::vector<std::array<MovingShape, 2>> pairs;
  for (int i = 0; i < 256; ++i) pairs.push_back({body(-1.0), body(1.0)});
  std::size_t i = 0, met = 0;
  for (auto _ : state) {
    const auto& pair = pairs[i++ % pairs.size()];
    met += findCornerContact(pair[0], pair[1]) ? 1 : 0;
  }
  state.counters["meet"] = static_cast<double>(met) / static_cast<double>(state.iterations());
}

// A frame in which nothing collides, of bars instead of discs.
void idleBars(benchmark::State& state) {
  BilliardSetup setup = pairsSetup(static_cast<int>(state.range(0)));
  for (Puck& puck : setup.pucks) {
    puck.outline_m = {{-0.03, -0.005}, {0.03, -0.005}, {0.03, 0.005}, {-0.03, 0.005}};
    puck.radius_m = radiusOf_m(puck.outline_m);
  }
  Billiard billiard(setup);
  double t_s = 0.0;
  for (auto _ : state) {
    t_s = t_s < 0.3 ? t_s + 1e-9 : 0.0;
    billiard.advanceTo(t_s);
    benchmark::DoNotOptimize(moveAll(billiard, t_s));
  }
}

BENCHMARK(softStep)->Name("soft_step/cells")->Arg(8)->Arg(12)->Arg(16);
BENCHMARK(softBounce)->Name("soft_bounce/cells")->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK(idleBars)->Name("idle_frame/bars")->Arg(20);
BENCHMARK(cornerContact)
    ->Name("corner_contact")
    ->ArgNames({"corners", "spin"})
    ->Args({4, 0})
    ->Args({16, 0})
    ->Args({4, 1})
    ->Args({16, 1});
BENCHMARK(idleFrame)->Name("idle_frame/pucks")->Arg(2)->Arg(10)->Arg(20);
BENCHMARK(collisionFrame)->Name("collision_frame/pucks")->Arg(2)->Arg(10)->Arg(20);
BENCHMARK(collisionSpin)->Name("collision_spin/restitution_percent")->Arg(0)->Arg(50);
BENCHMARK(gas)
    ->Unit(benchmark::kMillisecond)
    ->ArgNames({"pucks", "coverage_per_10000"})
    ->Args({200, 1000})
    ->Args({1000, 1000})
    ->Args({10000, 1000})
    ->Args({100000, 1000})
    ->Args({1000000, 1000})
    ->Args({1000, 25});

}  // namespace
}  // namespace carom

BENCHMARK_MAIN();
