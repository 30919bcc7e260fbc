#pragma once
// The walls of one node: a picture for each wall and eye, drawn from the shared frame, and the visible
// windows that show them.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cave/capture/capture.h"
#include "cave/capture/frame_delay.h"
#include "cave/capture/movie.h"
#include "cave/cluster/frame_lock.h"
#include "cave/display/alignment_pattern.h"
#include "cave/display/eye_renderer.h"
#include "cave/display/window.h"
#include "cave/frame/frame_state.h"
#include "cave/overlay/cue_overlay.h"
#include "cave/overlay/hud_panel.h"
#include "cave/overlay/motion_overlay.h"
#include "cave/overlay/room_overlay.h"
#include "cave/projection/projector.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"
#include "cave/room/wall_pointer.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class DisplayWalls {
 public:
  /// `oneWindow`: where given, all walls of a node share that window; otherwise each has its own, or its
  /// viewport in one. A rank that draws for several nodes opens the windows of each. Without `visible`
  /// nothing is shown; the pictures are the same.
  DisplayWalls(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, std::vector<Wall> walls,
               const std::optional<WindowPlacement>& oneWindow, bool visible);

  /// Another game in the same windows.
  void play(const Scene& scene, double lightSpeed_m_s);

  /// What the aids over the session (cave/overlay/room_overlay.h, cave/overlay/hud_panel.h) know of the room;
  /// without it, no more than the walls themselves, and no words.
  void standIn(const RoomGeometry& room);
  /// What the words say of the game's lesson, from now on; empty: there is none.
  void teach(const LessonWords& lesson) { words_.teach(lesson); }

  /// Draws every wall as both eyes see the bodies, or what the operator has put in their place: a pattern, or
  /// black. `world.histories[i]` is body i of the scene.
  void draw(const FrameRecord& record, const World& world);

  /// The newest picture of a wall, its left eye's where it has one for each; null where this node draws no
  /// wall of that name.
  const RenderTarget* pictureOf(const std::string& wall) const;

  /// Hands over every picture, and each wall's first (its left eye's) for the movie.
  void capture(Capture& capture, std::uint64_t frame) const;
  void film(Movie& movie, double display_s) const;

  /// Puts the pictures into the windows, not yet visible; `swap` makes them so. Of a wall that is held back,
  /// those of an earlier frame. `over`: draws over them, in a Gui; empty: nothing.
  void show(const std::function<void()>& over = {});
  /// Waits until all of it is drawn: a swap then shows it at once.
  void awaitShown();
  void swap();

  /// The place of a wall that the mouse points to, over the pictures of the session in one of these windows.
  /// While its button is held, it stays in the window where it was pressed.
  std::optional<PointedWall> pointedAt() const;
  bool isHeld() const;  ///< the mouse's left button was pressed in one of these windows and is down

  /// The lock of this node's swaps, as the rig asks for it.
  NodeLock lockSwaps(FrameLock asked);

 private:
  struct WallEye {
    std::size_t wall = 0;
    Eye eye = Eye::mono;
    FrameDelay pictures;
  };
  /// A window and the walls in it.
  struct WallWindow {
    WindowPlacement placement;
    int node = 0;
    bool shared = false;
    std::vector<std::size_t> walls;
    std::unique_ptr<Window> window;
  };
  void openWindows(const std::optional<WindowPlacement>& oneWindow);
  void drawSession(const FrameRecord& record, const World& world, const ObserverView& observer);
  void drawCalibrationPatterns(bool eyesSwapped);
  void drawAids(const FrameRecord& record, const ObserverView& observer);
  Pane paneOf(std::size_t wall, const glm::ivec2& window_px) const;

  Graphics& graphics_;
  std::unique_ptr<EyeRenderer> session_;
  std::vector<Wall> walls_;
  std::vector<WallEye> wallEyes_;        // of each wall its one or two, the left eye's first
  std::vector<std::size_t> firstEyeOf_;  // of each wall, in there; and where the last ends
  AlignmentPattern seams_;
  RoomGeometry room_;
  std::optional<Wall> front_;  // where the words are
  MotionOverlay motion_;
  RoomOverlay aids_;
  CueOverlay hands_;
  HudPanel words_;
  std::optional<bool> calibrationPatterns_;  // the pictures hold them, with the eyes swapped or not
  bool blank_ = false;
  WallControls drawn_;                                  ///< as the pictures were last drawn
  std::vector<std::optional<Projection>> projections_;  // of each wall, where there are windows
  std::vector<WallWindow> windows_;
  std::vector<PicturedWall> pictured_;  // of one eye
  std::vector<Pane> panes_;
  mutable std::vector<Capture::Taken> taken_;
  mutable std::vector<const RenderTarget*> filmed_;
};

}  // namespace carom
