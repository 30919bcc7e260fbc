#pragma once
// A recorded session of four seconds, the game as the physics plays it, and an operator who plays it back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "app/journal/journal.h"
#include "app/live/frame_source.h"
#include "app/play/game.h"
#include "app/scenario/starting_histories.h"
#include "app/temporary_folder.h"
#include "app/viewer/viewers.h"
#include "cave/record/frame_digest.h"
#include "engine/billiard/billiard.h"
#include "engine/light/light_cone.h"
#include "places.h"

namespace carom::test {

inline constexpr std::uint64_t kFrames = 240;
inline constexpr double kHz = 60.0, kPeriod_s = 1.0 / kHz;
inline constexpr double kSame_s = 1e-11;  // board times and light paths of seconds, in double

inline std::string walkText(double seconds, double speed_m_s) {
  std::ostringstream text("time_s,x_m,y_m,z_m\n", std::ios::ate);
  text.precision(17);
  for (double t_s = 0.0; t_s <= seconds; t_s += 0.01) {
    text << t_s << ',' << 0.3 * std::sin(speed_m_s * t_s / 0.3) << ",1.6," << 0.1 * std::cos(t_s) << '\n';
  }
  return text.str();
}

inline double latest_s(const ObserverView& observer) {
  double t_s = observer.left.observation.t_s;
  for (const EyeView& eye : observer.all()) t_s = std::max(t_s, eye.observation.t_s);
  return t_s;
}

/// Where and when the light left that each eye receives from points of all bodies.
inline std::vector<Event> lightOf(std::span<const WorldLine> histories, const ObserverView& observer) {
  std::vector<Event> light;
  for (const WorldLine& line : histories) {
    const double r_m = line.radius_m();
    for (const Vec3& point :
         {Vec3(0.0), Vec3(r_m, 0, 0), Vec3(-r_m, 0, 0), Vec3(0, r_m, 0), Vec3(0, -r_m, 0)}) {
      for (const EyeView& eye : observer.all()) {
        const auto emitted = emission(line, point, eye.observation, observer.headFromBoard);
        light.push_back(emitted ? emitted->event : Event{-1e300, {}});
      }
    }
  }
  return light;
}

inline void expectSame(const std::vector<Event>& a, const std::vector<Event>& b, double c_m_s) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_LT(std::abs(a[i].t_s - b[i].t_s), kSame_s) << "point " << i;
    ASSERT_LT(glm::distance(a[i].r_m, b[i].r_m), kSame_s * c_m_s) << "point " << i;
  }
}

template <typename T>
bool sameBits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Of all fields; what lies between them is nothing.
inline bool sameBits(const FrameRecord& a, const FrameRecord& b) {
  return digestOf(FrameState{a, {}, {}, {}, {}}, World{}) == digestOf(FrameState{b, {}, {}, {}, {}}, World{});
}

inline void expectSameGame(const World& a, const World& b) {
  ASSERT_EQ(a.histories.size(), b.histories.size());
  for (std::size_t body = 0; body < a.histories.size(); ++body) {
    const auto these = a.histories[body].knots(), those = b.histories[body].knots();
    ASSERT_EQ(these.size(), those.size()) << "body " << body;
    for (std::size_t k = 0; k < these.size(); ++k) {
      ASSERT_EQ(these[k].turn.t_s, those[k].turn.t_s) << "body " << body << " knot " << k;
      ASSERT_EQ(these[k].u, those[k].u) << "body " << body << " knot " << k;
    }
  }
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i) ASSERT_EQ(a.events[i].number, b.events[i].number);
}

/// A session of four seconds: as it was lived, and its file. Colour is on from frame 30 to 59.
class ReplaySources : public testing::Test {
 protected:
  ReplaySources()
      : rig_(rigBesideItsTrace()),
        scenario_(readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml")),
        atStart_(startingHistories(scenario_)) {
    play();
    session_ = std::make_unique<SessionFile>(folder_ / "game.db");
    Billiard billiard(scenario_.billiard);
    billiard.advanceTo(30.0);
    truth_ = atStart_;
    for (std::size_t i = 0; i < billiard.worldLines().size(); ++i) truth_[i + 1] = billiard.worldLines()[i];
  }

  Rig rigBesideItsTrace() const {
    folder_.file("walk.csv", walkText(9.0, 0.4));
    return readRig(
        folder_.file("room.toml",
                     "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"walker\"\n"
                     "[[tracker]]\nname = \"walker\"\nkind = \"recorded\"\nsource = \"walk.csv\"\n"
                     "[[wall]]\nname = \"front\"\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\n"
                     "upper_left = [-1, 2, -1]\npixels = [64, 64]\nstereo = \"mono\"\n"
                     "window = { position = [0, 0], size = [64, 64] }\n"));
  }

  void play() {
    SimulatedClock clock;
    Pacer pacer(clock, kHz, 0.0);
    Viewers person(rig_, scenario_, {});
    Game game(scenario_);
    Journal journal(
        folder_ / "game.db",
        {"carom", folder_ / "room.toml", "three-pucks.toml", "", "", scenario_.billiard.lightSpeed_m_s},
        false);
    while (lived_.size() < kFrames) {
      const FrameTimes times = pacer.next();
      FrameState& frame = lived_.emplace_back();
      frame.record.viewers[0].observer = person.at(times, 0.064)[0];
      frame.record.number = times.number;
      frame.record.display_s = times.display_s;
      frame.record.boardFromRoom = person.boardFromRoom();
      frame.record.lightSpeed_m_s = c_m_s();
      frame.record.switches.colour = times.number >= 30 && times.number < 60;
      frame.record.viewers[0].tracked = person.tracked();
      game.advance(latest_s(frame.record.viewers[0].observer), frame);
      journal.add(frame, {&person.head(), 1}, std::vector<TrackerSamples>{{0, person.samples()}});
      pacer.awaitTick(0.0);
      pacer.swapped();
    }
  }

  /// What was seen in a frame of the session, as the game was known then.
  std::vector<Event> livedLight(std::uint64_t number) const {
    World world{atStart_, {}};
    for (std::uint64_t i = 0; i <= number; ++i) applyFrame(lived_[i], world);
    return lightOf(world.histories, lived_[number].record.viewers[0].observer);
  }

  double c_m_s() const { return scenario_.billiard.lightSpeed_m_s; }

  const TemporaryFolder folder_;
  Rig rig_;
  Scenario scenario_;
  std::vector<WorldLine> atStart_;
  std::vector<FrameState> lived_;
  std::unique_ptr<SessionFile> session_;
  std::vector<WorldLine> truth_;  ///< much longer than the session
};

/// A source with an operator, and the world that its frames make.
struct Show {
  Show(FrameSource& frames, FramePacer& frameTimes, std::vector<WorldLine> atStart)
      : source(frames), pacer(frameTimes), world{std::move(atStart), {}} {}

  const FrameRecord& next() {
    const FrameTimes times = pacer.next();
    source.next(times, {commands, {}}, settings, decision);
    commands.clear();
    applyFrame(decision.frame, world);
    pacer.awaitTick(decision.stay_s);
    pacer.swapped();
    return decision.frame.record;
  }
  /// As the frame loop does with what the operator asks for.
  void command(const Command& wanted) {
    apply(wanted, settings);
    commands.push_back(wanted);
  }
  void goTo(double session_s) { command(Seek{session_s}); }

  FrameSource& source;
  FramePacer& pacer;
  World world;
  OperatorSettings settings;
  Commands commands;
  Decision decision;
  const FrameState& frame = decision.frame;
};

}  // namespace carom::test
