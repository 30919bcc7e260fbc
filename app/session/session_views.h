#pragma once
// The views of a session: the walls with their overlays of keys and latency, and the spectator view.

#include <vector>

#include "app/input/keys.h"
#include "app/session/director.h"
#include "app/session/frame_statistics.h"
#include "app/session/view.h"
#include "cave/display/display_walls.h"
#include "cave/headset/headset.h"
#include "cave/spectator/spectator_view.h"

namespace carom {

/// Draws the walls of this node. Overlays the list of keys if the operator wants it, and the latency if the
/// frame record says so, and the console's tile.
class WallsView : public View {
 public:
  /// `pressed`: takes the commands of what is pressed in the windows; null: nothing there can be.
  /// `hasConsoleTile`: a tile shows the operator's console while that waits.
  WallsView(DisplayWalls& walls, FrameStatistics& statistics, const Director& director, KeysOf keys,
            Commands* pressed = nullptr, bool hasConsoleTile = false)
      : walls_(walls),
        statistics_(statistics),
        director_(director),
        keys_(keys),
        pressed_(pressed),
        hasConsoleTile_(hasConsoleTile) {}

  void draw(const FrameRecord& record, const World& world) override;
  void swap() override { walls_.swap(); }

 private:
  void drawOver(const LatencyView* latency);

  DisplayWalls& walls_;
  FrameStatistics& statistics_;
  const Director& director_;
  KeyList keys_;
  Commands* pressed_;
  bool hasConsoleTile_;
};

/// Hands the pictures of both eyes over to the headset.
class HeadsetView : public View {
 public:
  HeadsetView(Headset& headset, const DisplayWalls& walls) : headset_(headset), walls_(walls) {}

  void draw(const FrameRecord&, const World&) override {}
  void swap() override {
    const std::array<unsigned, 2> pictures = walls_.onHead();
    headset_.submit(&pictures);
  }

 private:
  Headset& headset_;
  const DisplayWalls& walls_;
};

/// Draws the spectator view of the room. It must be drawn after the walls because it shows their images.
class SpectatorWindow : public View {
 public:
  SpectatorWindow(SpectatorView& room, const DisplayWalls& walls) : room_(room), walls_(walls) {}

  void draw(const FrameRecord& record, const World& world) override {
    room_.draw(record, world, walls_);
    room_.show();
  }
  void swap() override { room_.swap(); }

 private:
  SpectatorView& room_;
  const DisplayWalls& walls_;
};

/// The last view: measures the drawing time of the others. In real time, waits until the GPU has finished so
/// that all views swap without delay.
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
