#pragma once
// Text in the room: a panel of short lines in the plane of the front wall, at its left, as high as the wall
// and the eyes allow. The table is below the eyes, so up there the panel covers nothing of the game. Since it
// lies in the wall's plane, it is the same for both eyes and needs no effort to fuse.
//
// While a lesson speaks, the panel is a band across the whole wall with larger letters, for a group to read,
// and has the lesson's texts alone. It stands above the eyes, as far as the wall reaches up there.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/frame/frame_state.h"
#include "cave/frame/lesson_plan.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/picture.h"
#include "cave/overlay/panel_picture.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// A line of the panel.
struct HudLine {
  std::string text;
  std::optional<glm::vec3> mark;  ///< sRGB colour of a square before it: what in the room the line refers to
  bool urgent = false;            ///< its letters are highlighted
  bool setIn = false;  ///< indented: it continues the line before it, which began with a number or a name

  bool operator==(const HudLine&) const = default;
};

/// Returns the first wall that a person faces, within 45°, when looking forward, or none if the room has no
/// such wall.
std::optional<Wall> frontWall(const RoomGeometry& room);

/// Fills `lines`, whose memory is reused, with the session's text, in lines of `letters`: the latest
/// refusal or event; the lesson's texts for the record's phase, or without a lesson the views of time
/// that are on, each with the colour it is drawn in; with `clocks`, the person's own clock, their speed on
/// the board and the speed of light; with the tracker crosses, what the stereo check
/// (cave/overlay/room_overlay.h) should look like. The text depends on the record and the scenario alone, so
/// all nodes write the same. `lines` is empty if there is no text. `viewers` are those of the record, in its order;
/// where there are several, the score is each one's, and the clocks compare theirs with that of the first.
void describe(const FrameRecord& record, const LessonWords& words, const LessonPlan& plan,
              std::span<const RoomViewer> viewers, std::size_t letters, std::vector<HudLine>& lines);
inline constexpr std::size_t kLineLetters = 40;  ///< without a lesson; longer words are not divided

/// Returns how many letters a line of the band has on a wall.
std::size_t bandLetters(const Wall& wall);

/// Returns whether the band shows the lesson's longest text on this wall in letters of their full height.
bool bandHolds(const LessonWords& words, const LessonPlan& plan, const Wall& wall);

class HudPanel {
 public:
  static constexpr double kCapital_m = 0.04;  ///< height of a capital: 1.5° from 1.5 m, as in printed text
  static constexpr double kMargin = 0.04;    ///< fraction of the wall's height, from its left and upper edges
  static constexpr double kHighest_m = 2.2;  ///< above the floor: the panel's upper edge at most
  /// The largest fractions of the wall's width and height that the panel may take, to leave room for the game
  /// beside it. If the text needs more, its letters get smaller.
  static constexpr double kMostOfWidth = 0.4, kMostOfHeight = 0.4;
  /// The band stands above the height of the eyes over the floor, as far as the wall reaches; a long text may go down
  /// to the second height, above a table in the room.
  static constexpr double kEyes_m = 1.7, kLowest_m = 1.35;
  /// The height of a capital of the band, as a fraction of the picture's height.
  static constexpr double kBandCapital = 1.0 / 40.0;

  /// Create and destroy it with the drawing context current.
  HudPanel() = default;

  /// Returns the height of the panel's upper edge above the wall's lower edge, on a wall whose room has its floor
  /// at height 0.
  static double top_m(const Wall& wall, double margin_m);

  /// Sets the panel's lines; without lines there is no panel. Only lines that have changed are rendered anew,
  /// when they are next drawn.
  void set(const std::vector<HudLine>& lines);

  /// Sets the wall on which the panel is drawn, and the viewers in the order of the records to follow.
  void setWall(const Wall& wall, std::span<const RoomViewer> viewers) {
    bandLetters_ = bandLetters(wall);
    viewers_.assign(viewers.begin(), viewers.end());
  }

  /// Sets the game's lesson.
  void setLesson(const LessonWords& words, const LessonPlan& plan);

  /// Updates the panel from the frame: ten times a second, and whenever its text about the views, the lesson
  /// or the latest notice changes.
  void follow(const FrameRecord& record);

  /// Draws the panel over the picture of the front wall.
  void draw(const Wall& wall, const RenderTarget& picture);

 private:
  struct Written {
    HudLine line;
    GlyphBitmap ink;
  };
  static int endOf_px(const Written& written, int height_px);
  void write(const glm::ivec2& picture_px, const Wall& wall);
  double line() const;
  void paint(const glm::ivec2& size_px, int height_px);
  glm::ivec2 lowerLeft_px(const Wall& wall, const glm::dvec2& pxPerM) const;

  std::vector<Written> lines_;
  std::vector<HudLine> described_;
  TimeViews views_;        ///< the views that were last described
  WallControls controls_;  ///< the controls that were last described
  LessonState lessonState_;
  Notice notice_;
  LessonWords lesson_;
  LessonPlan plan_;
  std::vector<RoomViewer> viewers_;
  std::size_t bandLetters_ = kLineLetters;
  bool band_ = false;           ///< a lesson speaks
  std::int64_t tenths_s_ = -1;  ///< time of the last description, in tenths
  bool written_ = false;
  int height_px_ = 0;         ///< of the rendered letters
  glm::ivec2 picture_px_{0};  ///< size of the picture for which they were rendered
  PanelPicture panel_;
};

}  // namespace carom
