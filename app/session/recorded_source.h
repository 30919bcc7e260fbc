#pragma once
// Frames of a recorded session: as it was seen, from beginning to end, or gone through by the operator.

#include <optional>
#include <vector>

#include "app/journal/session_file.h"
#include "app/session/frame_source.h"
#include "app/session/read_only_notice.h"

namespace carom {

/// A game as it was in the end: what strokes took back is gone.
struct RecordedGame {
  World world;            ///< with all of it
  FrameState news;        ///< all of it, as the first frame of a session would bring it
  std::size_t pucks = 0;  ///< bodies 1 to this
  double known_s = 0.0;   ///< the board time up to which every puck's way is known
};

/// Reads all of the session. `atStart`: the bodies' histories before the game.
RecordedGame wholeGame(SessionFile& session, std::span<const WorldLine> atStart);

class RecordedSource : public FrameSource {
 public:
  /// `session` has at least one frame; it is used as long as this lives. `from_s`: the time of the session's
  /// clock that it begins at, instead of at its first frame.
  RecordedSource(SessionFile& session, std::vector<WorldLine> atStart, double display_hz,
                 std::optional<double> from_s = {});

  /// Left alone, every frame again with what was known then: the same pixels, and after the last one the end.
  /// Once the operator has been elsewhere all of the game is known in every frame; then the last frame stays.
  /// What the operator has not changed is as it was.
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
  double period_s_;                   ///< of the display
  std::pair<double, double> span_s_;  ///< of the session's clock
  FrameState ahead_;                  ///< the frame after the one that was shown last
  bool more_ = false;                 ///< there is one
  FrameState shown_;                  ///< as it was recorded
  bool begun_ = false;                ///< there has been one
  bool leftAlone_ = true;             ///< so far, the frames have been shown one after the other
  bool ends_ = true;                  ///< with the last frame: nobody has gone elsewhere
  bool bringsGame_ = false;           ///< the next frame brings all of the game
  Commands changed_;                  ///< the operator's last on each thing
  ReadOnlyNotice readOnly_;
  std::optional<ObserverView> frozen_;  ///< the sight that the operator has frozen
};

}  // namespace carom
