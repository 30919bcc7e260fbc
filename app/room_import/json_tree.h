#pragma once
// A JSON file as a tree with the position of each value. Parsed by nlohmann's event interface.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/toml/input_file.h"

namespace carom {

struct JsonNode {
  enum class Kind { null, flag, whole, number, text, array, object };

  Kind kind = Kind::null;
  FilePlace at{};     ///< position of the value's first character
  std::string key{};  ///< key, for a member of an object
  FilePlace keyAt{};  ///< position of the key's quote
  bool flag = false;
  double number = 0.0;  ///< for `whole` and `number`
  std::string text{};
  std::vector<JsonNode> children{};  ///< elements or members in the order of the file; keys may repeat

  /// Returns the last member with that key, as most readers do, or null if there is none.
  const JsonNode* member(std::string_view wanted) const;
  /// Returns a description for messages: "an object", "the text 'left'".
  std::string words() const;
};

/// Throws InputErrors if the file cannot be read, is not JSON, is nested over 32 levels deep or has
/// over 100 000 values.
JsonNode readJson(const std::filesystem::path& file);
/// The same of a file that may have comments, from // to the end of the line and between /* and */.
JsonNode readJsonWithComments(const std::filesystem::path& file);

}  // namespace carom
