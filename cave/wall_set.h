#pragma once
// The walls of one node: a picture for each wall and eye, drawn from the shared frame, and the visible
// windows that show them.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cave/frame_state.h"
#include "cave/picture.h"
#include "cave/projector.h"
#include "cave/seam_pattern.h"
#include "cave/wall.h"
#include "cave/wall_renderer.h"
#include "cave/window.h"
#include "engine/light_cone.h"
#include "engine/observer.h"
#include "engine/world_line.h"

namespace carom {

class WallSet {
 public:
  /// `oneWindow`: where given, all walls share that window; otherwise each has its own. Without `visible`
  /// nothing is shown; the pictures are the same.
  WallSet(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, std::vector<Wall> walls,
          const std::optional<WindowPlacement>& oneWindow, bool visible);

  /// Draws every wall as both eyes see the bodies, or what the operator has put in their place: a pattern, or
  /// black. `histories[i]` is body i of the scene.
  void draw(const FrameRecord& record, std::span<const WorldLine> histories);

  /// Writes every picture as DIR/<wall>-<eye>-<frame>.png.
  void capture(const std::filesystem::path& directory, std::uint64_t frame);

  /// Puts the pictures into the windows, not yet visible; `swap` makes them so.
  void show();
  void swap();

  const std::vector<Wall>& walls() const { return walls_; }

 private:
  struct WallEye {
    std::size_t wall = 0;
    Eye eye = Eye::mono;
    std::unique_ptr<WallPicture> picture;
  };
  const WallPicture* pictureOf(std::size_t wall, Eye eye) const;
  void drawSession(const ObserverView& observer, std::span<const WorldLine> histories,
                   const Switches& switches);
  void drawTestPatterns(bool eyesSwapped);
  Pane paneOf(std::size_t wall, const glm::ivec2& position_px, const glm::ivec2& size_px) const;

  Graphics& graphics_;
  WallRenderer renderer_;
  std::vector<Wall> walls_;
  bool oneWindow_;
  std::vector<WallEye> wallEyes_;
  SeamPattern seams_;
  std::optional<bool> testPatterns_;  // the pictures hold them, with the eyes swapped or not
  bool blank_ = false;
  std::vector<std::optional<Projection>> projections_;  // of each wall, where there are windows
  std::vector<std::unique_ptr<Window>> windows_;
  std::vector<BodyView> bodies_;
  std::vector<Pane> panes_;
};

}  // namespace carom
