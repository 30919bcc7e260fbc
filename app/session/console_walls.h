#pragma once
// The console's walls in small: what this node draws as it is; of other nodes' walls who draws them and, if
// wanted, pictures made here once a second.

#include <memory>
#include <string>
#include <vector>

#include "app/files/rig.h"
#include "app/session/console_parts.h"
#include "cave/cluster/cluster.h"
#include "cave/room/room_geometry.h"

namespace carom::console {

class WallsPanel {
 public:
  /// All are kept.
  WallsPanel(Graphics& graphics, const Rig& rig, const Cluster& cluster);

  /// Another game. `scene` is kept.
  void play(const Scene& scene, double lightSpeed_m_s);

  /// Draws the pictures of other nodes' walls where it is time for them, in the drawing context.
  void prepare(const ConsoleFrame& frame);
  /// Fills what is left of the window.
  void draw(const ConsoleFrame& frame);

 private:
  void drawTile(const ConsoleFrame& frame, const Wall& wall, const ImVec2& size_px);
  void drawAbsent(const ConsoleFrame& frame, const Wall& wall, const ImVec2& from, const ImVec2& to) const;
  std::size_t columnsFor(const ImVec2& room_px, float label_px) const;

  Graphics& graphics_;
  const Rig& rig_;
  const Cluster& cluster_;
  RoomGeometry room_;
  std::vector<Wall> absent_;  ///< drawn by other nodes: small, for one eye
  const Scene* scene_ = nullptr;
  double lightSpeed_m_s_ = 0.0;
  bool drawsAbsent_ = false;
  std::unique_ptr<DisplayWalls> copies_;  ///< of those, once they are wanted
  double copied_s_ = 0.0;                 ///< session clock
};

}  // namespace carom::console
