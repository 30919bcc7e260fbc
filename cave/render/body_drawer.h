#pragma once
// Draws the bodies of a scene, chunk by chunk, into the framebuffer that is bound.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/render/body_program.h"
#include "cave/render/ghosts.h"
#include "cave/render/tiled_surfaces.h"
#include "cave/render/visible_chunks.h"
#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "engine/light/switches.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// All that the picture of the still bodies of one eye on one wall depends on.
struct StillView {
  std::array<float, 128> numbers{};
  Switches switches;
  glm::ivec2 size_px{0};
  std::size_t levels = 0;  // of the tiles

  bool operator==(const StillView&) const = default;
};

/// Create, use and destroy it with the drawing context current. It allocates in a frame only what a program
/// that is needed for the first time takes.
class BodyDrawer {
 public:
  BodyDrawer(const Scene& scene, double lightSpeed_m_s);

  /// Sets what one eye sees, as WallRenderer::look.
  void look(const Lorentz& headFromBoard, const EyeView& eye, std::span<const BodyView> bodies,
            const Switches& switches, const Ghosts& ghosts);

  /// Chooses what a wall may show; with `everything`, also what it cannot. Surfaces are divided so finely that
  /// nothing is off by more than half of `pixel_rad`. Returns whether there is anything to draw.
  bool choose(const glm::dmat4& clipFromDrawn, double pixel_rad, bool everything);
  /// What rests on the board and always looks the same from one place, its clocks are not part of it; and all else.
  /// All is drawn by `still` and then `changing`.
  enum class What { still, changing };
  /// Draws what was chosen.
  void draw(const glm::dmat4& clipFromDrawn, What what);
  /// Returns what the picture of the still bodies depends on: while it is the same, so is every pixel of it.
  StillView stillView(const glm::dmat4& clipFromDrawn, const glm::ivec2& size_px) const;

 private:
  /// The range of one body's legs in the buffer.
  struct LegRange {
    int first = 0;
    int count = 0;
    float appears_m = 0.0F;
  };
  /// The bodies as they are seen, or one kind of ghosts.
  struct Layer {
    Layer(const SceneChunks& chunks, std::size_t bodies, std::size_t parts)
        : visible(chunks), programs(parts) {
      ranges.reserve(bodies);
    }
    std::vector<LegRange> ranges;  // of each body; empty: not drawn
    glm::mat4 drawnFromSeen{1.0F};
    VisibleChunks visible;
    std::vector<BodyProgram*> programs;  // of each part, the last it was drawn with
  };

  void makeVertices();
  void describeVertices(const GlVertexArray& array, const GlBuffer& indices) const;
  void makeColours();
  void takeLayer(ViewTime moment, std::span<const BodyView> bodies, const Lorentz& headFromBoard);
  void uploadLegs();
  void drawLayer(ViewTime moment, What what, const WallUniforms& wall);
  bool isStill(std::size_t number) const;
  void drawPart(ViewTime moment, std::size_t number, const WallUniforms& wall);
  PartUniforms uniformsOf(ViewTime moment, std::size_t number) const;
  BodyProgram& programFor(const BodyVariant& variant, BodyProgram*& last);
  void setState(bool blend, bool depthMask, bool clip);

  Scene scene_;
  SceneChunks chunks_;
  TiledSurfaces surfaces_;
  Switches switches_;
  EyeUniforms eye_;
  std::uint64_t walls_ = 0;
  std::vector<GpuLeg> legs_;
  std::vector<Layer> layers_;  // as ViewTime numbers them
  std::vector<std::unique_ptr<BodyProgram>> programs_;
  GlVertexArray array_, tileArray_;
  GlBuffer vertices_, indices_, tileIndices_, legBuffer_, colourBuffer_;
  GlTexture legTexture_, colourTexture_;
  bool blend_ = false, depthMask_ = true, clip_ = false;
};

}  // namespace carom
