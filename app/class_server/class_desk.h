#pragma once
// The class as the frames see it: what it wants of the lesson becomes commands, what happens on the wall is
// told to it. No frame waits for it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/class_server/class_server.h"
#include "app/operator/command.h"
#include "app/scenario/scenario.h"

namespace carom {

class ClassDesk {
 public:
  /// Opens the class's server. Throws std::runtime_error as that does.
  ClassDesk(const ClassServerOptions& options, const std::optional<ClassLeft>& left = {})
      : server_(options, left) {}

  const ClassInvitation& invitation() const { return server_.invitation(); }

  /// Begins another game, or the same one again. `lesson` is null if the game has none.
  void play(const Lesson* lesson, const std::string& file);

  /// Adds the commands for what the class wants of the lesson.
  void command(const OperatorSettings& settings, Commands& commands);
  /// Tells the class how the lesson stands if that has changed, and takes over the class's newest view.
  void follow(const LessonState& lesson);
  const ClassView& view() const { return view_; }
  /// Returns the phases since the last call, as session files have them: "vote 1".
  std::vector<std::string> takePhases() { return std::exchange(phases_, {}); }
  /// Adds the votes that have counted since the last call.
  void takeVotes(std::vector<ClassVote>& votes);

  /// Keeps a page under its code, and offers it on the walls. From any thread.
  void offer(const std::string& code, std::string page) { server_.offer(code, std::move(page)); }

  /// Takes a step for the person at the console.
  void ask(ClassStep step) { server_.ask(step); }

 private:
  ClassServer server_;
  std::optional<ClassQuestion> begins_;  ///< a game that the class has not been told of
  LessonPhase told_ = LessonPhase::none;
  ClassView view_;
  std::vector<std::string> phases_;  ///< since they were last taken
};

/// Returns the phase of a class with the number of its vote, as session files have it: "vote 2", "idle".
std::string nameOf(ClassPhase phase, int round);

}  // namespace carom
