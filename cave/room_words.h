#pragma once
// Words in the room: a panel of short lines at rest in the plane of the front wall, near its lower edge.
// Lying in the wall's plane, it is the same for both eyes and asks for no effort to fuse.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/frame_state.h"
#include "cave/picture.h"
#include "cave/room_facts.h"
#include "cave/text_ink.h"
#include "cave/wall.h"

namespace carom {

/// A line of the panel.
struct RoomLine {
  std::string text;
  std::optional<glm::vec3> mark;  ///< sRGB colour of a square before it: what in the room it speaks of

  bool operator==(const RoomLine&) const = default;
};

/// The first wall that the person faces who looks forward: within 45° of it. None: no wall of the room is
/// one.
std::optional<Wall> frontWall(const RoomFacts& room);

/// What a session says: the views of time that are on, each with the colour it is drawn in; with `clocks` the
/// person's own clock, their speed on the board and light's; with the tracker crosses what the stereo check
/// (cave/room_aids.h) should look like. Made from the record alone, so all
/// nodes write the same. Fills `lines`, whose memory is used again; empty where there is nothing to say.
void describe(const FrameRecord& record, std::vector<RoomLine>& lines);

class RoomWords {
 public:
  static constexpr double kCapital_m = 0.04;  ///< height of a capital: 1.5° from 1.5 m, as print is read
  static constexpr double kMargin_m = 0.12;   ///< from the wall's left and lower edges to the panel

  /// Made and destroyed with the drawing context current.
  RoomWords();
  ~RoomWords();
  RoomWords(const RoomWords&) = delete;
  RoomWords& operator=(const RoomWords&) = delete;

  /// What the panel says from now on; none: it is not there. Only lines that have changed are written anew,
  /// when they are next drawn.
  void set(const std::vector<RoomLine>& lines);

  /// Has the panel describe the frames: ten times a second, and when a view is turned on or off.
  void follow(const FrameRecord& record);

  /// Over the picture of the front wall.
  void draw(const Wall& wall, const WallPicture& picture);

 private:
  struct Written {
    RoomLine line;
    Ink ink;
  };
  void write(const glm::ivec2& picture_px, const glm::dvec2& size_m);
  void upload(const glm::ivec2& size_px, int height_px);

  std::vector<Written> lines_;
  std::vector<RoomLine> described_;
  TimeViews views_;             ///< that were described
  WallControls controls_;       ///< and these
  std::int64_t tenths_s_ = -1;  ///< when
  std::vector<std::uint8_t> rgba_;
  bool written_ = false;
  int height_px_ = 0;         ///< of the letters that are written
  glm::ivec2 picture_px_{0};  ///< of the picture that they were written for
  glm::ivec2 size_px_{0};     ///< of the panel
  unsigned program_ = 0, vertexArray_ = 0, texture_ = 0;
};

}  // namespace carom
