#pragma once
// Decides the frames of a recorded session: as recorded from beginning to end, or as the operator navigates
// it.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "app/journal/session_file.h"
#include "app/live/frame_source.h"
#include "app/replay/read_only_notice.h"

namespace carom {

/// The final state of a recorded game, without what later strokes invalidated.
struct RecordedGame {
  World world;                ///< with the complete game
  FrameState news;            ///< the complete game in the form of a session's first frame
  std::size_t pucks = 0;      ///< the pucks are bodies 1 to `pucks`
  double known_s = 0.0;       ///< board time up to which every puck's motion is known
  HeadsetState headset = {};  ///< of the latest frame
};

/// Reads the complete game, or the game as it was known in frame `last`. `atStart` are the histories of all
/// bodies before the game. Takes as long as the game has knots and events, however many frames it lasted; the
/// frame that `session` reads next is then undetermined.
RecordedGame wholeGame(SessionFile& session, std::span<const WorldLine> atStart,
                       std::uint64_t last = std::numeric_limits<std::uint64_t>::max());

class RecordedSource : public FrameSource {
 public:
  /// Plays `session`, which needs at least one frame and must outlive this object. `from_s`, on the session
  /// clock, is where playback starts, with the game as it was known then; without it, playback starts at the
  /// first frame. `viewer` is the one of the session's viewers who is the first of the frames that are shown.
  RecordedSource(SessionFile& session, std::vector<WorldLine> atStart, double display_hz,
                 std::optional<double> from_s = {}, std::size_t viewer = 0);

  /// Returns the recorded frames one after the other. Until the operator seeks or changes the rate, each
  /// frame has only the knots known when it was recorded, so the pixels are the same, and the session ends
  /// after the last frame. After that, every frame has the complete game, and the last frame stays. Settings
  /// that the operator has not changed are as recorded.
  void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override;
  SourceStatus status() const override;

 private:
  void readAhead();
  void goElsewhere(std::uint64_t number);
  std::uint64_t following(double rate) const;
  bool move(const Playback& playback, const Seek* seek);
  void bringGame();
  void keepChanges(std::span<const Command> commands, OperatorSettings& settings, FrameRecord& record);
  void freeze(FrameRecord& record, bool wasFrozen);

  SessionFile& session_;
  std::vector<WorldLine> atStart_;
  double period_s_;                   ///< display refresh period
  std::pair<double, double> span_s_;  ///< session clock
  FrameState ahead_;                  ///< the frame after the last one shown
  bool more_ = false;                 ///< `ahead_` holds a frame
  FrameState shown_;                  ///< the last frame shown, as recorded
  bool begun_ = false;                ///< a frame has been shown
  bool leftAlone_ = true;             ///< all frames so far were shown in recorded order and rate
  bool ends_ = true;                  ///< the session ends with its last frame
  bool bringsGame_ = false;           ///< the next frame brings the game: all of it, unless leftAlone_
  Commands changed_;                  ///< the operator's latest command on each setting
  ReadOnlyNotice readOnly_;
  std::size_t viewer_;  ///< the first of the frames that are shown
  /// The views of all viewers that the operator has frozen.
  std::optional<std::array<ObserverView, kMostViewers>> frozen_;
};

}  // namespace carom
