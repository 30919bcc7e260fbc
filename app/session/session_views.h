#pragma once
// The views of a session: the walls, with keys and latency over them, and the room from outside.

#include <vector>

#include "app/input/keys.h"
#include "app/session/director.h"
#include "app/session/frame_statistics.h"
#include "app/session/view.h"
#include "cave/display/display_walls.h"
#include "cave/spectator/spectator_view.h"

namespace carom {

/// The walls of this node. Over their windows: what the keys do, where the operator wants it; how the node's time is
/// spent, where the record says so.
class WallsView : public View {
 public:
  WallsView(DisplayWalls& walls, FrameStatistics& statistics, const Director& director, KeysOf keys)
      : walls_(walls), statistics_(statistics), director_(director), keys_(keyMap(keys)) {}

  void draw(const FrameRecord& record, const World& world) override;
  void swap() override { walls_.swap(); }

 private:
  void drawOver(const LatencyView* latency) const;

  DisplayWalls& walls_;
  FrameStatistics& statistics_;
  const Director& director_;
  std::vector<KeyLine> keys_;
};

/// The room from outside. After the walls, whose pictures it shows.
class OutsideView : public View {
 public:
  OutsideView(SpectatorView& room, const DisplayWalls& walls) : room_(room), walls_(walls) {}

  void draw(const FrameRecord& record, const World& world) override {
    room_.draw(record, world.histories, walls_);
    room_.show();
  }
  void swap() override { room_.swap(); }

 private:
  SpectatorView& room_;
  const DisplayWalls& walls_;
};

/// The last of the views: measures how long the others took. In real time it waits until the graphics card has drawn
/// them, so that the swap follows the others' at once.
class DrawingEnd : public View {
 public:
  DrawingEnd(DisplayWalls& walls, FrameStatistics& statistics, bool realTime)
      : walls_(walls), statistics_(statistics), realTime_(realTime) {}

  void draw(const FrameRecord& record, const World& world) override;

 private:
  DisplayWalls& walls_;
  FrameStatistics& statistics_;
  bool realTime_;
};

}  // namespace carom
