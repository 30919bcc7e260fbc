#pragma once
// The names of languages in themselves, for buttons that choose one: who cannot read the words on the wall
// finds theirs.

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace carom::texts {

/// Returns the own name of the language with this code, such as "Deutsch"; of another one, the code; of a PO
/// file, the name of the file.
inline std::string ownNameOf(std::string_view language) {
  using Named = std::pair<std::string_view, std::string_view>;
  constexpr std::array kNames{Named{"de", "Deutsch"}, Named{"en", "English"}, Named{"fr", "Français"},
                              Named{"ja", "日本語"}};
  for (const auto& [code, name] : kNames) {
    if (code == language) return std::string(name);
  }
  if (const std::size_t slash = language.rfind('/'); slash != std::string_view::npos)
    language.remove_prefix(slash + 1);
  if (language.ends_with(".po")) language.remove_suffix(3);
  return std::string(language);
}

}  // namespace carom::texts
