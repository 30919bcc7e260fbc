#pragma once
// Adds the rows of soft pucks to the frames of a recorded game. They are not in the session file: the game is
// played anew from the scenario and the recorded strokes, which gives the same rows, bit for bit
// (engine/billiard/soft_row_book.h says why), each stroke in the frame in which it was made. Where the
// operator goes elsewhere in the game, all strokes are known.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "app/live/frame_source.h"
#include "app/play/game.h"
#include "app/scenario/scenario.h"

namespace carom {

/// A stroke by hand, with the number of its frame.
using StrokeInFrame = std::pair<std::uint64_t, Stroke>;

bool hasSoftPucks(const Scenario& scenario);

class SoftReplaySource : public FrameSource {
 public:
  /// Adds rows to the frames of `recorded`. `strokes` are in the order of their frames.
  SoftReplaySource(std::unique_ptr<FrameSource> recorded, const Scenario& scenario,
                   std::vector<StrokeInFrame> strokes);

  void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override;
  SourceStatus status() const override { return recorded_->status(); }

 private:
  void begin(std::uint64_t frame);

  std::unique_ptr<FrameSource> recorded_;
  Scenario scenario_;
  std::vector<StrokeInFrame> strokes_;
  std::unique_ptr<Game> game_;
  std::size_t struck_ = 0;  // of the strokes
  std::uint64_t last_ = 0;  // number of the last frame
  FrameState played_;
};

}  // namespace carom
