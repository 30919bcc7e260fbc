#pragma once
// The files of a session, which must be the same on every node.

#include <filesystem>
#include <optional>
#include <string>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "cave/cluster/cluster.h"

namespace carom {

/// A file that people wrote, as it is or, where it is given, as it was when a session was recorded.
struct InputFile {
  std::filesystem::path file;
  std::optional<std::string> kept;
};

/// What it holds; empty where it cannot be read.
std::string textOf(const InputFile& input);

/// Gives every node rank 0's rig and scenario, which it has from a session file.
void shareInputs(const Cluster& cluster, InputFile& rig, InputFile& scenario);

/// Makes sure that every node holds the same rig, the files of its projectors included. Throws NodesDiffer on
/// every rank where one does not.
void agreeOnRig(const Cluster& cluster, const InputFile& input, const Rig& rig);

/// Reads the walls' blend pictures once before there is a window; throws InputErrors, which name what is
/// wrong at its line of the rig.
void openBlends(const InputFile& input, const Rig& rig);

/// Makes sure that every node holds the same scenario, the files of its meshes included. Throws NodesDiffer as
/// agreeOnRig does.
void agreeOnScenario(const Cluster& cluster, const InputFile& input, const Scenario& scenario);

/// Makes sure that every node runs the same program on the same files. Throws NodesDiffer as agreeOnRig does.
void agreeOnInputs(const Cluster& cluster, const InputFile& rigFile, const Rig& rig,
                   const InputFile& scenarioFile, const Scenario& scenario);

}  // namespace carom
