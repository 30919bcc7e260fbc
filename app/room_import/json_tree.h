#pragma once
// A JSON file as a tree that knows where each value stands. Parsed by nlohmann's event interface.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/input_file.h"

namespace carom {

struct JsonNode {
  enum class Kind { null, flag, whole, number, text, array, object };

  Kind kind = Kind::null;
  FilePlace at{};     ///< of the value's first letter
  std::string key{};  ///< of a member of an object
  FilePlace keyAt{};  ///< of the key's quote
  bool flag = false;
  double number = 0.0;  ///< of `whole` and `number`
  std::string text{};
  std::vector<JsonNode> children{};  ///< elements or members, in the order of the file; keys may repeat

  /// The last member of that key, as most readers take it; null where there is none.
  const JsonNode* member(std::string_view wanted) const;
  /// "an object", "the text 'left'": for messages.
  std::string words() const;
};

/// Throws InputErrors where the file cannot be read, is no JSON, or is nested over 32 deep.
JsonNode readJson(const std::filesystem::path& file);

}  // namespace carom
