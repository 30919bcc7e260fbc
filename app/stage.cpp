#include "app/stage.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "app/game.h"
#include "app/scenario_scene.h"
#include "app/toml_file.h"
#include "app/traces.h"

namespace carom {
namespace {

/// What to tell the person; names the node where it is not the one they sit at.
std::string messageOf(const Cluster& cluster, const std::exception& error) {
  const std::string node = cluster.rank() == 0 ? "" : " (node " + std::to_string(cluster.rank()) + ")";
  const auto* input = dynamic_cast<const InputErrors*>(&error);
  if (!input) return std::string("error: ") + error.what() + node;
  std::string lines;
  for (const InputError& fault : input->faults()) {
    lines += (lines.empty() ? "error: " : "\nerror: ") + std::string(fault.what()) + node;
  }
  return lines;
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Every node runs the same program on the same files; throws on every rank where one does not.
void agreeOnInputs(const Cluster& cluster, const StageOptions& options, const Scenario& scenario) {
  if (cluster.size() == 1) return;
  cluster.agree("version of the program", CAROM_VERSION);
  cluster.agree("rig", textOf(options.rig));
  cluster.agree("scenario", textOf(options.scenario));
  const auto agreeOnMesh = [&](const std::optional<std::filesystem::path>& mesh) {
    if (mesh) cluster.agree("mesh " + mesh->filename().string(), bytesOf(*mesh));
  };
  for (const auto& mesh : scenario.puckMeshes) agreeOnMesh(mesh);
  for (const ToldBody& body : scenario.bodies) agreeOnMesh(body.mesh);
}

}  // namespace

std::vector<Wall> wallsOf(const Rig& rig, const Cluster& cluster) {
  std::vector<Wall> walls;
  for (const Wall& wall : rig.walls) {
    if (cluster.draws(wall)) walls.push_back(wall);
  }
  return walls;
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

std::string displayOf(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (node.rank == rank) return node.display;
  }
  return {};
}

void makeFolder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw std::runtime_error(fmt::format("--capture {}: {}, expected a folder or a name for one",
                                         folder.string(), failed.message()));
  }
}

/// Runs `step` on every rank; if it fails on any, the lowest such rank says why and the session ends
/// everywhere.
void together(const Cluster& cluster, const std::function<void()>& step) {
  std::string message;
  try {
    step();
  } catch (const std::exception& error) {
    message = messageOf(cluster, error);
  }
  const int failed = cluster.firstFailed(!message.empty());
  if (failed < 0) return;
  if (failed == cluster.rank()) std::fprintf(stderr, "%s\n", message.c_str());
  throw RankFailed{};
}

int runOnCluster(const std::function<void(Cluster&)>& session) {
  Cluster cluster;
  try {
    session(cluster);
    return 0;
  } catch (const RankFailed&) {
    return 1;
  } catch (const NodesDiffer& error) {
    if (cluster.rank() == 0) std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", messageOf(cluster, error).c_str());
    if (cluster.size() > 1) cluster.abort();
    return 1;
  }
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

Stage openStage(Cluster& cluster, const StageOptions& options) {
  Stage stage;
  together(cluster, [&] {
    const auto& [rig, rigKept] = options.rig;
    const auto& [scenario, scenarioKept] = options.scenario;
    stage.rig = rigKept ? readRig(rig, *rigKept) : readRig(rig);
    stage.scenario = scenarioKept ? readScenario(scenario, *scenarioKept) : readScenario(scenario);
    openMeshes(stage.scenario);
    openBlends(options.rig, stage.rig);
    if (options.live && cluster.rank() == 0) openTraces(stage.rig);
  });
  agreeOnInputs(cluster, options, stage.scenario);
  cluster.nameNodes(stage.rig.walls);
  together(cluster, [&] {
    stage.graphics = std::make_unique<Graphics>(displayOf(stage.rig, cluster.rank()));
    stage.tessellation = tessellationFor(stage.rig, stage.graphics->rendererName());
    stage.scene = sceneOf(stage.scenario, stage.tessellation);
    stage.walls =
        std::make_unique<WallSet>(*stage.graphics, stage.scene, stage.scenario.billiard.lightSpeed_m_s,
                                  wallsOf(stage.rig, cluster), stage.rig.oneWindow, !options.noWindow);
  });
  together(cluster, [&] {
    if (options.capture) makeFolder(*options.capture);
  });
  stage.histories = reachingTo(startingHistories(stage.scenario), stage.scene.reach_m);
  return stage;
}

}  // namespace carom
