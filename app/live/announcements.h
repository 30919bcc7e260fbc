#pragma once
// Who in the room is told what: messages to one viewer or to all, and the scenario's captions.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "app/live/decision.h"
#include "app/live/status_message.h"
#include "app/operator/command.h"
#include "app/play/hit_seen.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/viewer/viewers.h"
#include "cave/room/room_boundary.h"

namespace carom {

class Announcements {
 public:
  /// With `before`, captions that had begun in that frame of an earlier session are not begun again. `rig`
  /// and `scenario` must outlive this object.
  Announcements(const Rig& rig, const Scenario& scenario, const std::optional<FrameRecord>& before);

  /// Begins another game, after the scenario has been replaced.
  void play();

  /// Shows a message with the next frame.
  void later(const texts::Saying& words) { pending_ = words; }

  /// Shows a message to everybody in the room and notes it in the decision.
  void say(const texts::Saying& words, Decision& decision);
  /// Does the same for one viewer alone.
  void sayTo(std::size_t viewer, const texts::Saying& words, Decision& decision);

  /// Keeps these words on the walls while there is nothing else to say: a task. Until another game begins.
  void keep(const texts::Saying& words) { kept_ = Notice(words); }

  /// Says which effects have just been turned on or off. They change with the next frame: before a picture
  /// with other effects is drawn for the first time, shaders are compiled, which may take seconds, and the
  /// message explains them.
  void tellEffects(std::span<const Command> commands, Decision& decision);

  /// Tells everybody that a viewer sees a carom.
  void tellCarom(std::size_t viewer, std::size_t cushions, Decision& decision);

  /// Tells everybody in the room who saw a hit first, and why the others saw it later: in the room's frame
  /// its light took a longer way to them.
  void tellWhoSawFirst(std::span<const HitSeen::Seen> seen, Decision& decision);

  /// Says whose best shot is shown again; all see it as the one who struck saw it.
  void tellWhoseShot(std::size_t striker, std::size_t cushions, bool isEnd, Decision& decision);

  /// Says once why steering does nothing, while it is `asked` for in frozen time or before an answer.
  void tellWhyStill(bool asked, bool frozen, Decision& decision);

  /// Says that a viewer has left the room.
  void tellWhoLeft(const Viewers& viewers, Decision& decision);

  /// Writes each viewer's message into the record, or else the scenario's caption for the first observer's
  /// proper time. When a caption begins, commands turn on its time views and turn off those of the caption
  /// before it.
  void putInto(Decision& decision);

 private:
  std::size_t captionsBegunAt(double own_s) const;
  void beginCaptions(double own_s, Decision& decision);

  const Rig& rig_;
  const Scenario& scenario_;
  std::vector<Wall> standing_;                             ///< the walls that can be left behind
  std::vector<RoomBoundary> boundaries_;                   ///< of each viewer
  std::array<StatusMessage, kMostViewers> messages_;       ///< of each viewer
  Notice kept_;                                            ///< words that stand while there are no others
  texts::Saying pending_;                                  ///< message still to be shown
  bool captionTurnsEffects_ = false;                       ///< with the next frame
  std::size_t captions_ = 0;                               ///< that have begun
  bool saidWhyStill_ = false;                              ///< why steering does nothing was said
  std::optional<std::tuple<Switches, Switches>> effects_;  ///< in the previous frame: left, right
};

}  // namespace carom
