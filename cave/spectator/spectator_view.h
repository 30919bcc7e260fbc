#pragma once
// The room from outside: its walls with what they show at this moment, the person's head with its lines of
// sight to the walls' corners, the hand, and the table and the pucks where they are in the room at this
// moment of the room's time, not where they are seen. A picture of its own, and perhaps a window.

#include <memory>
#include <span>
#include <vector>

#include "cave/capture/capture.h"
#include "cave/display/display_walls.h"
#include "cave/display/window.h"
#include "cave/frame/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/scene/scene.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class SpectatorView {
 public:
  static constexpr glm::ivec2 kPicture_px{1440, 900};  ///< where there is no window

  /// `table`: the parts of `scene` that rest on the board have a hall around them; these stand in their
  /// place. Without `visible` there is no window.
  SpectatorView(Graphics& graphics, const RoomGeometry& room, const Scene& scene,
                std::span<const ScenePart> table, bool visible);
  ~SpectatorView();
  SpectatorView(const SpectatorView&) = delete;
  SpectatorView& operator=(const SpectatorView&) = delete;

  /// Another game.
  void play(const Scene& scene, std::span<const ScenePart> table);

  /// Draws the frame, after the walls. A wall that `walls` does not draw is an empty panel with its name.
  /// `histories[i]` is body i of the scene.
  void draw(const FrameRecord& record, std::span<const WorldLine> histories, const DisplayWalls& walls);

  const RenderTarget& picture() const;
  /// It, to be written as outside-mono-FRAME.png.
  Capture::Taken taken() const;

  /// Into the window, if there is one; `swap` makes it visible. There, a drag turns the room and the wheel
  /// comes nearer.
  void show();
  void swap();

 private:
  struct Drawing;  // OpenGL's
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace carom
