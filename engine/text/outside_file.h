#pragma once
// The only way in which files from outside are opened: rigs, scenarios, meshes, pictures, traces, sessions.
// Such a file is not trusted. It must be a regular file (a pipe may never end and may block, a device may do
// anything), and no larger than its kind allows.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace carom {

/// The kinds of files from outside; kInputLimits has a row for each.
enum class InputKind {
  toml,
  json,
  xml,
  trace,
  mesh,
  meshPart,
  warp,
  blend,
  session,
  screenMesh,
  screenGrid,
  mpcdi,
  translation,
  glossary
};

/// The limits of one kind of file.
struct InputLimit {
  std::string_view what;    ///< for messages: "a TOML file"
  std::uintmax_t most_MiB;  ///< largest size
};

/// Returns the limits of a kind.
const InputLimit& limitOf(InputKind kind);

/// Returns why the file is not opened and the expectation, in words that can follow "FILE:1:1: "; empty if it
/// is a regular file that can be read and is not too large. Never waits for anybody to write into the file.
std::string refusalOf(const std::filesystem::path& file, InputKind kind);

/// Returns the bytes of the file. Throws InputError (at 1:1) for a file that refusalOf refuses.
std::string contentOf(const std::filesystem::path& file, InputKind kind);

/// Returns the first bytes of the file, at most `most`. Throws as contentOf does, but takes a file of any
/// size.
std::string beginningOf(const std::filesystem::path& file, InputKind kind, std::size_t most);

/// Returns whether the file lies in the folder or in a folder below it, once all links in both paths are
/// followed. An empty folder is the present one. False if one of them does not exist.
bool liesBelow(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Returns where a file lies that does not lie below a folder: "FILE, outside FOLDER", all links followed.
std::string outsideWords(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace carom
