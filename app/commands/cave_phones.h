#pragma once
// What phones get of a session with a class: the game that is played, live, and the page of a game that is
// over, to take home. Pages are made in a thread of their own; frames never wait.

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/class_server/class_desk.h"
#include "app/commands/cave_options.h"
#include "app/page/live_game.h"
#include "app/session/frame_listener.h"
#include "app/stage/session_setup.h"

namespace carom {

class CavePhones : public FrameListener {
 public:
  /// A visit that was shorter is not worth a page.
  static constexpr double kLeast_s = 5.0;

  /// Throws std::runtime_error that says what to install if the program cannot make pages.
  explicit CavePhones(const CaveOptions& options);
  ~CavePhones() override { finish(); }
  CavePhones(const CavePhones&) = delete;
  CavePhones& operator=(const CavePhones&) = delete;

  /// Returns what the class's server asks for those who follow; nothing without --follow. This object must
  /// outlive the server.
  std::optional<FollowedGame> followed();

  /// Begins a game, which is written to `session` if that is not empty.
  void play(const SessionSetup& setup, const std::filesystem::path& session);
  /// The game is over and its part of the session file complete: its page is offered to the class.
  void end(ClassDesk& desk);
  /// Makes no more pages: before the class goes.
  void finish();

  void shown(const Decision& decision) override;

 private:
  using Page = std::shared_ptr<const std::string>;
  void afterwards(std::function<void()> job);
  void work(const std::stop_token& ends);

  bool takes_, follows_;
  LiveGame live_;
  std::uint64_t games_ = 0;
  std::shared_ptr<const Scene> scene_;  ///< of the game at hand
  std::filesystem::path session_;       ///< to which it is written; empty: to none

  std::mutex mutex_;  ///< of the following
  std::condition_variable_any hasJob_;
  std::deque<std::function<void()>> jobs_;
  Page followed_;  ///< of the game at hand; null: not made yet
  std::jthread worker_;
};

}  // namespace carom
