#pragma once
// The rows of a game's soft pucks, as they are drawn (engine/soft/soft_history.h), from the moment they are
// played until a frame takes them. c = 1, metres, board frame; `body` in a row is the puck's place in the
// setup.
//
// What must be stored to see them again: nothing but the setup with all its strokes. The rows are made from
// the steps of the simulation alone, and these do not depend on the times to which one advances: a game that
// is played anew, to any time, gives the same rows, bit for bit. So a journal keeps a game's scenario and its
// strokes by hand, as it does for rigid pucks, and to resume or replay from some moment is to play the game
// anew and to take its rows: about 1.5 MB a metre of light and awake puck are not written. The frame that
// takes a row depends on the times to which one advanced; the picture does not, since a row is made at least
// kLongest (engine/soft/row_recorder.h) ahead of the eyes. A stroke takes back the rows from the point to
// which the game returns (`truncatedFrom`), and they come again.
//
// Theory: app/doc/physics.md, Soft bodies.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/game/billiard_setup.h"
#include "engine/soft/row_recorder.h"
#include "engine/soft/soft_play.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class SoftRowBook {
 public:
  /// Begins a game anew: all rows before are void.
  void begin();
  /// Adds the next body of the play, by its number in the setup. With `line` and the body's height it was a
  /// rigid puck until now, and is drawn from where its rim is now.
  void enter(std::size_t puck, const SoftPlay& play, const WorldLine* line, double height_m);
  /// Takes the state of a body after a step; of those that sleep, at the end of a slice.
  void step(std::size_t body, const SoftPlay& play);
  void endSlice(const SoftPlay& play);
  /// While it does not listen, the play is at another time than the game.
  void listen(bool does) { listens_ = does; }

  /// Moves the rows that no one has taken yet into `rows`, whose memory is used again.
  void take(SoftRows& rows);

  struct Snapshot {
    double time = 0.0;
    std::vector<RowRecorder> recorders;
  };
  Snapshot snapshot(double time) const { return {time, recorders_}; }
  void restore(const Snapshot& snapshot);
  /// Takes over where another book stands, without its rows: only those that come are in this one.
  void continueFrom(const Snapshot& snapshot);
  /// Goes on to where another book stands that began here, and has got these rows since.
  void follow(const Snapshot& snapshot, const SoftRows& rows);

 private:
  void truncateFrom(double time);
  void bound();

  std::vector<RowRecorder> recorders_;  // by the bodies' numbers in the play
  SoftRows rows_;
  bool listens_ = true;
  std::vector<glm::dvec2> places_;
};

}  // namespace carom
