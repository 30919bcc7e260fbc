#include "app/stage/stage.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <fstream>
#include <stdexcept>

#include "app/files/starting_histories.h"
#include "app/files/toml_file.h"
#include "app/files/traces.h"
#include "app/stage/all_ranks.h"
#include "app/stage/scenario_scene.h"
#include "cave/frame/pacer.h"
#include "cave/mesh/mesh_buffers.h"
#include "cave/scene/table_model.h"
#include "devices/setup/tracker_factory.h"
#include "engine/base/log.h"

namespace carom {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A mesh and the files that it needs beside itself.
void agreeOnMesh(const Cluster& cluster, const std::optional<std::filesystem::path>& mesh) {
  if (!mesh) return;
  const std::string content = bytesOf(*mesh);
  cluster.agree("mesh " + mesh->filename().string(), content);
  for (const std::filesystem::path& buffer : meshBuffers(*mesh, content)) {
    cluster.agree(fmt::format("buffer {} of mesh {}", buffer.filename().string(), mesh->filename().string()),
                  bytesOf(buffer));
  }
}

void agreeOnScenario(const Cluster& cluster, const InputFile& input, const Scenario& scenario) {
  cluster.agree("scenario", textOf(input));
  for (const auto& mesh : scenario.puckMeshes) agreeOnMesh(cluster, mesh);
  for (const ScriptedBody& body : scenario.bodies) agreeOnMesh(cluster, body.mesh);
}

/// Every node runs the same program on the same files; throws on every rank where one does not.
void agreeOnInputs(const Cluster& cluster, const StageOptions& options, const Rig& rig,
                   const Scenario& scenario) {
  if (cluster.size() == 1) return;
  cluster.agree("version of the program", CAROM_VERSION);
  agreeOnRig(cluster, options.rig, rig);
  agreeOnScenario(cluster, options.scenario, scenario);
}

}  // namespace

void agreeOnRig(const Cluster& cluster, const InputFile& input, const Rig& rig) {
  cluster.agree("rig", textOf(input));
  for (const Wall& wall : rig.walls) {
    for (const auto& [what, file] : {std::pair("warp", &wall.warp), std::pair("blend", &wall.blend)}) {
      if (file->empty()) continue;
      cluster.agree(fmt::format("{} {} of wall '{}'", what, file->filename().string(), wall.name),
                    bytesOf(*file));
    }
  }
}

void openBlends(const InputFile& input, const Rig& rig) {
  std::vector<InputError> faults;
  for (std::size_t i = 0; i < rig.walls.size(); ++i) {
    if (rig.walls[i].blend.empty()) continue;
    try {
      readBlend(rig.walls[i].blend);
    } catch (const std::runtime_error& error) {
      const FilePlace at = input.kept ? FilePlace{} : readPlacedRig(input.file).walls[i].blend;
      faults.emplace_back(input.file.string(), at.line, at.column, error.what());
    }
  }
  if (!faults.empty()) throw InputErrors(std::move(faults));
}

std::string textOf(const InputFile& input) { return input.kept ? *input.kept : bytesOf(input.file); }

void shareInputs(const Cluster& cluster, StageOptions& options) {
  for (InputFile* input : {&options.rig, &options.scenario}) {
    std::string file = input->file.string(), text = input->kept.value_or("");
    cluster.share(file);
    cluster.share(text);
    *input = {file, text};
  }
}

