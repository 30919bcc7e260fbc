#pragma once
// Draws the bodies of a scene, chunk by chunk, into the framebuffer that is bound.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "cave/bodies/body_program.h"
#include "cave/bodies/hot_bodies.h"
#include "cave/bodies/soft_drawer.h"
#include "cave/bodies/tiled_surfaces.h"
#include "cave/bodies/visible_chunks.h"
#include "cave/gl/gl_objects.h"
#include "cave/scene/ghosts.h"
#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "engine/light/switches.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// All that the picture of the still bodies of one eye on one wall depends on.
struct StillView {
  std::array<float, 132> numbers{};
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
            const Switches& switches, const Ghosts& ghosts, const SoftLook& soft,
            std::span<const HotBlows> heat);

  /// Chooses what a wall may show; with `everything`, also what it cannot. Surfaces are divided so finely
  /// that nothing is off by more than half of `pixel_rad`. Returns the choice, which holds until the next
  /// `look`.
  struct Choice;
  const Choice& choose(const glm::dmat4& clipFromDrawn, double pixel_rad, bool everything);
  /// Hands the eye's legs and the surfaces of all walls that were chosen for to OpenGL.
  void upload();
  /// What rests on the board and always looks the same from one place, its clocks are not part of it; and all
  /// else. All is drawn by `still` and then `changing`.
  enum class What { still, changing };
  /// Draws the choice, after `upload`.
  void draw(const Choice& choice, What what);
  /// Returns what the picture of the still bodies depends on: while it is the same, so is every pixel of it.
  StillView stillView(const Choice& choice, const glm::ivec2& size_px) const;

 private:
  struct ChosenPart;
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

  void lookAtLamps(const Event& observation);
  void makeVertices();
  void describeVertices(const GlVertexArray& array, const GlBuffer& indices) const;
  void makeColours();
  void takeLayer(ViewTime moment, std::span<const BodyView> bodies, const Lorentz& headFromBoard);
  void takeParts(ViewTime moment, Choice& choice) const;
  void takeSurfaces(std::size_t number, Choice& choice) const;
  void appendSurfaces(Choice& choice);
  void takeSoft(ViewTime moment, Choice& choice) const;
  bool isStill(const ChosenPart& part) const;
  void drawPart(const Choice& choice, const ChosenPart& part);
  void drawSoft(const Choice& choice, const ChosenPart& part);
  void drawTriangles(const Choice& choice, const ChosenPart& chosen);
  void use(unsigned program);
  void bindArray(const GlVertexArray& array);
  PartUniforms uniformsOf(ViewTime moment, std::size_t number) const;
  BodyProgram& programFor(const BodyVariant& variant, BodyProgram*& last);
  bool isHot(const ChosenPart& chosen) const;
  void setState(bool blend, bool keepsAlpha, bool depthMask, bool clip);

  Scene scene_;
  SceneChunks chunks_;
  TiledSurfaces surfaces_;
  SoftDrawer soft_;
  Switches switches_;
  float seenShare_ = 1.0F;  // as Ghosts
  EyeUniforms eye_;
  std::span<const HotBlows> heat_;  // of every body, or none
  std::vector<GpuLeg> legs_;
  std::deque<Choice> choices_;  // since the last look the first `chosen_`; the others keep their memory
  std::size_t chosen_ = 0;
  std::vector<std::uint32_t>
      uploaded_;               // the legs; then, wall by wall, indices of tiles, fine vertices, their indices
  std::vector<Layer> layers_;  // as ViewTime numbers them
  std::vector<std::unique_ptr<BodyProgram>> programs_;
  GlVertexArray array_, tileArray_, fineArray_;
  GlBuffer vertices_, indices_, tileVertices_, colourBuffer_;
  GlBuffer eyeBuffer_;  // of `uploaded_`
  GlTexture legTexture_, colourTexture_;
  unsigned program_ = 0, boundArray_ = 0;  // in use
  bool blend_ = false, keepsAlpha_ = false, depthMask_ = true, clip_ = false;
};

/// A part, or what there is of it of one sort, that one wall shows.
struct BodyDrawer::ChosenPart {
  enum class Sort { chunks, tiles, fine, soft, softShadow };
  ViewTime moment = ViewTime::seen;
  std::size_t number = 0;            ///< in the scene, of a part or of a soft model
  std::size_t first = 0, count = 0;  ///< of ranges; of tiles, of indices in the eye's buffer
  Sort sort = Sort::chunks;
};

/// What one wall shows of what the eye sees.
struct BodyDrawer::Choice {
  glm::dmat4 clipFromDrawn{1.0};
  std::vector<ChosenPart> parts;  ///< in the order in which they are drawn
  std::vector<int> counts;        ///< of indices in each range
  std::vector<const void*> offsets;
  std::size_t levels = 0;     ///< TiledSurfaces::digest
  std::size_t triangles = 0;  ///< of all parts
  /// Where the eye's buffer has the wall's indices of tiles, its fine vertices (counted in vertices) and
  /// their indices.
  std::size_t tileIndices = 0, fineVertices = 0, fineIndices = 0;
};

}  // namespace carom
