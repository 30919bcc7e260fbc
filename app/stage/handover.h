#pragma once
// The input files of a session: rank 0 reads them and hands them to the other nodes, which need none of their
// own.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "cave/cluster/cluster.h"
#include "engine/text/outside_file.h"

namespace carom {

/// A file written by the user: its content on disk or, if `kept` is given, its content when a session was
/// recorded or handed over. The files that it names are looked for below `root` first.
struct InputFile {
  std::filesystem::path file;
  std::optional<std::string> kept;
  std::filesystem::path root{};
};

/// Returns the content. Throws InputError if the file cannot be read.
std::string textOf(const InputFile& input);

Rig readRig(const InputFile& input);
Scenario readScenario(const InputFile& input);

/// Reads the walls' blend images once before a window is opened. Throws InputErrors that give each fault with
/// its line of the rig. Within a budget (cave/process/work_budget.h) warns of those that are too large for
/// it.
void openBlends(const InputFile& input, const Rig& rig);

/// Checks that every node runs the same version of the program. Throws NodesDiffer on every rank, naming the
/// first node that does not.
void agreeOnVersion(const Cluster& cluster);

/// Files that an input names, each with its kind.
using NamedFiles = std::map<std::filesystem::path, InputKind>;

/// Rank 0's files on this rank: in a folder of its own, which goes with this object.
class Handover {
 public:
  explicit Handover(const Cluster& cluster);
  ~Handover();
  Handover(const Handover&) = delete;
  Handover& operator=(const Handover&) = delete;

  /// Returns the rig that `input` is on rank 0, and the files it names. Throws RankFailed on every rank,
  /// after one has logged the reason, if it cannot be read.
  Rig rig(const InputFile& input);
  /// Does the same for a scenario, whose meshes are opened.
  Scenario scenario(const InputFile& input);

 private:
  class Folder;
  InputFile take(const InputFile& input, const NamedFiles& named);
  void keep(const std::filesystem::path& file, const std::string& content);

  const Cluster& cluster_;
  std::unique_ptr<Folder> folder_;  // null if nothing was handed over
};

}  // namespace carom