namespace {

/// Swaps of nothing, on all nodes together: drivers settle, swap groups begin. Whether swaps wait for the
/// display.
bool warmUp(const Cluster& cluster, const Stage& stage) {
  std::array<double, 12> returned_s{};
  for (double& swap_s : returned_s) {
    cluster.firstFailed(false);  // all are here
    stage.walls->swap();
    swap_s = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  if (cluster.rank() == 0) {
    log::note(fmt::format("{} empty frames were swapped on every node to warm up.", returned_s.size()));
  }
  return swapsWaitFor(stage.rig.display_hz, returned_s);
}

/// What the walls say of a lesson; nothing where there is none.
LessonWords lessonWords(const Scenario& scenario) {
  return scenario.lesson ? scenario.lesson->words : LessonWords{};
}

/// For the view from outside: coarse, for nothing bends there.
std::vector<ScenePart> plainTable(const Scenario& scenario) {
  constexpr double kCell_m = 0.05;
  if (!scenario.billiard.board) return {};
  return tableParts(*scenario.billiard.board, scenario.observer.position_m.z, kCell_m);
}

}  // namespace

Stage openStage(Cluster& cluster, const StageOptions& options) {
  Stage stage;
  onAllRanks(cluster, [&] {
    const auto& [rig, rigKept] = options.rig;
    const auto& [scenario, scenarioKept] = options.scenario;
    stage.rig = rigKept ? readRig(rig, *rigKept) : readRig(rig);
    stage.scenario = scenarioKept ? readScenario(scenario, *scenarioKept) : readScenario(scenario);
    openMeshes(stage.scenario);
    openBlends(options.rig, stage.rig);
    if (options.live && cluster.rank() == 0) openTraces(stage.rig);
  });
  agreeOnInputs(cluster, options, stage.rig, stage.scenario);
  cluster.nameNodes(stage.rig.walls);
  onAllRanks(cluster, [&] {
    stage.graphics = std::make_unique<Graphics>(displayOf(stage.rig, cluster.rank()));
    stage.tessellation = tessellationFor(stage.rig, stage.graphics->rendererName());
    stage.scene = sceneOf(stage.scenario, stage.tessellation);
    stage.walls = std::make_unique<DisplayWalls>(
        *stage.graphics, stage.scene, stage.scenario.billiard.lightSpeed_m_s,
        cluster.wallsOf(stage.rig.walls), stage.rig.oneWindow, !options.noWindow);
    stage.walls->setRoom(roomGeometryOf(stage.rig));
    stage.walls->setLesson(lessonWords(stage.scenario));
    if (options.outside && cluster.rank() == 0) {
      stage.outside = std::make_unique<SpectatorView>(*stage.graphics, roomGeometryOf(stage.rig), stage.scene,
                                                      plainTable(stage.scenario), !options.noWindow);
    }
  });
  stage.realTime = !options.simulated ||
                   (options.live && isDevice(stage.rig.trackers[stage.rig.head.sensor.tracker].kind));
  onAllRanks(cluster, [&] {
    stage.recording =
        std::make_unique<Recording>(*stage.graphics, options.recording, cluster, stage.rig, stage.realTime);
  });
  stage.lock = stage.walls->lockSwaps(stage.rig.frameLock);
  if (!stage.lock.whyNot().empty()) {
    log::warn(
        fmt::format("{}: frame_lock = \"swap-group\": {}; the nodes' messages alone hold the swaps "
                    "together.",
                    cluster.nameOf(cluster.rank()), stage.lock.whyNot()));
  }
  if (stage.realTime && !options.noWindow) stage.swapsWait = warmUp(cluster, stage);
  stage.world = {historiesAtStart(stage), {}};
  return stage;
}

bool playNext(Cluster& cluster, Stage& stage, const std::filesystem::path& file) {
  Scenario next;
  try {
    onAllRanks(cluster, [&] {
      next = readScenario(file);
      openMeshes(next);
    });
    agreeOnScenario(cluster, {file, {}}, next);
  } catch (const RankFailed&) {
    return false;  // which has been said
  } catch (const NodesDiffer& error) {
    if (cluster.rank() == 0) log::error(error.what());
    return false;
  }
  stage.scenario = std::move(next);
  onAllRanks(cluster, [&] {
    stage.scene = sceneOf(stage.scenario, stage.tessellation);
    stage.walls->setScene(stage.scene, stage.scenario.billiard.lightSpeed_m_s);
    stage.walls->setLesson(lessonWords(stage.scenario));
    if (stage.outside) stage.outside->setScene(stage.scene, plainTable(stage.scenario));
  });
  stage.world = {historiesAtStart(stage), {}};
  return true;
}

std::vector<WorldLine> historiesAtStart(const Stage& stage) {
  return reachingTo(startingHistories(stage.scenario), stage.scene.reach_m);
}

}  // namespace carom
