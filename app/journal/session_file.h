#pragma once
// Reads a session's journal (app/journal/journal.h).

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/journal/journal.h"
#include "app/journal/session_games.h"
#include "app/scenario/scenario.h"
#include "cave/record/frame_state.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// A visitor's answer to a lesson's question.
struct GivenAnswer {
  std::uint64_t frame = 0;  ///< in which it was given
  std::size_t game = 0;     ///< in which, its place in SessionFile::games
  std::string lesson, question, answer, viewer;
  double seconds = 0.0;  ///< on the session clock, since the question was asked
  std::size_t group =
      1;  ///< which visitors of the session, counted from 1: the next ones were welcomed meanwhile
};

/// A vote of a class that counted.
struct CountedVote {
  std::uint64_t frame = 0;  ///< in which it was closed
  std::size_t game = 0;     ///< in which, its place in SessionFile::games
  ClassVote vote;
};

/// One game of a recorded session, frame by frame. May be opened while the session is still being written.
class SessionFile {
 public:
  /// Opens the file at a game, counted from 1, or at its newest. Throws std::runtime_error that gives the
  /// fault and what was expected: missing, not a session file, damaged, of another version, locked, no such
  /// game. Logs a warning if the session was not closed and FILE-wal, which has its end, is missing; with
  /// `quiet`, logs nothing.
  explicit SessionFile(const std::filesystem::path& file, std::optional<std::size_t> game = {},
                       bool quiet = false);
  ~SessionFile();
  SessionFile(const SessionFile&) = delete;
  SessionFile& operator=(const SessionFile&) = delete;

  /// Returns the rig of the session and the scenario of the game.
  const SessionFacts& facts() const { return facts_; }
  /// Returns the scenario of the game. Throws InputErrors if it is wrong, and std::runtime_error if the light
  /// speed of the session is another than the scenario's.
  Scenario scenario() const;
  /// Returns the name of a viewer of the records.
  std::string nameOf(std::size_t viewer) const {
    return viewer < facts_.viewers.size() ? facts_.viewers[viewer] : "viewer " + std::to_string(viewer + 1);
  }
  /// Returns the viewer of that name. Throws std::runtime_error that names those whom the session has.
  std::size_t viewerNamed(const std::string& name) const;
  /// Returns all games of the session, and the number of this one among them, from 1.
  const std::vector<SessionGame>& games() const { return games_; }
  std::size_t game() const { return game_; }
  /// Returns the numbers of the game's first and last frame, or nothing if it has no frame.
  std::optional<std::pair<std::uint64_t, std::uint64_t>> frames() const;

  /// Returns the strokes by hand in the order of the frames. `pucks` are the scenario's. Throws
  /// std::runtime_error with file and frame for a stroke that is impossible in this scenario.
  std::vector<Stroke> strokes(std::span<const Puck> pucks) const;
  /// The same, each with the number of its frame.
  std::vector<std::pair<std::uint64_t, Stroke>> strokesByFrame(std::span<const Puck> pucks) const;

  /// Returns the answers that were given in all games of the session, in the order of the frames.
  std::vector<GivenAnswer> answers() const;

  /// Returns the votes of classes that counted, in all games, in the order of the frames.
  std::vector<CountedVote> votes() const;
  /// Returns where the class was at the end of the session.
  ClassLeft classLeft() const;

  /// Reads the next frame in the order of their numbers, with its knots. Returns false after the last. Throws
  /// std::runtime_error with file and frame if the file is damaged there.
  bool next(FrameState& state);
  /// Updates `world` by a frame of this session (applyFrame). Throws std::runtime_error with file and frame
  /// if the frame does not continue the state of `world`.
  void apply(const FrameState& state, World& world) const try {
    applyFrame(state, world);
  } catch (const std::logic_error& error) {
    refuseFrame(state.record.number, error.what());
  }
  /// Makes the next frame the first whose number is at least `number`.
  void goTo(std::uint64_t number);
  /// Makes `next` begin anew and read only those frames that change the game, until `goTo` is called.
  void goToChanges();
  /// Returns the display time, on the session clock, of the first frame whose number is at least `number`.
  double shownAt_s(std::uint64_t number) const;
  /// Returns the number of the last frame displayed by `display_s` on the session clock, or of the first
  /// frame if none was.
  std::uint64_t frameAt(double display_s) const;

 private:
  struct Tables;
  [[noreturn]] void refuseFrame(std::uint64_t number, const std::string& what) const;
  std::filesystem::path file_;
  std::unique_ptr<Tables> tables_;
  SessionFacts facts_;
  std::vector<SessionGame> games_;
  std::size_t game_ = 1;
};

}  // namespace carom
