#include "app/stage/session_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>

#include "app/nodes/rig_without.h"
#include "app/rig/rig_headset.h"
#include "app/rig/rig_viewers.h"
#include "app/rig/traces.h"
#include "app/scenario/starting_histories.h"
#include "app/stage/all_ranks.h"
#include "app/stage/scenario_scene.h"
#include "app/stage/shared_languages.h"
#include "cave/frame/pacer.h"
#include "cave/overlay/band_layout.h"
#include "cave/scene/kept_light.h"
#include "cave/scene/person_model.h"
#include "cave/scene/table_model.h"
#include "cave/texts/language_names.h"
#include "devices/setup/tracker_factory.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// Swaps empty frames on all nodes together, so that drivers settle and swap groups start. Returns whether
/// swaps wait for the display.
bool warmUp(const Cluster& cluster, const SessionSetup& setup) {
  std::array<double, 12> returned_s{};
  for (double& swap_s : returned_s) {
    cluster.firstFailed(false);  // a barrier
    setup.walls->swap();
    swap_s = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  if (cluster.rank() == 0) {
    log::note(fmt::format("{} empty frames were swapped on every node to warm up.", returned_s.size()));
  }
  return swapsWaitFor(setup.rig.display_hz, returned_s);
}

/// Connects with the headset that the rig describes, whose walls then have the pixels of its displays.
void connectHeadset(const Cluster& cluster, SessionSetup& setup) {
  if (cluster.size() > 1)
    throw std::runtime_error("a headset is drawn by one process, expected none beside it under mpirun");
  setup.headset = std::make_unique<Headset>(*setup.graphics);
  const glm::ivec2 eye_px = setup.headset->pixels();
  fitEyes(setup.rig, eye_px);
  log::note(fmt::format("{}, by {}: {} × {} pixels an eye; {}.", setup.headset->system(),
                        setup.headset->runtime(), eye_px.x, eye_px.y,
                        setup.headset->hasFloor()
                            ? "it knows where the floor is"
                            : "it knows no floor, which is taken to be 1.7 m below the eyes"));
  if (!setup.headset->takesEncoded())
    log::warn("the headset's runtime takes no sRGB pictures: it may show them too bright.");
}

/// Puts heads and wands for mouse and keys in the place of everybody's trackers, which are then not opened.
void putMouseInPlaceOfTrackers(Rig& rig) {
  if (isHeadset(rig))
    throw std::runtime_error("--by-mouse: this rig is a headset, expected one with walls in a room");
  TrackerSetup tracker;
  tracker.name = "mouse and keys";
  rig.trackers = {tracker};
  rig.byMouse = true;
  int sensor = 0;
  for (ViewerSetup& viewer : rig.viewers) {
    viewer.head.sensor = {.tracker = 0, .sensor = sensor++};
    viewer.head.eyesFromSensor = {};
    viewer.hand = HandSetup{{.tracker = 0, .sensor = sensor++}, {}};
  }
}

/// Makes the game what this session wants: the drive no faster than the room allows, too, and a lesson's
/// right answer hidden; without buttons for other games in a study.
void adaptGame(SessionSetup& setup) {
  setup.scenario.choices = setup.scenario.choices && setup.mayLeave;
  setup.scenario.most_u = std::min(setup.scenario.most_u, setup.rig.comfort.most_u);
  if (!setup.hideRight || !setup.scenario.lesson) return;
  LessonWords& words = setup.scenario.lesson->words;
  words.right = words.answers.size();
}

/// Builds the scenario's scene on every rank. Rank 0 bakes its light and hands it to those with the same
/// scene.
void buildLitScene(const Cluster& cluster, SessionSetup& setup) {
  std::string light;
  onAllRanks(cluster, [&] {
    setup.scene = sceneOf(setup.scenario, setup.tessellation);
    if (setup.people) addPeople(setup.scene);
    if (cluster.rank() > 0) return;
    lightScene(setup.scene, folderOfLight());
    light = lightOf(setup.scene);
  });
  cluster.share(light);
  onAllRanks(cluster, [&] {
    if (cluster.rank() > 0 && !setLight(setup.scene, light)) lightScene(setup.scene, folderOfLight());
  });
}

/// Gives the lesson and the choices to the walls; the lesson is empty if there is none. On rank 0, warns of
/// texts that are too long for the front wall.
void setTexts(const Scenario& scenario, const Rig& rig, bool mayLeave, const Cluster& cluster,
              DisplayWalls& walls) {
  const Lesson lesson = scenario.lesson.value_or(Lesson{});
  walls.overlays().setLesson(lesson.words, lesson.plan, mayLeave);
  walls.overlays().setOffers(offersOf(scenario));
  const std::optional<Wall> front = frontWall(roomGeometryOf(rig));
  if (!scenario.lesson || cluster.rank() > 0 || !front) return;
  if (bandHolds(lesson.words, lesson.plan, *front)) return;
  log::warn(
      fmt::format("The texts of the lesson \"{}\" are too long for the wall {}: their letters will be "
                  "lower than 1/40 of it.",
                  scenario.title, front->name));
}

/// Returns the table for the spectator view.
std::vector<ScenePart> plainTable(const Scenario& scenario) {
  if (!scenario.billiard.board) return {};
  return tableParts(*scenario.billiard.board, scenario.observer.position_m.z);
}

/// Settles where the windows of rank 0 open: where they lay last, in a session that somebody watches.
void placeAll(const Cluster& cluster, const SetupOptions& options, SessionSetup& setup) {
  std::vector<RememberedWindow> remembered;
  if (!options.simulated) {
    for (const Wall& wall : setup.rig.walls) setup.wallMemory.push_back(memoryName(wall));
    remembered = readWindowMemory(windowMemory());
  }
  const std::vector<Monitor> present = monitors();
  setup.desk = placeWindows(setup.rig, cluster.wallsOf(setup.rig.walls), options.extra, remembered, present,
                            workAreas(present));
}

/// Returns the languages' own names.
std::vector<std::string> ownNamesOf(const std::vector<std::string>& languages) {
  std::vector<std::string> names;
  for (const std::string& language : languages) names.push_back(texts::ownNameOf(language));
  return names;
}

}  // namespace

