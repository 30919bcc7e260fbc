#pragma once
// The other computers of a room are asked by ssh whether they can take part.

#include <atomic>
#include <string>
#include <vector>

namespace carom {

/// Why a host cannot take part.
struct HostFault {
  std::string host;
  std::string words;      ///< a whole sentence
  bool isSilent = false;  ///< it does not answer; otherwise it has another version of the program, or none
};

/// The time that a host has to answer with its version, from the start of ssh.
inline constexpr double kHostAnswers_s = 15.0;

/// Returns whether a rig's host is this computer.
bool isThisComputer(const std::string& host);

/// Asks all other hosts at once, each once, whether `program` is there in this version. Returns why those
/// cannot that cannot, after `limit_s` at the latest; nothing once `cancelled`.
std::vector<HostFault> askHosts(const std::vector<std::string>& hosts, const std::string& program,
                                const std::atomic<bool>& cancelled, double limit_s = kHostAnswers_s);

}  // namespace carom
