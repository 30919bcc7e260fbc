#include "app/stage/handover.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

#include "app/stage/all_ranks.h"
#include "app/stage/scenario_scene.h"
#include "app/toml/toml_file.h"
#include "cave/mesh_input/mesh_buffers.h"
#include "cave/process/subprocess.h"
#include "cave/process/termination.h"
#include "cave/process/work_budget.h"
#include "cave/projection/projector.h"
#include "cave/screen/curved_screen.h"
#include "engine/text/log.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// Returns the files that a rig names: projectors' meshes and pictures, measured screens, recorded traces.
NamedFiles filesOf(const Rig& rig) {
  NamedFiles files;
  for (const Wall& wall : rig.walls) {
    for (const fs::path* file :
         {&wall.warp, &wall.blend, &wall.colourWarps[0], &wall.colourWarps[1], &wall.colourWarps[2]}) {
      const InputKind usual = file == &wall.blend ? InputKind::blend : InputKind::warp;
      if (!file->empty()) files.emplace(*file, file->extension() == ".vwf" ? InputKind::screenGrid : usual);
    }
    if (!wall.screen) continue;
    if (const auto* measured = std::get_if<MeasuredScreen>(&wall.screen->shape))
      files.emplace(measured->file, measured->isGrid ? InputKind::screenGrid : InputKind::screenMesh);
  }
  for (const TrackerSetup& tracker : rig.trackers) {
    if (tracker.kind == TrackerKind::recorded) files.emplace(tracker.source, InputKind::trace);
  }
  return files;
}

/// Returns the files that a scenario names: meshes, and the buffers and pictures that these name. All have
/// been opened by the meshes' reader.
NamedFiles filesOf(const Scenario& scenario) {
  NamedFiles files;
  const auto add = [&](const std::optional<fs::path>& mesh) {
    if (!mesh || !files.emplace(*mesh, InputKind::mesh).second) return;  // many pucks may share a mesh
    for (const fs::path& part : meshParts(*mesh, contentOf(*mesh, InputKind::mesh)))
      files.emplace(part, InputKind::meshPart);
  };
  for (const auto& mesh : scenario.puckMeshes)
    if (mesh) add(mesh->file);
  for (const ScriptedBody& body : scenario.bodies) add(body.mesh);
  return files;
}

}  // namespace

std::string textOf(const InputFile& input) {
  return input.kept ? *input.kept : contentOf(input.file, InputKind::toml);
}

Rig readRig(const InputFile& input) {
  return input.kept ? readRig(input.file, *input.kept, input.root) : readRig(input.file);
}

Scenario readScenario(const InputFile& input) {
  return input.kept ? readScenario(input.file, *input.kept, input.root) : readScenario(input.file);
}

void openBlends(const InputFile& input, const Rig& rig) {
  std::vector<InputError> faults;
  std::set<fs::path> opened;
  for (std::size_t i = 0; i < rig.walls.size(); ++i) {
    const fs::path& blend = rig.walls[i].blend;
    if (blend.empty() || !opened.insert(blend).second) continue;
    try {
      readBlend(blend);
    } catch (const JobTooLarge&) {
      if (!hasBudget()) throw;
      log::warn(
          fmt::format("{}:1:1: is a large picture and was not read here: whether it is whole is not known",
                      blend.string()));
    } catch (const std::runtime_error& error) {
      const FilePlace at = input.kept ? FilePlace{} : readPlacedRig(input.file).walls[i].blend;
      faults.emplace_back(input.file.string(), at.line, at.column, error.what());
    }
  }
  if (!faults.empty()) throw InputErrors(std::move(faults));
}

void agreeOnVersion(const Cluster& cluster) { cluster.agree("version of the program", CAROM_VERSION); }

