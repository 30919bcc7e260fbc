// What a link with another room costs: its part of a frame, its thread, and a stroke from afar beside one's
// own. Two rooms in one process, 60 frames a second by the wall's clock, with TLS on loopback.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <thread>

#include "app/link/link_line.h"
#include "app/link/linked_play.h"
#include "engine/linked/pace.h"
#include "engine/three_pucks.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
constexpr double kC_m_s = 1.42, kFrame_s = 1.0 / 60.0;

BilliardSetup table() {
  BilliardSetup setup = test::threePucks();
  for (Puck& puck : setup.pucks) puck.beta *= 0.3;
  setup.rules.friction_m_s2 = 0.05;
  return setup;
}

ObserverStart place() { return {{-2.3, 0.0, -0.75}, 0.0, Vec3(0.0)}; }

LinkSelf selfNamed(const char* name, bool hosts) {
  LinkSelf self;
  self.hosts = hosts;
  self.room = name;
  self.viewers = {"viewer"};
  self.program = "bench";
  self.apart_m = 0.0;
  return self;
}

/// The time that something takes.
template <typename Work>
double timeOf_s(Work&& work) {
  const auto begin = Clock::now();
  work();
  return Seconds(Clock::now() - begin).count();
}

/// A room with a person who walks.
class Room {
 public:
  Room(const char* name, const LinkAddress& address)
      : line(address, LinkKey::of("0000-0000-0000-0000-0000-0000-0000")),
        play(selfNamed(name, address.listens), line, 7) {
    if (address.listens) begin(place(), [&](LinkedGame its) { play.play(std::move(its)); });
  }

  /// Lives a frame, and returns how long all that is the link's takes.
  double frame() {
    double took_s = timeOf_s([&] { play.hear(Clock::now()); });
    if (const auto welcome = play.takeInvitation()) {
      begin(seat(place(), welcome->room, welcome->rooms, welcome->apart_m),
            [&](LinkedGame its) { play.join(*welcome, std::move(its)); });
    }
    fromAfar = play.heard().strokes.size();
    const double heard_s = took_s;
    const double struck_s = timeOf_s([&] {
      for (const LinkStroke& stroke : play.heard().strokes) game->strike(stroke.told.stroke);
    });
    afar_s = heard_s + struck_s;
    if (!game) return took_s;
    if (!play.own() && !start()) return took_s;
    took_s += timeOf_s([&] { live(); });
    game->advanceTo(observers->headEvent().t_s + 0.1);
    took_s += timeOf_s([&] { tell(); });
    return took_s;
  }

  /// Strikes, and returns how long it takes.
  double strike() {
    const Event act = observers->headEvent() + Displacement{0.0, {0.2, 0.3, -0.4}};
    const Stroke stroke{0, act.t_s, act.r_m, {0.02, 0.01}, 0.0};
    return timeOf_s([&] {
      const Stroke kept = play.own()->putOff(0, stroke, observers->boardFromRoom());
      game->strike(kept);
      play.struck(0, kept);
    });
  }

  LinkLine line;
  LinkedPlay play;
  std::optional<Billiard> game;
  std::optional<Observers> observers;
  std::size_t fromAfar = 0;  ///< strokes in this frame
  double afar_s = 0.0;       ///< what hearing and playing them took