SessionSetup setUpSession(Cluster& cluster, const SetupOptions& options) {
  SessionSetup setup;
  agreeOnVersion(cluster);
  Handover files(cluster);
  setup.rig = files.rig(options.rig);
  onAllRanks(cluster, [&] { setup.rig = rigWithout(std::move(setup.rig), options.withoutNodes); });
  if (options.onlyFor) setup.rig = rigFor(std::move(setup.rig), *options.onlyFor);
  if (options.sky) onAllRanks(cluster, [&] { setup.rig = withSky(std::move(setup.rig), *options.sky); });
  if (options.byMouse) onAllRanks(cluster, [&] { putMouseInPlaceOfTrackers(setup.rig); });
  for (Wall& wall : setup.rig.walls) wall.textSize = options.textSize;
  if (setup.rig.panel) setup.rig.panel->textSize = options.textSize;
  setup.scenario = files.scenario(options.scenario);
  setup.hideRight = options.hideRight;
  setup.mayLeave = options.mayLeave;
  std::string people = options.people ? "people" : "";
  cluster.share(people);
  setup.people = !people.empty();
  const std::array games{options.scenario.file.string()};
  setup.languages = shareLanguages(cluster, options.languages, games);
  const texts::InLanguage named(texts::ofSession(options.languages.atStart.front()));  // windows and bands
  adaptGame(setup);
  onAllRanks(cluster, [&] {
    if (options.live && cluster.rank() == 0) openTraces(setup.rig);
  });
  cluster.nameNodes(setup.rig.walls);
  onAllRanks(cluster, [&] {
    setup.graphics = std::make_unique<Graphics>(displayOf(setup.rig, cluster.rank()));
    if (isHeadset(setup.rig) && options.live) connectHeadset(cluster, setup);
    if (isHeadset(setup.rig) && options.eye_px.x > 0) fitEyes(setup.rig, options.eye_px);
    if (options.noWindow) return;
    checkMonitors(cluster.wallsOf(setup.rig.walls), setup.rig.oneWindow);
    if (cluster.rank() == 0) placeAll(cluster, options, setup);
  });
  setup.tessellation = tessellationFor(setup.rig, setup.graphics->inSoftware());
  buildLitScene(cluster, setup);
  onAllRanks(cluster, [&] {
    setup.walls = std::make_unique<DisplayWalls>(
        *setup.graphics, setup.scene, setup.scenario.billiard.lightSpeed_m_s,
        cluster.wallsOf(setup.rig.walls), setup.rig.oneWindow, !options.noWindow);
    setup.walls->setRoom(roomGeometryOf(setup.rig));
    setup.walls->overlays().setLanguages(ownNamesOf(setup.languages));
    setTexts(setup.scenario, setup.rig, setup.mayLeave, cluster, *setup.walls);
    if (options.extra.outside && cluster.rank() == 0) {
      setup.outside = std::make_unique<SpectatorView>(*setup.graphics, roomGeometryOf(setup.rig), setup.scene,
                                                      plainTable(setup.scenario), setup.desk.outside);
    }
  });
  const bool tracked =
      std::any_of(setup.rig.viewers.begin(), setup.rig.viewers.end(), [&](const ViewerSetup& viewer) {
        return isDevice(setup.rig.trackers[viewer.head.sensor.tracker].kind);
      });
  setup.realTime = !options.simulated || (options.live && (tracked || options.byMouse));
  onAllRanks(cluster, [&] {
    setup.recording =
        std::make_unique<Recording>(*setup.graphics, options.recording, cluster, setup.rig, setup.realTime);
  });
  setup.lock = setup.walls->lockSwaps(setup.rig.frameLock);
  if (!setup.lock.whyNot().empty()) {
    log::warn(
        fmt::format("{}: frame_lock = \"swap-group\": {}; the nodes' messages alone hold the swaps together.",
                    cluster.nameOf(cluster.rank()), setup.lock.whyNot()));
  }
  if (setup.realTime && !options.noWindow) {
    setup.swapsWait = warmUp(cluster, setup);
    setup.walls->sayStarting();
  }
  for (const std::string& window : setup.walls->misplaced())
    log::warn(fmt::format("{}: {}", cluster.nameOf(cluster.rank()), window));
  setup.world = {historiesAtStart(setup), {}};
  return setup;
}

bool playNext(Cluster& cluster, SessionSetup& setup, const InputFile& file) {
  Handover files(cluster);
  try {
    setup.scenario = files.scenario(file);
    adaptGame(setup);
  } catch (const RankFailed&) {
    return false;  // the error has been logged
  }
  buildLitScene(cluster, setup);
  onAllRanks(cluster, [&] {
    setup.walls->setScene(setup.scene, setup.scenario.billiard.lightSpeed_m_s);
    setTexts(setup.scenario, setup.rig, setup.mayLeave, cluster, *setup.walls);
    if (setup.outside) setup.outside->setScene(setup.scene, plainTable(setup.scenario));
  });
  setup.world = {historiesAtStart(setup), {}};
  return true;
}

std::vector<WorldLine> historiesAtStart(const SessionSetup& setup) {
  return reachingTo(startingHistories(setup.scenario), setup.scene.reach_m);
}

}  // namespace carom
