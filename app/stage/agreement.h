#pragma once
// Makes sure that the input files of a session are the same on every node.

#include <filesystem>
#include <optional>
#include <string>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "cave/cluster/cluster.h"

namespace carom {

/// A file written by the user: its content on disk or, if `kept` is given, its content when a session was
/// recorded.
struct InputFile {
  std::filesystem::path file;
  std::optional<std::string> kept;
};

/// Returns the content; empty if the file cannot be read.
std::string textOf(const InputFile& input);

/// Sends rank 0's rig and scenario, which it has from a session file, to every node.
void shareInputs(const Cluster& cluster, InputFile& rig, InputFile& scenario);

/// Checks that every node has the same rig, including its projector files. Throws NodesDiffer on every rank
/// if one does not.
void agreeOnRig(const Cluster& cluster, const InputFile& input, const Rig& rig);

/// Reads the walls' blend images once before a window is opened. Throws InputErrors that give each fault with
/// its line of the rig.
void openBlends(const InputFile& input, const Rig& rig);

/// Checks that every node has the same scenario, including its mesh files. Throws NodesDiffer as agreeOnRig
/// does.
void agreeOnScenario(const Cluster& cluster, const InputFile& input, const Scenario& scenario);

/// Checks that every node runs the same program on the same files. Throws NodesDiffer as agreeOnRig does.
void agreeOnInputs(const Cluster& cluster, const InputFile& rigFile, const Rig& rig,
                   const InputFile& scenarioFile, const Scenario& scenario);

}  // namespace carom
