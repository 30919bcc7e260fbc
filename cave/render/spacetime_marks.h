#pragma once
// What the views of time put among the bodies besides ghosts: ways of pucks, markers of events, light on its
// way, clocks on pucks. All of it where the eye sees it, or for the light of a flash where it is at the
// person's board time. What measures is in cave/render/measure_marks.h.

#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cave/render/mark_buffer.h"
#include "cave/render/mark_context.h"
#include "cave/render/path_ribbons.h"
#include "cave/scene/scene.h"

namespace carom {

/// Flags where the eye has seen something happen, each number and all at rest on the board: of the latest
/// kMostMarkers, the older the fainter. And for flashes the sphere of their light, c (t − t_e) around at the
/// person's board time t, with the ring that it draws on the cloth.
void addEvents(const MarkContext& sight, LabelLayout& crowd, MarkBuffer& batch);
inline constexpr std::size_t kMostMarkers = 8;
inline constexpr double kEventShown_s = 8.0;  ///< after its light has come
inline constexpr double kFlashSeen_s = 0.35;  ///< how long one glows
inline constexpr double kSphere_m = 9.0;      ///< radius to which light is followed

/// On a stem above each puck, which moves with it, a clock that shows the puck's own time at the event where
/// the light left its centre. Of every body of the scene: `colours`, linear; `reach_m`, how far they reach
/// from their centres.
void addPuckClocks(const MarkContext& sight, std::span<const glm::vec3> colours,
                   std::span<const double> reach_m, LabelLayout& crowd, MarkBuffer& batch);

/// A pin above each ghost, moving with it, so that it is found and told apart far away and without colours:
/// with a diamond "now on the board", with a ring "my now", around the body's own colour. Of every body of
/// the scene: `colours`, linear; `tops_m`, how far they reach up from their centres.
void addBeacons(const MarkContext& sight, std::span<const glm::vec3> colours, std::span<const double> tops_m,
                MarkBuffer& batch);

class SpacetimeMarks {
 public:
  /// Copies what it needs of the scene. Made and destroyed with the drawing context current.
  explicit SpacetimeMarks(const Scene& scene);

  /// For one eye.
  void look(const MarkContext& sight);

  /// Into a picture whose depth is that of the bodies; `cutAt` as MarkDrawer::draw has it.
  void draw(const glm::mat4& clipFromDrawn, unsigned framebuffer, const glm::ivec2& size_px,
            float cutAt = 0.0F) const;

 private:
  std::vector<glm::vec3> colours_;        // of every body, linear
  std::vector<double> reach_m_, tops_m_;  // of every body
  Ruler ruler_;
  std::vector<LightPath> pulses_;
  std::size_t pucks_ = 0;
  PathRibbons paths_;
  MarkBuffer batch_;
  MarkDrawer marks_;
  bool pathsShown_ = false;
  glm::mat4 drawnFromBoard_{1.0F};
};

}  // namespace carom
