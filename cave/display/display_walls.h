#pragma once
// The walls of one node: their pictures, drawn from the shared frame, what lies over these, and the visible
// windows that show them.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cave/display/wall_overlays.h"
#include "cave/display/wall_pictures.h"
#include "cave/display/wall_windows.h"

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
  void setRoom(const RoomGeometry& room);
  /// Shows in every window that the session starts: its first frame can take some seconds.
  void sayStarting();

  /// Returns what lies over the session, to set what the game has of it.
  WallOverlays& overlays() { return overlays_; }

  /// Draws every wall as both eyes see the bodies, or what the operator has chosen instead: a pattern, or
  /// black. `world.histories[i]` is body i of the scene.
  void draw(const FrameRecord& record, const World& world);

  /// Returns the textures of the newest pictures of both eyes of a headset.
  std::array<unsigned, 2> onHead() const;

  /// Returns the newest picture of a wall (the left eye's, if it has one for each eye), or null if this node
  /// draws no wall of that name. `piece`: of a flat piece of a curved wall, counted from 1; 0: of the whole.
  const RenderTarget* pictureOf(const std::string& wall, int piece = 0) const;

  /// Hands over every picture, or for the movie only the first of each wall (its left eye's).
  void capture(Capture& capture, std::uint64_t frame) const { pictures_.capture(capture, frame); }
  void film(Movie& movie, double display_s) const { pictures_.film(movie, display_s); }

  /// Puts the pictures into the windows; `swap` makes them visible. A wall that is held back gets the
  /// pictures of an earlier frame. `over`: draws over the pictures, in a Gui; an empty function draws
  /// nothing.
  void show(const std::function<void()>& over = {}) { windows_.show(drawn_.blank != 0, over); }
  /// Waits until everything is drawn, so that a swap shows it at once.
  void awaitShown() { windows_.awaitShown(); }
  void swap() { windows_.swap(); }

  /// Returns how long the graphics card draws the session on each wall, and how many triangles, for all its
  /// eyes: measured while the latency is shown.
  std::span<const WallTime> drawingTimes() const { return pictures_.drawingTimes(); }

  /// Returns the point of a wall that the mouse points to, over the session's pictures in one of these
  /// windows. While the mouse button is held, the pointer stays with the window in which it was pressed.
  std::optional<PointedWall> pointedAt() const;
  bool isHeld() const { return windows_.isHeld(); }  ///< the mouse's left button was pressed here and is down
  bool isTurning() const { return windows_.isTurning(); }  ///< its right button was

  /// Returns which of the windows a window manager has moved, and where to.
  std::vector<std::string> misplaced() const { return windows_.misplaced(); }
  /// Returns where the window of a wall lies that has one of its own, with a border.
  std::optional<ScreenPlace> placeOf(const std::string& wall) const { return windows_.placeOf(wall); }

  /// Creates the lock of this node's swaps, as the rig asks for it.
  NodeLock lockSwaps(FrameLock asked) { return windows_.lockSwaps(asked); }

 private:
  void drawSession(const FrameRecord& record, const World& world);

  Graphics& graphics_;
  WallPictures pictures_;
  WallOverlays overlays_;
  WallWindows windows_;
  WallControls drawn_;  ///< as the pictures were last drawn
};

}  // namespace carom
