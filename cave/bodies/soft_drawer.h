#pragma once
// Keeps the soft bodies of a scene for OpenGL: their meshes, and for one eye after the other the vertices as
// it sees them (cave/bodies/seen_rows.h). BodyDrawer draws them among the others.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cave/bodies/seen_rows.h"
#include "cave/gl/gl_objects.h"
#include "cave/scene/scene.h"
#include "engine/light/switches.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// What there is to see of soft bodies.
struct SoftLook {
  std::span<const SoftPast> bodies;  ///< of every body of the scene, or none
  Told told = Told::nothing;
  std::optional<Event> boardNow{}, myNow{};  ///< the observations of the ghosts that are drawn
};

/// Create, use and destroy it with the drawing context current.
class SoftDrawer {
 public:
  explicit SoftDrawer(const Scene& scene);

  /// Sets what one eye sees, before `upload`.
  void look(const Lorentz& headFromBoard, const EyeView& eye, const Switches& switches, const SoftLook& soft);
  /// Hands it to OpenGL.
  void upload();

  /// Whether a body is drawn here, and not as a rigid one.
  bool has(std::size_t body) const { return body < has_.size() && has_[body] != 0; }
  /// Whether a wall with this projection may show a model's picture at a moment, or what reaches beyond it by
  /// so much.
  bool mayShow(ViewTime moment, std::size_t model, const glm::dmat4& clipFromDrawn,
               double beyond_m = 0.0) const;
  std::size_t modelCount() const { return models_.size(); }
  const SoftModel& model(std::size_t number) const { return models_[number]; }
  const SeenBound& bound(ViewTime moment, std::size_t model) const { return layerOf(moment).bounds[model]; }
  Told told() const { return told_; }

  /// The array of the vertices at a moment, and a model's surface or its shadow in it.
  const GlVertexArray& array(ViewTime moment) const { return layerOf(moment).array; }
  void drawTriangles(std::size_t model, bool isShadow) const;

 private:
  /// The bodies at one moment.
  struct Layer {
    std::vector<SeenVertex> vertices;  ///< of all models, drawn or not
    std::vector<SeenBound> bounds;     ///< of each model; of radius −1: it is not drawn
    GlVertexArray array;
    GlBuffer buffer;
  };
  /// Where a model is in the buffers.
  struct Place {
    std::size_t firstVertex = 0, surface = 0, shadow = 0;  ///< of indices: bytes
  };
  const Layer& layerOf(ViewTime moment) const { return layers_[static_cast<std::size_t>(moment)]; }
  void see(ViewTime moment, const Event& observation, const Lorentz& headFromBoard, const Switches& switches,
           std::span<const SoftPast> bodies);
  void describe(const Layer& layer) const;

  std::vector<SoftModel> models_;
  std::vector<Place> places_;
  std::vector<char> has_;  // by body
  std::array<Layer, 3> layers_;
  GlBuffer painted_, indices_;
  SeenRows seenRows_;
  Told told_ = Told::nothing;
};

}  // namespace carom
