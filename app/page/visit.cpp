#include "app/page/visit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include "app/journal/session_file.h"
#include "app/scenario/starting_histories.h"
#include "app/stage/scenario_scene.h"
#include "cave/frame/bodies.h"
#include "cave/room/wall_eyes.h"
#include "engine/spacetime/observers.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// Refuses what a page cannot hold.
void checkGame(const Scenario& scenario, const std::string& file) {
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  if (pucks.size() > kMostVisitPucks) {
    throw std::runtime_error(fmt::format(
        "{}: the game has {} pucks, expected at most {} for a page; carom replay --movie makes a film of it",
        file, pucks.size(), kMostVisitPucks));
  }
  if (std::any_of(pucks.begin(), pucks.end(), [](const Puck& puck) { return puck.soft.has_value(); }) ||
      !scenario.told.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: the game has soft bodies, which a page does not show; carom replay --movie makes a film of it",
        file));
  }
}

/// Adds what changes the game from frame to frame, before and among those that the page has.
class KnownChanges {
 public:
  explicit KnownChanges(Visit& visit) : visit_(visit) {}

  /// The frame that the visit gets next is the first to know this.
  void add(const FrameState& state) {
    const bool cuts = state.record.truncateFrom_s < std::numeric_limits<double>::infinity();
    if (!cuts && state.knots.empty()) return;
    visit_.changes.push_back({visit_.frames.size(), state.record.truncateFrom_s, state.knots});
  }

 private:
  Visit& visit_;
};

/// The place of the room where a head was longest, to 0.1 m.
class LongestPlace {
 public:
  void add(const Vec3& place_m) {
    auto& [count, sum_m] =
        cells_[{std::lround(10.0 * place_m.x), std::lround(10.0 * place_m.y), std::lround(10.0 * place_m.z)}];
    ++count;
    sum_m += place_m;
  }
  Vec3 place_m() const {
    const auto most = std::max_element(cells_.begin(), cells_.end(), [](const auto& a, const auto& b) {
      return a.second.first < b.second.first;
    });
    return most->second.second / static_cast<double>(most->second.first);
  }

 private:
  std::map<std::tuple<long, long, long>, std::pair<std::size_t, Vec3>> cells_;
};

/// Returns the flat walls that show this viewer's eyes.
std::vector<Wall> wallsOf(const Rig& rig, std::size_t viewer) {
  std::vector<Wall> walls;
  for (const Wall& wall : drawnWalls(rig)) {
    const std::vector<ViewerEye> eyes = eyesOf(wall);
    const auto isTheirs = [viewer](const ViewerEye& eye) { return eye.viewer == viewer; };
    if (wall.piece == 0 && !wall.sky && !wall.onHead && std::any_of(eyes.begin(), eyes.end(), isTheirs))
      walls.push_back(wall);
  }
  return walls;
}

/// Makes every frame that of a head which stays where it was longest.
void standStill(Visit& visit, const std::vector<double>& room_s) {
  LongestPlace longest;
  for (const VisitFrame& frame : visit.frames) longest.add(frame.observer.middle.positionInRoom_m);
  for (std::size_t i = 0; i < visit.frames.size(); ++i) {
    VisitFrame& frame = visit.frames[i];
    frame.observer = viewAtRest(frame.observer, frame.boardFromRoom, room_s[i], longest.place_m(),
                                visit.eyeBesideMiddle_m);
  }
}

bool isWithin(double display_s, const VisitOptions& options) {
  return display_s >= options.from_s.value_or(-1e300) && display_s <= options.until_s.value_or(1e300);
}

void checkFrames(const Visit& visit, const std::string& file, const VisitOptions& options) {
  if (visit.frames.empty()) {
    throw std::runtime_error(
        fmt::format("session file {}: no frame of this game lies between --from and --until with a number "
                    "that is a multiple of {}, "
                    "expected other times: carom list {} says which there are",
                    file, options.every, file));
  }
}

/// Reads the frames of a game.
void readFrames(SessionFile& session, std::size_t viewer, const VisitOptions& options,
                const std::string& file, Visit& visit) {
  World world{visit.atStart, {}};
  KnownChanges changes(visit);
  std::vector<double> room_s;
  session.goTo(0);
  for (FrameState state; session.next(state);) {
    const FrameRecord& record = state.record;
    if (record.display_s > options.until_s.value_or(1e300)) break;
    session.apply(state, world);
    changes.add(state);
    for (const ViewerState& one : record.present())
      for (const EyeView& eye : one.observer.all())
        visit.known_s = std::max(visit.known_s, eye.observation.t_s);
    if (record.viewerCount <= viewer || record.number % options.every != 0 ||
        !isWithin(record.display_s, options))
      continue;
    if (visit.frames.size() == kMostVisitFrames) {
      throw std::runtime_error(
          fmt::format("session file {}: a page holds {} frames at most, expected --from and --until closer "
                      "together, or a "
                      "larger --every than {}",
                      file, kMostVisitFrames, options.every));
    }
    visit.frames.push_back(frameOf(record, viewer));
    room_s.push_back(record.room_s);
  }
  checkFrames(visit, file, options);
  visit.events = world.events;
  if (options.hasStillEyes) standStill(visit, room_s);
}

