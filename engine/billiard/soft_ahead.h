#pragma once
// Plays soft bodies ahead of time on a thread of its own, so that a bounce, which is many small steps, holds
// up no frame. c = 1, metres, board frame.
//
// The thread plays slice after slice from a given state, and keeps what each leads to until it is taken. Its
// slices are those that SoftPlay::playSlice makes, bit for bit, whenever they were
// made. A stroke or a body that comes in, of which the thread cannot know, makes them void: then it starts
// anew from the state with that in it.
// Theory: app/doc/physics.md, Soft bodies.

#include <memory>
#include <vector>

#include "engine/billiard/soft_row_book.h"
#include "engine/soft/soft_play.h"

namespace carom {

class SoftAhead {
 public:
  static constexpr double kFarthest = 0.6;  ///< how far ahead it plays

  /// What a slice leads to: the state after it, and the rows that it gave.
  struct Slice {
    std::shared_ptr<const SoftPlay::Snapshot> play;
    SoftRowBook::Snapshot recorders;
    SoftRows rows;
  };

  explicit SoftAhead(const std::vector<SoftCushion>& cushions);
  ~SoftAhead();

  /// Plays on from this state; slices that have not been taken are void.
  void start(Slice from);
  /// Returns the next slice, and waits for it if it is still to be played. Throws what the
  /// thread has thrown.
  Slice take();

 private:
  class Player;  // and its thread: where there are none, nobody makes one
  std::unique_ptr<Player> player_;
};

}  // namespace carom
