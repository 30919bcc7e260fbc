#pragma once
// A room's own side of a linked game: its people's promises, and the strokes that keep them. Theory:
// app/doc/physics.md, Linked rooms.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/linked/promise.h"
#include "engine/linked/told.h"
#include "engine/spacetime/observers.h"

namespace carom {

class OwnRoom {
 public:
  /// Begins with the first promises of these people. `reach_m`: how far from their heads their hands strike
  /// and are drawn. `others`: the heads known of other rooms; near ones shorten the reach.
  OwnRoom(double reach_m, const Observers& observers, std::span<const Event> others);

  /// Returns a person's stroke as it is told and played: put off along the room's time until it keeps the
  /// promise told before. Every stroke that is returned must be told before the next present. Throws
  /// std::length_error after kMostStrokesTold strokes.
  StrokeTold strike(std::uint32_t viewer, const Stroke& stroke, const Lorentz& boardFromRoom) {
    return made(viewer, putOff(viewer, stroke, boardFromRoom));
  }
  /// The two steps of `strike`, for games that may refuse a stroke in between: the stroke as it keeps the
  /// promise, and such a stroke once it has been played.
  Stroke putOff(std::uint32_t viewer, const Stroke& stroke, const Lorentz& boardFromRoom) const;
  StrokeTold made(std::uint32_t viewer, const Stroke& stroke);

  /// Goes on after this number of strokes, made in this room's place earlier in the game.
  void continueAfter(std::uint32_t strokes) { present_.strokes = strokes; }

  /// Returns the present after a frame, with new promises. `handsFromHeads_m`: of each person, in the room's
  /// axes; `waits`: the people did not live on.
  const Present& tell(const Observers& observers, std::span<const Vec3> handsFromHeads_m,
                      std::span<const Event> others, bool waits);

  /// The present told last.
  const Present& present() const { return present_; }
  double reach_m(std::size_t viewer) const { return reaches_m_[viewer]; }  ///< as it is now

 private:
  double reachBeside(const Event& head, std::span<const Event> others) const;

  double reach_m_;
  std::vector<Promise> promises_;  ///< of each person
  std::vector<double> reaches_m_;  ///< with which they were made
  Present present_;
};

}  // namespace carom
