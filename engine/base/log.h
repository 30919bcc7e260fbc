#pragma once
// How parts of the program speak to the person at the first node.

#include <functional>
#include <string>

namespace carom {

/// Receives one line for the person.
using Say = std::function<void(const std::string&)>;

}  // namespace carom
