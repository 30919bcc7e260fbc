#pragma once
// `carom replay`: a recorded session again, as it was seen or as another person would have seen it.

#include <filesystem>
#include <optional>

namespace carom {

struct ReplayOptions {
  std::filesystem::path session;
  std::optional<std::filesystem::path>
      observer;  ///< a trace of the head (room axes): another person in the same game
  std::optional<std::filesystem::path> capture;  ///< folder for every wall and eye of every frame
  bool noWindow = false;                         ///< as fast as it goes
};

/// The exit status: 0, or 1 after a message on standard error.
int runReplay(const ReplayOptions& options);

}  // namespace carom