/// A folder that goes with this object, or when the process is ended from outside. Its process holds a lock
/// on it; the folder of a process that was killed has none, and the next one removes it.
class Handover::Folder {
 public:
  Folder() {
    removeOfTheDead();
    for (;;) {
      path_ = newFolder();
      lock_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      flock(lock_, LOCK_EX);  // where /tmp knows no locks, no other process removes the folder either
      if (fs::exists(path_)) break;
      if (lock_ >= 0) close(lock_);  // another process removed it before it was locked
    }
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    remove();
    close(lock_);
  }

  const fs::path& path() const { return path_; }

 private:
  static constexpr std::string_view kName = "carom-files-";

  static fs::path newFolder() {
    std::string name = fs::temp_directory_path() / fmt::format("{}XXXXXX", kName);
    if (mkdtemp(name.data())) return name;
    throw std::runtime_error(
        fmt::format("no folder for files of node 0: {}: {}", name, std::strerror(errno)));
  }
  static void removeOfTheDead() {
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::temp_directory_path(), failed)) {
      if (!entry.path().filename().string().starts_with(kName)) continue;
      const int lock = open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (lock < 0) continue;
      if (flock(lock, LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry.path(), failed);
      close(lock);
    }
  }
  void remove() const {
    std::error_code failed;
    fs::remove_all(path_, failed);
  }

  fs::path path_;
  int lock_ = -1;
  ClosedOnLeaving onLeaving_{[this] { remove(); }};
};

Handover::Handover(const Cluster& cluster) : cluster_(cluster) {}
Handover::~Handover() = default;

Rig Handover::rig(const InputFile& input) {
  Rig rig;
  NamedFiles named;
  onAllRanks(cluster_, [&] {
    if (cluster_.rank() > 0) return;
    rig = readRig(input);
    openBlends(input, rig);
    named = filesOf(rig);
  });
  const InputFile taken = take(input, named);
  onAllRanks(cluster_, [&] {
    if (cluster_.rank() > 0) rig = readRig(taken);
  });
  return rig;
}

Scenario Handover::scenario(const InputFile& input) {
  Scenario scenario;
  NamedFiles named;
  onAllRanks(cluster_, [&] {
    if (cluster_.rank() > 0) return;
    scenario = readScenario(input);
    openMeshes(scenario);
    if (cluster_.size() > 1) named = filesOf(scenario);
  });
  const InputFile taken = take(input, named);
  onAllRanks(cluster_, [&] {
    if (cluster_.rank() == 0) return;
    scenario = readScenario(taken);
    openMeshes(scenario);
  });
  return scenario;
}

/// Sends rank 0's input and the files that it names to all ranks. Each lies at its path on rank 0, below a
/// folder, so that files find each other as they do there.
InputFile Handover::take(const InputFile& input, const NamedFiles& named) {
  if (cluster_.size() == 1) return input;
  const bool gives = cluster_.rank() == 0;
  std::string file, text, count = std::to_string(named.size());
  std::vector<std::pair<std::string, std::string>> files;
  onAllRanks(cluster_, [&] {
    if (!gives) return;
    file = fs::absolute(input.file).string();
    text = textOf(input);
    for (const auto& [name, kind] : named)
      files.emplace_back(fs::absolute(name).lexically_normal().string(), contentOf(name, kind));
  });
  cluster_.share(file);
  cluster_.share(text);
  cluster_.share(count);
  files.resize(std::stoul(count));
  for (auto& [name, content] : files) {
    cluster_.share(name);
    cluster_.share(content);
  }
  onAllRanks(cluster_, [&] {
    if (gives) return;
    for (const auto& [name, content] : files) keep(name, content);
  });
  return gives ? input : InputFile{file, text, folder_ ? folder_->path() : fs::path()};
}

/// Writes a file of rank 0's into the folder.
void Handover::keep(const fs::path& file, const std::string& content) {
  if (!folder_) folder_ = std::make_unique<Folder>();
  const fs::path place = folder_->path() / file.relative_path();
  fs::create_directories(place.parent_path());
  std::ofstream out(place, std::ios::binary);
  out << content << std::flush;
  if (!out)
    throw std::runtime_error(
        fmt::format("{} cannot be written, expected room for files of node 0", place.string()));
}

}  // namespace carom
