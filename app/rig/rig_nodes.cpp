#include "app/rig/rig_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace carom {
namespace {

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view kDigits = "0123456789";

/// Returns whether the text begins with a letter of `first` and has only those of `first` and `rest`.
bool consistsOf(std::string_view text, const std::string& first, const std::string& rest) {
  return !text.empty() && first.find(text[0]) != std::string::npos &&
         text.find_first_not_of(first + rest) == std::string_view::npos;
}

/// Returns the text of a key, which may be absent. Records a fault if it does not consist of these letters.
std::string plainText(const TomlTable& table, const char* key, const std::string& first,
                      const std::string& rest, const char* expected) {
  if (!table.has(key)) return {};
  const std::string text = table.text(key);
  if (!text.empty() && !consistsOf(text, first, rest))
    table.fault(key, fmt::format("{} is '{}', expected {}", key, text, expected));
  return text;
}

/// Reads "47000-47099". Records a fault if it is no range of ports that every user may open.
std::optional<StartSetup::Ports> readPorts(const TomlTable& table) {
  if (!table.has("ports")) return {};
  constexpr int kLowest = 1024, kHighest = 65535, kLeast = 16;
  const std::string text = table.text("ports");
  StartSetup::Ports ports;
  char more = 0;
  const bool isRange = text.find_first_not_of("0123456789-") == std::string::npos &&
                       std::sscanf(text.c_str(), "%5d-%5d%c", &ports.first, &ports.last, &more) == 2;
  if (isRange && ports.first >= kLowest && ports.last <= kHighest && ports.last - ports.first + 1 >= kLeast)
    return ports;
  table.fault("ports",
              fmt::format("ports is '{}', expected a range of {} TCP ports at least, from {} to {}, such as "
                          "'47000-47099'",
                          text, kLeast, kLowest, kHighest));
  return {};
}

}  // namespace

NodeSetup readNode(const TomlTable& table) {
  const std::string names = std::string(kLetters) + std::string(kDigits);
  NodeSetup node{.rank = table.integer("rank"),
                 .display = table.text("display", ""),
                 .host = plainText(table, "host", names, "-._", "a computer's name or IPv4 address"),
                 .slots = table.integer("slots")};
  if (node.display.empty() && node.host.empty())
    table.fault(table.place(), "this node has neither a display nor a host, expected one of them at least");
  return node;
}

StartSetup readStart(const TomlTable& table) {
  const std::string letters(kLetters), digits(kDigits);
  StartSetup start;
  start.network =
      plainText(table, "network", letters + digits, "-._/,", "networks such as '10.0.0.0/24' or 'eth0'");
  start.ports = readPorts(table);
  for (const PlacedText& variable : table.texts("environment")) {
    if (!consistsOf(variable.text.substr(0, variable.text.find('=')), letters + "_", digits))
      table.fault(variable.place,
                  fmt::format("environment has '{}', expected 'NAME=VALUE' or 'NAME'", variable.text));
    start.environment.push_back(variable.text);
  }
  return start;
}

void checkNodes(const std::vector<NodeSetup>& nodes, const std::vector<TomlTable>& tables) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const int low = std::max(nodes[i].rank, nodes[j].rank);
      const int high = std::min(nodes[i].rank + nodes[i].slots, nodes[j].rank + nodes[j].slots);
      if (low >= high) continue;
      tables[i].fault("rank", fmt::format("the rank '{}' is taken in line {}, expected another", low,
                                          tables[j].place("rank").line));
      break;
    }
  }
}

}  // namespace carom
