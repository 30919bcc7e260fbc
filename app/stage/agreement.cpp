#include "app/stage/agreement.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <utility>

#include "app/files/toml_file.h"
#include "cave/mesh/mesh_buffers.h"
#include "cave/projection/projector.h"

namespace carom {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Checks a mesh and the files that it refers to.
void agreeOnMesh(const Cluster& cluster, const std::optional<std::filesystem::path>& mesh) {
  if (!mesh) return;
  const std::string content = bytesOf(*mesh);
  cluster.agree("mesh " + mesh->filename().string(), content);
  for (const std::filesystem::path& buffer : meshBuffers(*mesh, content)) {
    cluster.agree(fmt::format("buffer {} of mesh {}", buffer.filename().string(), mesh->filename().string()),
                  bytesOf(buffer));
  }
}

}  // namespace

void agreeOnScenario(const Cluster& cluster, const InputFile& input, const Scenario& scenario) {
  cluster.agree("scenario", textOf(input));
  for (const auto& mesh : scenario.puckMeshes) agreeOnMesh(cluster, mesh);
  for (const ScriptedBody& body : scenario.bodies) agreeOnMesh(cluster, body.mesh);
}

void agreeOnRig(const Cluster& cluster, const InputFile& input, const Rig& rig) {
  cluster.agree("rig", textOf(input));
  for (const Wall& wall : rig.walls) {
    for (const auto& [what, file] :
         {std::pair("warp", &wall.warp), std::pair("blend", &wall.blend),
          std::pair("warp_red", &wall.colourWarps[0]), std::pair("warp_green", &wall.colourWarps[1]),
          std::pair("warp_blue", &wall.colourWarps[2])}) {
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

void shareInputs(const Cluster& cluster, InputFile& rig, InputFile& scenario) {
  for (InputFile* input : {&rig, &scenario}) {
    std::string file = input->file.string(), text = input->kept.value_or("");
    cluster.share(file);
    cluster.share(text);
    *input = {file, text};
  }
}

void agreeOnInputs(const Cluster& cluster, const InputFile& rigFile, const Rig& rig,
                   const InputFile& scenarioFile, const Scenario& scenario) {
  if (cluster.size() == 1) return;
  cluster.agree("version of the program", CAROM_VERSION);
  agreeOnRig(cluster, rigFile, rig);
  agreeOnScenario(cluster, scenarioFile, scenario);
}

}  // namespace carom
