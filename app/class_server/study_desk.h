#pragma once
// A study as the frames see it: its pages are served to phones and tablets, the lessons that it wants of the
// room become commands, and what an arm leaves out stays off. No frame waits for it.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/class_server/class_server.h"
#include "app/operator/command.h"
#include "app/study/study_run.h"

namespace carom {

struct StudyDeskOptions {
  std::filesystem::path session;             ///< an existing session file
  std::map<std::string, std::size_t> slips;  ///< number by code
  bool isAmended = false;
  std::string waiting;  ///< scenario file that is played between lessons
  ClassServerOptions server;
  std::filesystem::path rig;  ///< of this session: people of arms with another one come to another session
};

class StudyDesk {
 public:
  /// Opens the study's tables and the server of its pages. Throws std::runtime_error.
  StudyDesk(Study study, StudyDeskOptions options);
  ~StudyDesk();
  StudyDesk(const StudyDesk&) = delete;
  StudyDesk& operator=(const StudyDesk&) = delete;

  /// Returns the address of the pages.
  std::string address() const;

  /// Adds the commands for the lesson that the study wants, those that put off again what the arm of the
  /// participant in the room leaves out, and from time to time the question how they feel.
  void command(const OperatorSettings& settings, double session_s, Commands& commands);

  // For the person at the console.
  /// Has an order carried out with one of the next frames.
  void order(StudyOrder order) { order_ = std::move(order); }
  /// Returns what came of the newest order.
  const std::string& said() const { return said_; }
  /// Returns how far everybody is who is not done.
  const std::vector<StudyStanding>& standings() const { return standings_; }

  /// Begins a game. Returns whether it is a lesson of a participant, which is written to the session file;
  /// `begun` is then to be called once it is.
  bool play(const std::string& file);
  void begun();
  /// Returns whether this game is the one that is played or wanted.
  bool allows(const std::string& file) const;
  /// Sets what the game begins with: black walls between lessons, and off what the arm leaves out. Nothing
  /// about it is told in the room.
  void applyTo(OperatorSettings& settings) const;
  /// Returns whether the eyes stay where they are in this game.
  bool isStill() const;

 private:
  std::string fileOf(const RoomWish& wish) const;
  void putOff(const OperatorSettings& settings, Commands& commands) const;
  StudyDeskOptions options_;
  std::unique_ptr<StudyTables> tables_;
  std::unique_ptr<StudyRun> run_;
  std::unique_ptr<ClassServer> server_;
  std::optional<RoomWish> wanted_, played_;  ///< not played yet; of the present game
  bool isAsked_ = false;                     ///< the wanted one was asked for by a command
  bool hasExplained_ = false;                ///< the present game has, and the pages know it
  std::optional<StudyOrder> order_;          ///< not carried out yet
  std::string said_;
  std::vector<StudyStanding> standings_;
};

}  // namespace carom
