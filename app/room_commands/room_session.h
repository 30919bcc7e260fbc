#pragma once
// The session of `carom room`: the arguments with which it begins, how far it has come, and those with which
// it goes on.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/cave_options.h"

namespace carom {

/// How far a session has come: its newest file, and the last frame there, if there is one.
struct Progress {
  std::filesystem::path file;
  std::optional<std::uint64_t> frame{};
};

class RoomSession {
 public:
  /// `arguments`: for `carom cave`. A session without a name gets one: that of the rig, and the time. Throws
  /// CLI::ParseError.
  RoomSession(const std::filesystem::path& rig, std::vector<std::string> arguments);

  const CaveOptions& options() const { return options_; }
  const std::filesystem::path& file() const { return file_; }

  /// Returns how far it has come; nothing if there is no file, or one that cannot be read.
  std::optional<Progress> progress() const;
  /// Returns whether it has come to the last of its `--frames`.
  bool isComplete(const std::optional<Progress>& reached) const;
  /// Returns the arguments of carom with which it begins or, once it has begun, goes on.
  std::vector<std::string> nextArguments(const std::optional<Progress>& reached) const;

 private:
  std::filesystem::path rig_;
  CaveOptions options_;  // as the arguments name them
  std::vector<std::string> arguments_;
  std::filesystem::path file_;
  bool isAnothers_ = false;  // the file was there and is not to go on: carom cave refuses it
  std::uint64_t firstFrame_ = 0;
};

}  // namespace carom