 private:
  template <typename Begin>
  void begin(const ObserverStart& start, Begin&& begins) {
    LinkedGame its;
    its.scenario = "a table";
    its.billiard = table();
    its.start = place();
    start_ = start;
    observers.reset();
    game.emplace(table());
    begins(std::move(its));
  }
  bool start() {
    const auto begins_s = play.begins_s(Clock::now());
    if (!begins_s) return false;
    observers.emplace(Lorentz(kC_m_s), Event{*begins_s, start_.position_m},
                      Head{{Vec3(0.0, 0.0, 1.6), {1, 0, 0, 0}}, Vec3(0.0)});
    play.begin(*observers, Clock::now());
    return true;
  }
  /// Tries the frame on a copy, as rooms do that are linked.
  void live() {
    isLiving_ = false;
    if (!play.isLiving()) return;
    walk_s_ += kFrame_s;
    const Head head{{Vec3(0.4 * std::sin(walk_s_), 0.3 * std::cos(0.7 * walk_s_), 1.6), {1, 0, 0, 0}},
                    Vec3(0.0)};
    isLiving_ = livablePace(play.pace(Clock::now()), [&](double pace) {
                  Observers tried = *observers;
                  tried.beginFrame();
                  tried.step(kFrame_s, {&head, 1}, pace);
                  const ObserverView view = tried.view(0.064);
                  for (const EyeView& eye : view.all())
                    if (!play.allows(eye.observation)) return false;
                  observers = tried;
                  return true;
                }).has_value();
  }
  void tell() {
    const Vec3 hand(0.2, 0.3, -0.4);
    const ObserverView view = observers->view(0.064);
    const std::array<Event, 3> eyes{view.left.observation, view.right.observation, view.middle.observation};
    play.tell(*observers, {&hand, 1}, {}, eyes, !isLiving_, Clock::now());
    play.compare(game->worldLines());
    play.tellSettings(kC_m_s, false);
  }

  ObserverStart start_;
  double walk_s_ = 0.0;
  bool isLiving_ = false;
};

double processor_s(int who) {
  rusage used{};
  getrusage(who, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Two rooms that play one game.
struct Two {
  Two() : host("grenoble", {true, "127.0.0.1", 0}), joiner("lyon", {false, "127.0.0.1", host.line.port()}) {
    for (int i = 0; i < 1200 && !isPlaying(); ++i) frame();
    for (int i = 0; i < 60; ++i) frame();
  }
  bool isPlaying() const {
    return host.play.state() == LinkState::playing && joiner.play.state() == LinkState::playing;
  }
  /// Waits for the next frame, and lives it in both rooms; returns the host's part.
  double frame() {
    next_ += std::chrono::duration_cast<Clock::duration>(Seconds(kFrame_s));
    std::this_thread::sleep_until(next_);
    const double took_s = host.frame();
    joiner.frame();
    return took_s;
  }

  Room host, joiner;

 private:
  Clock::time_point next_ = Clock::now();
};

void frame(benchmark::State& state) {
  Two two;
  if (!two.isPlaying()) return state.SkipWithError("the rooms do not play together");
  const LineTraffic before = two.host.line.traffic();
  const double threads_s = processor_s(RUSAGE_SELF) - processor_s(RUSAGE_THREAD);
  const auto begin = Clock::now();
  double most_s = 0.0;
  for (auto _ : state) {
    const double took_s = two.frame();
    most_s = std::max(most_s, took_s);
    state.SetIterationTime(took_s);
  }
  const double lasted_s = Seconds(Clock::now() - begin).count();
  const LineTraffic after = two.host.line.traffic();
  state.counters["most_ms"] = 1e3 * most_s;
  state.counters["thread_percent"] =  // of a core; two rooms have two
      50.0 * (processor_s(RUSAGE_SELF) - processor_s(RUSAGE_THREAD) - threads_s) / lasted_s;
  state.counters["sent_kB_s"] = 1e-3 * static_cast<double>(after.sentBytes - before.sentBytes) / lasted_s;
  state.counters["received_kB_s"] =
      1e-3 * static_cast<double>(after.receivedBytes - before.receivedBytes) / lasted_s;
}

void stroke(benchmark::State& state) {
  Two two;
  if (!two.isPlaying()) return state.SkipWithError("the rooms do not play together");
  constexpr int kBetween = 15;  // frames: nobody strikes more than twenty times a second
  double own_s = 0.0;
  for (auto _ : state) {
    own_s += two.joiner.strike();
    double afar_s = 0.0;
    for (int i = 0; i < kBetween; ++i) {
      two.frame();
      if (two.host.fromAfar > 0) afar_s = two.host.afar_s;
    }
    if (afar_s == 0.0) return state.SkipWithError("a stroke did not arrive");
    state.SetIterationTime(afar_s);
  }
  state.counters["own_us"] = 1e6 * own_s / static_cast<double>(state.iterations());
}

BENCHMARK(frame)->Name("link/frame")->Iterations(1200)->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(stroke)->Name("link/stroke")->Iterations(60)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace carom

BENCHMARK_MAIN();
