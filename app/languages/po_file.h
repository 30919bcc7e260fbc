#pragma once
// PO files, the form in which translators' programs (Poedit, Weblate, Lokalize) keep translations.
// Source: the manual of GNU gettext, "The Format of PO Files". Ours have a name for each text (msgctxt),
// which no other text has, and are UTF-8.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/toml/input_file.h"

namespace carom {

/// A string of a PO file: its words without escapes, and where its first quotation mark stands.
struct PoText {
  std::string words;
  FilePlace at;
};

struct PoEntry {
  std::vector<std::string> comments;  ///< whole lines: "# …", "#. …", "#: …"
  std::vector<std::string> flags;     ///< "fuzzy", "c++-format"
  std::vector<std::string> before;    ///< whole lines about the English of before: "#| msgid …"
  bool isObsolete = false;            ///< "#~": of a text that is no longer there
  std::optional<PoText> context;      ///< the name of the text
  PoText id;                          ///< the English
  std::optional<PoText> plural;       ///< the English for many
  std::vector<PoText> forms;          ///< the translation; of a text with a plural, one for each form

  bool isFuzzy() const;
  /// Returns whether there are words in each form, and the entry is not fuzzy.
  bool isTranslated() const;
};

/// What the entry without a name says about the file.
struct PoHeader {
  std::string language, charset, pluralForms;
  FilePlace at;
};

struct PoFile {
  std::filesystem::path path;
  std::optional<PoEntry> head;   ///< the entry with an empty msgid, as it stands
  std::vector<PoEntry> entries;  ///< the others, in the file's order
  FilePlace end;                 ///< of the last line
};

/// The most entries that a file may have; the catalogue and all shipped games have about a thousand.
inline constexpr std::size_t kMostPoEntries = 20'000;

/// Returns the entries of a file's content. CR LF and a byte order mark are taken. Throws InputErrors, with
/// all that is no PO in it: the first byte that is not UTF-8; for too many entries, one sentence.
PoFile parsePo(const std::filesystem::path& path, std::string_view content);

/// Reads a PO file of at most 16 MiB. Throws InputErrors.
PoFile readPo(const std::filesystem::path& path);

/// Returns what the file says about itself; none if it has no head.
std::optional<PoHeader> headerOf(const PoFile& file);

/// Returns the text of a PO file: each string on a line of its own, broken behind line feeds alone.
std::string textOf(const PoFile& file);

/// Returns a string in quotation marks, as a PO file has it.
std::string quotedPo(std::string_view words);

}  // namespace carom
