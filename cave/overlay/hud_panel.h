#pragma once
// Words in the room: a panel of short lines at rest in the plane of the front wall, at its left, as high as
// it is read from and the wall allows: the table is below the eyes, so that there it covers nothing of the
// game. Lying in the wall's plane, it is the same for both eyes and asks for no effort to fuse.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/frame/frame_state.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/picture.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// A line of the panel.
struct HudLine {
  std::string text;
  std::optional<glm::vec3> mark;  ///< sRGB colour of a square before it: what in the room it speaks of
  bool urgent = false;            ///< its letters stand out
  bool setIn = false;             ///< it goes on with what the line before it began with a number or a name

  bool operator==(const HudLine&) const = default;
};

/// The first wall that the person faces who looks forward: within 45° of it. None: no wall of the room is
/// one.
std::optional<Wall> frontWall(const RoomGeometry& room);

/// What a session says, in lines of kLineLetters: what was just refused or happened; the lesson's words for
/// the phase that the record is in; the views of time that are on, each with the colour it is drawn in; with
/// `clocks` the person's own clock, their speed on the board and light's; with the tracker crosses what the
/// stereo check (cave/overlay/room_overlay.h) should look like. Made from the record and the scenario alone, so
/// all nodes write the same. Fills `lines`, whose memory is used again; empty where there is nothing to say.
void describe(const FrameRecord& record, const LessonWords& lesson, std::vector<HudLine>& lines);
inline constexpr std::size_t kLineLetters = 40;  ///< a word that is longer stays whole

class HudPanel {
 public:
  static constexpr double kCapital_m = 0.04;  ///< height of a capital: 1.5° from 1.5 m, as print is read
  static constexpr double kMargin = 0.04;     ///< of the wall's height, from its left and upper edges
  static constexpr double kHighest_m = 2.2;   ///< above the floor, for the panel's upper edge
  /// Of the wall's width and height, for the panel at most: beside it there must be room for the game. Where
  /// the words would need more, their letters are smaller.
  static constexpr double kMostOfWidth = 0.4, kMostOfHeight = 0.4;

  /// Made and destroyed with the drawing context current.
  HudPanel();
  ~HudPanel();
  HudPanel(const HudPanel&) = delete;
  HudPanel& operator=(const HudPanel&) = delete;

  /// What the panel says from now on; none: it is not there. Only lines that have changed are written anew,
  /// when they are next drawn.
  void set(const std::vector<HudLine>& lines);

  /// What it says of a lesson, from now on.
  void teach(const LessonWords& lesson);

  /// Has the panel describe the frames: ten times a second, and when what it says of the views, of the lesson
  /// or of what happened changes.
  void follow(const FrameRecord& record);

  /// Over the picture of the front wall.
  void draw(const Wall& wall, const RenderTarget& picture);

 private:
  struct Written {
    HudLine line;
    GlyphBitmap ink;
  };
  static int endOf_px(const Written& written, int height_px);
  void write(const glm::ivec2& picture_px, const glm::dvec2& size_m);
  void upload(const glm::ivec2& size_px, int height_px);
  glm::ivec2 lowerLeft_px(const Wall& wall, const glm::dvec2& pxPerM) const;

  std::vector<Written> lines_;
  std::vector<HudLine> described_;
  TimeViews views_;        ///< that were described
  WallControls controls_;  ///< and these
  LessonState lessonState_;
  Notice notice_;
  LessonWords lesson_;
  std::int64_t tenths_s_ = -1;  ///< when
  std::vector<std::uint8_t> rgba_;
  bool written_ = false;
  int height_px_ = 0;         ///< of the letters that are written
  glm::ivec2 picture_px_{0};  ///< of the picture that they were written for
  glm::ivec2 size_px_{0};     ///< of the panel
  unsigned program_ = 0, vertexArray_ = 0, texture_ = 0;
};

}  // namespace carom
