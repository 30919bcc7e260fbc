#pragma once
// The line of mpirun that starts the nodes of a rig, each on its host.

#include <string>
#include <vector>

#include "app/rig/rig.h"

namespace carom {

/// Returns the host of each node; this machine ("localhost") for all if the rig names none. Throws
/// std::runtime_error if it names hosts for some nodes only, or if other nodes stand between those of one
/// host.
std::vector<std::string> hostsOf(const Rig& rig);

/// Returns the words of the line that runs `program` with `arguments` on every node, in one form for all
/// versions of Open MPI: the mpirun of 5.0.7 crashes where a line has several parts with ":" between them.
std::vector<std::string> mpirunLine(const Rig& rig, const std::string& program,
                                    const std::vector<std::string>& arguments);

/// Returns the words as a line for a shell.
std::string shellLine(const std::vector<std::string>& words);

/// Returns the arguments of carom with which a session of `rig` begins.
std::vector<std::string> startArguments(const std::string& rig, const std::vector<std::string>& arguments);

/// Returns the arguments of carom with which a session goes on that was cut off, in this file.
std::vector<std::string> resumedArguments(const std::vector<std::string>& arguments,
                                          const std::string& session);

/// Returns the arguments with another value of an option, which is added if it is not there.
std::vector<std::string> withValue(std::vector<std::string> arguments, const std::string& option,
                                   const std::string& value);

/// Returns the value of an option, given as "--name VALUE" or "--name=VALUE", or an empty text.
std::string valueOf(const std::vector<std::string>& arguments, const std::string& option);

}  // namespace carom
