#pragma once
// The names of languages in files and options: a code ("fr"), whose texts are shipped, or a PO file. The
// language of the system is never asked, since a room shows the same to all.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace carom {

inline constexpr const char* kEnglish = "en";
/// The most letters of a language's code.
inline constexpr std::size_t kMostCodeLetters = 16;

/// Returns whether a language is named by a PO file.
inline bool isPoFile(std::string_view language) { return language.ends_with(".po"); }

/// Returns the name of a language as sessions have it, a code or the absolute path of a PO file, which is
/// looked for in `folder`.
std::string languageNamed(const std::string& name, const std::filesystem::path& folder);

/// Returns why there is no language of this name, as `languageNamed` returns it, in one sentence: it is no
/// plain code, or no PO file that exists. Empty if there may be one.
std::string refusalOfLanguage(const std::string& name);

}  // namespace carom