constexpr double kEyes_m = 1.7, kEyeBeside_m = 0.032;  // of an observer without a room

Head headAtStart(const RoomAxes& axes) { return {{kEyes_m * axes.up, {1.0, 0.0, 0.0, 0.0}}, {}}; }

/// Returns an observer who stands at the start of a game.
Observers observersAtStart(const Scenario& scenario, const RoomAxes& axes) {
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  return {startingRoom(scenario.observer, axes, c_m_s), Event{0.0, scenario.observer.position_m},
          headAtStart(axes)};
}

}  // namespace

VisitFrame frameOf(const FrameRecord& record, std::size_t viewer) {
  return {record.number,        record.display_s, record.viewers[viewer].observer,
          record.boardFromRoom, record.switches,  record.views,
          record.lesson,        record.fade};
}

Visit visitOf(const std::filesystem::path& file, const VisitOptions& options) {
  SessionFile session(file, options.game);
  Visit visit;
  visit.scenario = session.scenario();
  if (!session.frames())
    throw std::runtime_error(fmt::format("session file {}: it ended before its first frame", file.string()));
  checkGame(visit.scenario, file.string());
  const std::size_t viewer = options.as.empty() ? 0 : session.viewerNamed(options.as);
  if (options.as.empty() && session.facts().viewers.size() > 1)
    log::note(
        fmt::format("The page shows the visit of {}; --as chooses another of the {} who shared the room.",
                    session.nameOf(0), session.facts().viewers.size()));
  const Rig rig = readRig(session.facts().rig, session.facts().rigText);
  visit.axes = rig.axes;
  visit.walls = wallsOf(rig, viewer);
  const double separation_m = viewer < rig.viewers.size() ? rig.viewers[viewer].head.eyeSeparation_m : 0.0;
  visit.eyeBesideMiddle_m = 0.5 * separation_m * rig.axes.right;
  visit.atStart = startingHistories(visit.scenario);
  visit.tessellation = tessellationFor(rig, true);
  visit.strokes = session.strokes(visit.scenario.billiard.pucks);
  readFrames(session, viewer, options, file.string(), visit);
  return visit;
}

Visit visitOf(const std::filesystem::path& file, double until_s) {
  constexpr double kFrame_s = 0.05;
  Visit visit;
  visit.scenario = readScenario(file);
  visit.scenario.captions.clear();  // they are told to visitors of the room
  checkGame(visit.scenario, file.string());
  visit.atStart = startingHistories(visit.scenario);
  visit.eyeBesideMiddle_m = kEyeBeside_m * visit.axes.right;
  const Head head = headAtStart(visit.axes);
  Observers observers = observersAtStart(visit.scenario, visit.axes);
  for (double lived_s = 0.0; observers.headEvent().t_s <= until_s && visit.frames.size() < kMostVisitFrames;
       lived_s += kFrame_s) {
    visit.frames.push_back({visit.frames.size(), lived_s, observers.view(2.0 * kEyeBeside_m),
                            observers.boardFromRoom(), Switches{}, TimeViews{}, LessonState{}, 0.0});
    observers.beginFrame();
    observers.step(kFrame_s, head);
  }
  for (const VisitFrame& frame : visit.frames)
    visit.known_s = std::max(visit.known_s, frame.observer.middle.observation.t_s + kFrame_s);
  Billiard billiard(visit.scenario.billiard);
  billiard.advanceTo(visit.known_s);
  VisitChange all;
  for (const Changes::NewKnot& added : billiard.takeChanges().knots)
    all.knots.push_back({kFirstPuck + added.puck, added.knot});
  visit.changes.push_back(std::move(all));
  visit.events.assign(billiard.events().begin(), billiard.events().end());
  return visit;
}

Visit visitToFollow(const Rig& rig, const Scenario& scenario, std::uint64_t game) {
  checkGame(scenario, "follow");
  Visit visit;
  visit.scenario = scenario;
  visit.axes = rig.axes;
  visit.atStart = startingHistories(scenario);
  visit.tessellation = tessellationFor(rig, true);
  const Observers observers = observersAtStart(scenario, rig.axes);
  visit.frames.push_back({0, 0.0, observers.view(2.0 * kEyeBeside_m), observers.boardFromRoom(), Switches{},
                          TimeViews{}, LessonState{}, 0.0});
  visit.live = game;
  return visit;
}

}  // namespace carom
