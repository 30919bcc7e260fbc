#pragma once
// The marks that the views of time add among the bodies, besides ghosts: paths of pucks, markers of events,
// light on its way, clocks on pucks. Each is drawn where the eye sees it; the light of a flash is drawn where
// it is at the person's board time. Marks for measuring are in cave/marks/measure_marks.h.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cave/frame/lesson_language.h"
#include "cave/marks/lesson_marks.h"
#include "cave/marks/mark_buffer.h"
#include "cave/marks/mark_context.h"
#include "cave/marks/path_ribbons.h"
#include "cave/scene/scene.h"

namespace carom {

/// Adds numbered flags, at rest on the board, where the eye has seen an event happen: for the latest
/// kMostMarkers events, the older the fainter. For flashes it also adds the sphere of their light, of radius
/// c (t − t_e) at the person's board time t, and the ring in which the sphere cuts the cloth: in the colour
/// of the puck that flashes, if there is one of these `colours` (of every body, linear).
/// `flashes`: the names of the game's flashes (cave/frame/event_mark.h).
void addEvents(const MarkContext& sight, std::span<const glm::vec3> colours,
               std::span<const std::string> flashes, LabelLayout& crowd, MarkBuffer& batch);
inline constexpr std::size_t kMostMarkers = 8;
inline constexpr double kEventShown_s = 8.0;  ///< after its light has arrived
inline constexpr double kFlashSeen_s = 0.35;  ///< how long a flash glows
inline constexpr double kSphere_m = 9.0;      ///< radius up to which the light is shown

/// What clocks need to know of every body of the scene.
struct MarkedBodies {
  std::span<const glm::vec3> colours;  ///< linear
  std::span<const double> reach_m;     ///< how far it reaches from its centre, with its shadow's mesh
  std::span<const double> rims_m;      ///< radius (rimsOf of the scene)
};

/// Adds a clock on a stem above each puck, moving with it, that shows the puck's own time at the event where
/// the light left its centre. A large puck that turns evenly and has met nothing has six more around its rim,
/// with the rim's own times, set with the centre's.
void addPuckClocks(const MarkContext& sight, const MarkedBodies& marked, LabelLayout& crowd,
                   MarkBuffer& batch);

/// Adds a clock above the head of each person of another room, in the colour of their coat: their own time
/// where the light left that is seen; and above it their name, if they have one. `firstPerson`: as in Scene.
void addPeopleClocks(const MarkContext& sight, std::size_t firstPerson, LabelLayout& crowd,
                     MarkBuffer& batch);

/// Adds a pin above each ghost, moving with it, so that ghosts can be found and told apart from far away and
/// without colours: a diamond marks "now on the board", a ring "my now", both around the body's own colour.
/// For every body of the scene, `colours` is linear and `tops_m` is how far it reaches up from its centre.
void addBeacons(const MarkContext& sight, std::span<const glm::vec3> colours, std::span<const double> tops_m,
                MarkBuffer& batch);

class SpacetimeMarks {
 public:
  /// Copies what it needs of the scene. Create and destroy it with the drawing context current.
  explicit SpacetimeMarks(const Scene& scene);

  /// Computes the marks for one eye.
  void look(const MarkContext& sight);

  /// Draws the marks into a picture that has the depth of the bodies; `cutAt` as in MarkDrawer::draw.
  void draw(const glm::mat4& clipFromDrawn, unsigned framebuffer, const glm::ivec2& size_px,
            float cutAt = 0.0F) const;

 private:
  std::vector<glm::vec3> colours_;                 // of every body, linear
  std::vector<double> reach_m_, tops_m_, rims_m_;  // of every body
  Ruler ruler_;
  std::vector<LightPath> pulses_;
  InLanguages<LessonPlan> lesson_;
  std::vector<std::string> flashes_;
  std::size_t firstPerson_;
  std::size_t pucks_ = 0;
  PathRibbons paths_;
  MarkBuffer batch_;
  MarkDrawer marks_;
  bool pathsShown_ = false;
  glm::mat4 drawnFromBoard_{1.0F};
};

}  // namespace carom
