#pragma once
// The room from outside: its walls with their current pictures, the person's head with its lines of sight to
// the walls' corners, the hand, and the table and the pucks where they are in the room at this time of the
// room's clock, not where they are seen. It is drawn into a picture of its own and, if wanted, shown in a
// window.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cave/capture/capture.h"
#include "cave/display/display_walls.h"
#include "cave/display/window.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/scene/scene.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class SpectatorView {
 public:
  static constexpr glm::ivec2 kPicture_px{1440, 900};  ///< where there is no window

  /// `table`: parts that are drawn instead of those of `scene` that rest on the board, which include a hall.
  /// `window`: where its window opens; empty: there is none.
  SpectatorView(Graphics& graphics, const RoomGeometry& room, const Scene& scene,
                std::span<const ScenePart> table, const std::optional<WindowPlacement>& window);
  ~SpectatorView();
  SpectatorView(const SpectatorView&) = delete;
  SpectatorView& operator=(const SpectatorView&) = delete;

  /// Shows another game.
  void setScene(const Scene& scene, std::span<const ScenePart> table);

  /// Draws the frame; call it after the walls are drawn. A wall that `walls` does not draw is an empty panel
  /// with its name. `world` has the scene's bodies.
  void draw(const FrameRecord& record, const World& world, const DisplayWalls& walls);

  const RenderTarget& picture() const;
  /// Returns the picture for capture, to be written as outside-mono-FRAME.png.
  Capture::Taken taken() const;

  /// Draws into the window, if there is one; `swap` makes it visible. In the window, a drag turns the room
  /// and the wheel moves the camera.
  void show();
  void swap();
  std::optional<ScreenPlace> place() const;  ///< of its window

 private:
  struct Drawing;  // holds the OpenGL objects
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace carom
