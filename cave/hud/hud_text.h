#pragma once
// The words of the panel on the front wall (cave/overlay/hud_panel.h) as lines, and the buttons among them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cave/frame/lesson_language.h"
#include "cave/frame/lesson_plan.h"
#include "cave/hud/hud_line.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// Fills `lines`, whose memory is reused, with the session's text, in lines of this room: what was just
/// refused or has happened; the lesson's texts for the record's phase, or without a lesson the views of time
/// that are on, each with the colour it is drawn in; with `clocks`, the person's own clock, their speed on
/// the board and the speed of light; with the tracker crosses, what the stereo check
/// (cave/overlay/room_overlay.h) should look like. The text depends on these alone, so all
/// nodes write the same. `lines` is empty if there is no text. `viewers` are those of the record, in its
/// order; where there are several, the score is each one's, and the clocks compare theirs with that of the
/// first. `mayLeave`: a lesson has the button that leaves it. `explained_s`: for how long the lesson has been
/// explaining, which it does one sentence at a time (cave/hud/sentences.h), from the first one again
/// after the last; the lines below have their places whichever it is.
void describe(const SeenFrame& seen, const LessonWords& words, const LessonPlan& plan,
              std::span<const RoomViewer> viewers, const LineRoom& room, std::vector<HudLine>& lines,
              bool mayLeave = true, double explained_s = 0.0);

/// Follows the frames and keeps the lines up to date.
class HudText {
 public:
  /// Sets the wall that shows them, and the viewers in the order of the records to follow.
  void setWall(const Wall& wall, std::span<const RoomViewer> viewers);
  /// Sets the game's lesson, and whether it has the button that leaves it.
  void setLesson(const LessonWords& words, const LessonPlan& plan, bool mayLeave = true);

  /// Updates the lines ten times a second, and whenever the text about the views, the lesson or the latest
  /// notice changes. Returns whether it did.
  bool follow(const SeenFrame& seen);

  const std::vector<HudLine>& lines() const { return lines_; }
  bool isBand() const { return isBand_; }  ///< a lesson speaks

 private:
  /// What changes the text at once.
  struct Told {
    TimeViews views;
    WallControls controls;
    LessonState lesson;
    Notice notice;
    std::uint8_t language = 0;
    bool operator==(const Told&) const = default;
  };

  std::vector<HudLine> lines_;
  Told told_;  ///< what was last described
  InLanguages<LessonWords> lesson_;
  InLanguages<LessonPlan> plan_;
  std::vector<RoomViewer> viewers_;
  LineRoom bandRoom_ = kPanelRoom;
  bool isBand_ = false, mayLeave_ = true;
  std::int64_t tenths_s_ = -1;   ///< time of the last description, in tenths
  double explainsFrom_s_ = 0.0;  ///< on the session's clock, since when the lesson explains
};

}  // namespace carom
