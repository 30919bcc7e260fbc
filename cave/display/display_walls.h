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
#include "cave/display/parallel_calls.h"
#include "cave/display/window.h"
#include "cave/frame/frame_state.h"
#include "cave/overlay/choice_tiles.h"
#include "cave/overlay/comfort_overlay.h"
#include "cave/overlay/cue_overlay.h"
#include "cave/overlay/home_arrow.h"
#include "cave/overlay/hud_panel.h"
#include "cave/overlay/latency_overlay.h"
#include "cave/overlay/motion_overlay.h"
#include "cave/overlay/room_overlay.h"
#include "cave/overlay/standing_board.h"
#include "cave/projection/projector.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"
#include "cave/room/wall_pointer.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class DisplayWalls {
 public:
  /// `oneWindow`: if given, all walls of a node share that window; otherwise each wall has its own window, or
  /// its viewport in a shared one. A rank that draws for several nodes opens the windows of each. `visible`:
  /// if false, no window opens; the pictures are the same.
  DisplayWalls(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, std::vector<Wall> walls,
               const std::optional<WindowPlacement>& oneWindow, bool visible);

  /// Shows another game in the same windows.
  void setScene(const Scene& scene, double lightSpeed_m_s);

  /// Gives the room to the overlays over the session (cave/overlay/room_overlay.h, cave/overlay/hud_panel.h).
  /// Without it they know only the walls, and there is no HUD panel.
  void setRoom(const RoomGeometry& room);
  /// Sets the game's lesson for the HUD panel; empty texts mean no lesson.
  void setLesson(const LessonWords& words, const LessonPlan& plan) {
    for (HudPanel& panel : words_) panel.setLesson(words, plan);
  }
  /// Sets whether the game offers the three choices (cave/overlay/choice_tiles.h).
  void setChoices(bool offered) { offersChoices_ = offered; }

  /// Sets whether the game has a table to come home to (cave/overlay/home_arrow.h).
  void setTable(bool there) { hasTable_ = there; }

  /// Draws every wall as both eyes see the bodies, or what the operator has chosen instead: a pattern, or
  /// black. `world.histories[i]` is body i of the scene.
  void draw(const FrameRecord& record, const World& world);

  /// Returns the textures of the newest pictures of both eyes of a headset.
  std::array<unsigned, 2> onHead() const {
    return {wallEyes_[0].pictures.drawn().texture(), wallEyes_[1].pictures.drawn().texture()};
  }

  /// Returns the newest picture of a wall (the left eye's, if it has one for each eye), or null if this node
  /// draws no wall of that name.
  const RenderTarget* pictureOf(const std::string& wall) const;

  /// Hands over every picture, or for the movie only the first of each wall (its left eye's).
  void capture(Capture& capture, std::uint64_t frame) const;
  void film(Movie& movie, double display_s) const;

  /// Puts the pictures into the windows; `swap` makes them visible. A wall that is held back gets the
  /// pictures of an earlier frame. `over`: draws over the pictures, in a Gui; an empty function draws
  /// nothing.
  void show(const std::function<void()>& over = {});
  /// Returns how long the graphics card draws the session on each wall, and how many triangles, for all its eyes:
  /// measured while the latency is shown.
  std::span<const WallTime> drawingTimes() const;
  /// Waits until everything is drawn, so that a swap shows it at once.
  void awaitShown();
  void swap();

  /// Returns the point of a wall that the mouse points to, over the session's pictures in one of these
  /// windows. While the mouse button is held, the pointer stays with the window in which it was pressed.
  std::optional<PointedWall> pointedAt() const;
  bool isHeld() const;     ///< the mouse's left button was pressed in one of these windows and is down
  bool isTurning() const;  ///< its right button was

  /// Returns which of the windows a window manager has moved, and where to.
  std::vector<std::string> misplaced() const;
  /// Returns where the window of a wall lies that has one of its own, with a border.
  std::optional<ScreenPlace> placeOf(const std::string& wall) const;

  /// Creates the lock of this node's swaps, as the rig asks for it.
  NodeLock lockSwaps(FrameLock asked);

 private:
  struct WallEye {
    std::size_t wall = 0;
    ViewerEye eye;
    FrameDelay pictures;
    WallMeters meters;
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
  void swapTogether();
  void drawSession(const FrameRecord& record, const World& world, std::size_t viewer);
  void drawCalibrationPatterns(bool eyesSwapped);
  void hangOnHead(const HeadsetState& headset);
  void drawAids(const FrameRecord& record, std::size_t viewer);
  void drawOnFront(const FrameRecord& record, std::size_t viewer, const Wall& front, const glm::dvec3& eye_m,
                   const RenderTarget& picture);
  Pane paneOf(std::size_t wall, const glm::ivec2& window_px) const;

  Graphics& graphics_;
  std::unique_ptr<EyeRenderer> session_;
  std::vector<Wall> walls_;
  std::vector<WallEye> wallEyes_;        // of each wall one or two, in the order of its channels
  std::vector<std::size_t> firstEyeOf_;  // index in wallEyes_, of each wall; then the end of the last
  AlignmentPattern seams_;
  std::array<RoomGeometry, kMostViewers> rooms_;  // as each viewer sees it
  std::optional<Wall> front_;                     // the wall with the HUD panel
  std::optional<StandingBoard> board_;            // in the place of that wall, for a headset's wearer
  ComfortOverlay comfort_;
  HomeArrow home_;
  MotionOverlay motion_;
  RoomOverlay aids_;
  CueOverlay hands_;
  std::array<HudPanel, kMostViewers> words_;  // of each viewer
  ChoiceTiles choices_;
  bool hasTable_ = false;  ///< in the game
  bool offersChoices_ = false;
  std::optional<bool> calibrationPatterns_;  // the pictures are these; true: with the eyes swapped
  bool blank_ = false;
  WallControls drawn_;                                  ///< as the pictures were last drawn
  std::vector<std::optional<Projection>> projections_;  // of each wall, where there are windows
  std::vector<WallWindow> windows_;
  std::unique_ptr<ParallelCalls> swaps_;  // of several windows
  std::vector<PicturedWall> pictured_;    // of one eye
  std::vector<Pane> panes_;
  mutable std::vector<Capture::Taken> taken_;
  mutable std::vector<WallTime> times_;
  bool split_ = false;  // the newest pictures
  mutable std::vector<const RenderTarget*> filmed_;
};

}  // namespace carom
