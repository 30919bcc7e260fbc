#pragma once
// Reading a session's journal (app/journal/journal.h) again.

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/journal/journal.h"
#include "cave/frame/frame_state.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// A recorded session, frame by frame. May be opened while the session is still being written.
class SessionFile {
 public:
  /// Throws std::runtime_error that says what is wrong with the file and what was expected: missing, not a
  /// session file, damaged, of a newer version, locked. Warns in the log if the session was not closed
  /// and FILE-wal, which has its end, is not beside it; `quiet`: not again.
  explicit SessionFile(const std::filesystem::path& file, bool quiet = false);
  ~SessionFile();
  SessionFile(const SessionFile&) = delete;
  SessionFile& operator=(const SessionFile&) = delete;

  const SessionFacts& facts() const { return facts_; }
  /// The numbers of the first and the last frame; none if the session ended before its first.
  std::optional<std::pair<std::uint64_t, std::uint64_t>> frames() const;

  /// What hands have struck, in the order of the frames. `pucks`: of the scenario. Throws std::runtime_error,
  /// that names the file and the frame, for a stroke that this scenario cannot have had.
  std::vector<Stroke> strokes(std::span<const Puck> pucks) const;

  /// The next frame in the order of their numbers, with its knots; false after the last. Throws
  /// std::runtime_error, that names the file and the frame, where the file turns out to be damaged.
  bool next(FrameState& state);
  /// Brings the world up to a frame of this session (applyFrame). Throws std::runtime_error, that names the
  /// file and the frame, where it does not go on from what the world is.
  void apply(const FrameState& state, World& world) const try {
    applyFrame(state, world);
  } catch (const std::logic_error& error) {
    refuseFrame(state.record.number, error.what());
  }
  /// The next frame will be the first whose number is at least this.
  void goTo(std::uint64_t number);
  /// When a frame was on the walls: the first whose number is at least this. The session's clock.
  double shownAt_s(std::uint64_t number) const;
  /// The last frame that was on the walls at this time of the session's clock; the first, if none was yet.
  std::uint64_t frameAt(double display_s) const;

 private:
  struct Tables;
  [[noreturn]] void refuseFrame(std::uint64_t number, const std::string& what) const;
  std::filesystem::path file_;
  std::unique_ptr<Tables> tables_;
  SessionFacts facts_;
};

}  // namespace carom
