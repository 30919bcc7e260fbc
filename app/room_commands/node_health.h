#pragma once
// The findings of `carom doctor` about one node.

#include <string>
#include <utility>
#include <vector>

namespace carom {

/// The facts of a node, and what keeps it from showing a room.
struct NodeHealth {
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<std::string> warnings, errors;

  void add(const char* subject, std::string said) { facts.emplace_back(subject, std::move(said)); }
};

}  // namespace carom
