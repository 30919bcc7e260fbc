#pragma once
// The names of keys, as people read them on their keyboard. The program knows a key by its place, which is
// called as on a US keyboard: the key that is called W stands for Z on a French one. The names are those of a
// US keyboard until they are set (app/input/keyboard_layout.h), so that pictures without a window, and
// those of a replay, are the same everywhere.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace carom::texts {

/// The names of the printable keys; change them through KeyNames::set alone.
class KeyNames {
 public:
  /// Returns the name of the key that a US keyboard calls so. Letters are capitals.
  std::string_view of(char us) const {
    const Name& name = names_[static_cast<unsigned char>(us) % kKeys];
    return name[0] != 0 ? std::string_view(name.data()) : std::string_view();
  }
  /// Names a key. A longer or empty name leaves the one of a US keyboard.
  void set(char us, std::string_view name) {
    Name& kept = names_[static_cast<unsigned char>(us) % kKeys];
    Name now{};
    if (name.empty() || name.size() >= now.size()) name = std::string_view(&us, 1);
    name.copy(now.data(), now.size() - 1);
    if (now == kept) return;
    kept = now;
    ++changes_;
  }
  /// Returns how often a name has changed, so that words that were made with the names can be made anew.
  std::uint64_t changes() const { return changes_; }

 private:
  static constexpr std::size_t kKeys = 128;
  using Name = std::array<char, 8>;
  static constexpr std::array<Name, kKeys> usNames() {
    std::array<Name, kKeys> names{};
    for (std::size_t key = '!'; key <= '~'; ++key) names[key][0] = static_cast<char>(key);
    return names;
  }
  std::array<Name, kKeys> names_ = usNames();
  std::uint64_t changes_ = 0;
};

/// Those of this process. For its main thread.
inline KeyNames keyNames;

/// Returns a label of keys as the keyboard names them: each word of one sign is a key, as in "W A S D" and
/// "Escape Q". Digits stay, since each keyboard has them printed on it.
inline std::string inLayout(std::string_view label) {
  std::string named;
  while (true) {
    const std::size_t end = label.find(' ');
    const std::string_view word = label.substr(0, end);
    const bool isKey = word.size() == 1 && (word[0] < '0' || word[0] > '9');
    named += isKey ? keyNames.of(word[0]) : word;
    if (end == std::string_view::npos) return named;
    named += ' ';
    label.remove_prefix(end + 1);
  }
}

/// Returns the words of a button, whose key stands behind two spaces: "Again  Y".
inline std::string withKeyInLayout(std::string_view words) {
  const std::size_t gap = words.rfind("  ");
  if (gap == std::string_view::npos) return std::string(words);
  return std::string(words.substr(0, gap + 2)) + inLayout(words.substr(gap + 2));
}

}  // namespace carom::texts
