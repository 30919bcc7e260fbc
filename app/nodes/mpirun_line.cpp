#include "app/nodes/mpirun_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace carom {
namespace {

const NodeSetup* nodeOf(const Rig& rig, int rank) {
  const auto found = std::find_if(rig.nodes.begin(), rig.nodes.end(), [&](const NodeSetup& node) {
    return rank >= node.rank && rank < node.rank + node.slots;
  });
  return found == rig.nodes.end() ? nullptr : &*found;
}

bool isOption(const std::string& argument, std::string_view option) {
  return argument == option || argument.starts_with(fmt::format("{}=", option));
}

}  // namespace

std::vector<std::string> hostsOf(const Rig& rig) {
  std::vector<std::string> hosts;
  std::string missing, twice;
  bool named = false;
  for (int rank = 0; rank < nodesOf(rig); ++rank) {
    const NodeSetup* node = nodeOf(rig, rank);
    const bool hasHost = node && !node->host.empty();
    const std::string host = hasHost ? node->host : "localhost";
    if (twice.empty() && !hosts.empty() && hosts.back() != host &&
        std::find(hosts.begin(), hosts.end(), host) != hosts.end()) {
      twice = fmt::format(
          "node {} of the rig is on host {} again, expected the nodes of one host to follow each other", rank,
          host);
    }
    hosts.push_back(host);
    named = named || hasHost;
    if (!hasHost) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", rank);
  }
  if (named && !missing.empty()) {
    throw std::runtime_error(fmt::format(
        "node {} of the rig has no host though others have, expected a [[node]] with rank and host "
        "for each of nodes 0 to {}",
        missing, nodesOf(rig) - 1));
  }
  if (!twice.empty()) throw std::runtime_error(twice);
  return hosts;
}

std::vector<std::string> mpirunLine(const Rig& rig, const std::string& program,
                                    const std::vector<std::string>& arguments) {
  const std::vector<std::string> hosts = hostsOf(rig);
  std::string slots;  // "cave-front:1,cave-sides:2"
  for (std::size_t first = 0, end = 0; first < hosts.size(); first = end) {
    while (end < hosts.size() && hosts[end] == hosts[first]) ++end;
    slots += fmt::format("{}{}:{}", first == 0 ? "" : ",", hosts[first], end - first);
  }
  // By slot: rank i is node i. The program itself uses every core (cave/cluster/cluster.h).
  std::vector<std::string> words{
      "mpirun", "-n", std::to_string(hosts.size()), "--host", slots, "--map-by", "slot", "--bind-to", "none"};
  if (!rig.start.network.empty()) {
    for (const char* channel : {"btl_tcp_if_include", "oob_tcp_if_include"})
      words.insert(words.end(), {"--mca", channel, rig.start.network});
  }
  if (const auto& ports = rig.start.ports) {
    // Open MPI's daemons take all ports that they may have, so the nodes have ports of their own. Over IPv6
    // the daemons do not talk.
    const int daemons = std::max(4, (ports->last - ports->first + 1) / 10);
    const std::string first = std::to_string(ports->first + daemons),
                      count = std::to_string(ports->last - ports->first + 1 - daemons);
    for (const auto& [parameter, value] :
         {std::pair("oob_tcp_dynamic_ipv4_ports",
                    fmt::format("{}-{}", ports->first, ports->first + daemons - 1)),
          {"btl_tcp_port_min_v4", first},
          {"btl_tcp_port_range_v4", count},
          {"btl_tcp_port_min_v6", first},
          {"btl_tcp_port_range_v6", count}})
      words.insert(words.end(), {"--mca", parameter, value});
  }
  for (const std::string& variable : rig.start.environment) words.insert(words.end(), {"-x", variable});
  words.push_back(program);
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

std::string shellLine(const std::vector<std::string>& words) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=./:,@%+";
  std::string line;
  for (const std::string& word : words) {
    std::string quoted = word;
    if (word.empty() || word.find_first_not_of(kPlain) != std::string::npos) {
      quoted = "'";
      for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
      quoted += "'";
    }
    line += (line.empty() ? "" : " ") + quoted;
  }
  return line;
}

std::string valueOf(const std::vector<std::string>& arguments, const std::string& option) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == option) return i + 1 < arguments.size() ? arguments[i + 1] : "";
    if (isOption(arguments[i], option)) return arguments[i].substr(option.size() + 1);
  }
  return {};
}

std::vector<std::string> startArguments(const std::string& rig, const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"cave", "--rig", rig};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

std::vector<std::string> withValue(std::vector<std::string> arguments, const std::string& option,
                                   const std::string& value) {
  const auto found = std::find_if(arguments.begin(), arguments.end(),
                                  [&](const std::string& argument) { return isOption(argument, option); });
  if (found == arguments.end()) {
    arguments.insert(arguments.end(), {option, value});
  } else if (*found != option) {
    *found = fmt::format("{}={}", option, value);
  } else if (found + 1 != arguments.end()) {
    *(found + 1) = value;
  }
  return arguments;
}

std::vector<std::string> resumedArguments(const std::vector<std::string>& arguments,
                                          const std::string& session) {
  std::vector<std::string> all{"cave"};
  for (const std::string& argument : withValue(arguments, "--session", session)) {
    if (argument != "--resume" && argument != "--resume-or-new") all.push_back(argument);
  }
  all.push_back("--resume");
  return all;
}

}  // namespace carom
