#pragma once
// The console's thumbnails of the walls: this node's walls as drawn; for other nodes' walls the node that
// draws them and, if wanted, images rendered here once per second.

#include <memory>
#include <string>
#include <vector>

#include "app/console_parts/console_parts.h"
#include "app/rig/rig.h"
#include "cave/cluster/cluster.h"
#include "cave/room/room_geometry.h"

namespace carom::console {

class WallsPanel {
 public:
  /// Shows the walls of `rig`. All arguments must outlive this object.
  WallsPanel(Graphics& graphics, const Rig& rig, const Cluster& cluster);

  /// Switches to another game. `scene` must stay valid.
  void play(const Scene& scene, double lightSpeed_m_s);

  /// Renders the images of other nodes' walls if they are due. Needs the drawing context to be current.
  void prepare(const ConsoleFrame& frame);
  /// Fills the rest of the window with the thumbnails.
  void draw(const ConsoleFrame& frame);

 private:
  void drawTile(const ConsoleFrame& frame, const Wall& wall, const ImVec2& size_px);
  void drawAbsent(const ConsoleFrame& frame, const Wall& wall, const ImVec2& from, const ImVec2& to) const;
  void drawMissing() const;
  std::size_t columnsFor(const ImVec2& room_px, float label_px) const;

  Graphics& graphics_;
  const Rig& rig_;
  const Cluster& cluster_;
  RoomGeometry room_;
  std::vector<Wall> absent_;  ///< walls of other nodes, small and mono
  const Scene* scene_ = nullptr;
  double lightSpeed_m_s_ = 0.0;
  bool drawsAbsent_ = false;
  std::unique_ptr<DisplayWalls> copies_;  ///< renders `absent_`; null until wanted
  double copied_s_ = 0.0;                 ///< session clock
};

}  // namespace carom::console
