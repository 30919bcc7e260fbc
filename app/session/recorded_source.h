#pragma once
// Frames of a recorded session: as it was seen, from beginning to end, or gone through by the operator.

#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "app/journal/session_file.h"
#include "app/session/frame_source.h"
#include "app/session/hands_off.h"
#include "cave/frame/pacer.h"

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

/// What the operator has changed of a value, byte by byte; it stays so, whatever the recording says.
template <typename T>
class Changed {
 public:
  void note(const T& before, const T& now) {
    const auto was = std::bit_cast<Bytes>(before), is = std::bit_cast<Bytes>(now);
    for (std::size_t i = 0; i < is.size(); ++i) {
      if (is[i] != was[i]) changed_[i] = is[i];
    }
  }
  void hold(T& value) const {
    auto bytes = std::bit_cast<Bytes>(value);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = changed_[i].value_or(bytes[i]);
    value = std::bit_cast<T>(bytes);
  }

 private:
  using Bytes = std::array<std::uint8_t, sizeof(T)>;
  std::array<std::optional<std::uint8_t>, sizeof(T)> changed_{};
};

class RecordedSource : public FrameSource {
 public:
  /// `session` has at least one frame; it and the clock are used as long as this lives. `from_s`: the time of
  /// the session's clock that it begins at, instead of at its first frame.
  RecordedSource(SessionFile& session, std::vector<WorldLine> atStart, double display_hz, Clock& clock,
                 std::optional<double> from_s = {});

  /// Left alone, every frame again with what was known then: the same pixels, and after the last one the end.
  /// Once the operator has been elsewhere all of the game is known in every frame; then the last frame stays.
  /// What the operator has not changed is as it was.
  void next(const Controls& controls, FrameState& state) override;
  std::optional<std::uint64_t> end() const override;
  std::optional<std::pair<double, double>> span_s() const override { return span_s_; }
  void handled(const DeskInput& desk) override { handsOff_.handled(desk, clock_.now_s()); }
  void drawn() override;

 private:
  void readAhead();
  void goElsewhere(std::uint64_t number);
  std::uint64_t following(double rate) const;
  bool move(const Playback& playback);
  void bringGame();
  void obey(const Controls& controls, FrameRecord& record);

  SessionFile& session_;
  std::vector<WorldLine> atStart_;
  double period_s_;                   ///< of the display
  std::pair<double, double> span_s_;  ///< of the session's clock
  Clock& clock_;
  FrameState ahead_;         ///< the frame after the one that was shown last
  bool more_ = false;        ///< there is one
  FrameState shown_;         ///< as it was recorded
  bool begun_ = false;       ///< there has been one
  bool leftAlone_ = true;    ///< so far, all frames have been shown one after the other
  bool ends_ = true;         ///< with the last frame: nobody has gone elsewhere
  bool bringsGame_ = false;  ///< the next frame brings all of the game
  unsigned jumps_ = 0;
  double due_s_;      ///< on the clock: when the frame at hand should be on the walls
  FrameRecord last_;  ///< of the frame before, as the operator had it
  Changed<Switches> switches_;
  Changed<WallControls> walls_;
  Changed<TimeViews> views_;
  HandsOff handsOff_;
  std::optional<ObserverView> frozen_;  ///< the sight that the operator has frozen
};

}  // namespace carom
