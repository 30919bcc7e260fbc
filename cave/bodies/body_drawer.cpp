#include "cave/bodies/body_drawer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include <vtk_glew.h>

#include "cave/frame/bodies.h"
#include "cave/frame/clock_time.h"
#include "cave/gl/view_colours.h"
#include "engine/colour/doppler_colour.h"
#include "engine/colour/exposure.h"
#include "engine/light/spin_steps.h"

namespace carom {
namespace {

constexpr float kAlways_m = -1e30F;       // means that the body has always existed
constexpr float kDecalNearer = 0.002F;    // fraction of the distance by which a decal is drawn nearer
constexpr float kBodiesNearer = 0.0005F;  // the same of the last body
constexpr float kSoftRoughness = 0.25F;
constexpr double kPointReach_m = 0.03;  // stands for that of a told body

/// Makes a texture of the four numbers a texel that a buffer holds.
void attach(const GlTexture& texture, const GlBuffer& buffer) {
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
}

/// Binds the textures of colours and legs, or nothing, to their units, and leaves the first unit active.
static_assert(kLegUnit == 0 && kColourUnit == 1);
void bindTextures(GLuint colours, GLuint legs) {
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_BUFFER, colours);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, legs);
}

void enable(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

/// Returns which shader draws a body with these legs. A round body is drawn as if it did not spin.
Legs legsOf(std::span<const GpuLeg> legs, bool round) {
  const bool spins =
      !round && std::any_of(legs.begin(), legs.end(), [](const GpuLeg& leg) { return leg.spin.w > 0.0F; });
  const bool glides =
      std::any_of(legs.begin(), legs.end(), [](const GpuLeg& leg) { return leg.glide.w > 0.0F; });
  if (glides || legs.size() > 2 || (spins && legs.size() == 2))
    return spins ? Legs::manySpinning : Legs::many;
  if (!spins) return legs.size() == 2 ? Legs::aroundTurn : Legs::one;
  const GpuLeg& first = legs.front();
  const bool even = first.spinSlows.y == 0.0F && first.spin.w <= kFewSpinSteps;
  return even ? Legs::oneSpinning : Legs::manySpinning;
}

/// Whether a body is seen to be soft at a moment, and not drawn by its parts.
bool isDrawnSoft(const SoftDrawer& soft, ViewTime moment, std::size_t body) {
  if (!soft.has(body)) return false;
  for (std::size_t number = 0; number < soft.modelCount(); ++number) {
    if (soft.model(number).body == body) return soft.bound(moment, number).radius >= 0.0;
  }
  return false;
}

}  // namespace

BodyDrawer::BodyDrawer(const Scene& scene, double lightSpeed_m_s)
    : scene_(scene), chunks_(scene), surfaces_(chunks_), soft_(scene) {
  eye_.lightSpeed_m_s = static_cast<float>(lightSpeed_m_s);
  for (std::size_t i = 0; i < 3; ++i) eye_.lamps_m[i] = glm::vec3(scene.lamps_m[i]);
  eye_.hall_m = hallBounds_m(scene.hall);
  layers_.reserve(kViewTimes.size());
  for (std::size_t i = 0; i < kViewTimes.size(); ++i)
    layers_.emplace_back(chunks_, scene_.bodyCount, scene_.parts.size());
  makeVertices();
  makeColours();
  upload();  // a buffer exists from its first use on
  attach(legTexture_, eyeBuffer_);
}

void BodyDrawer::makeVertices() {
  const ChunkedMeshes& meshes = chunks_.meshes;
  const auto fill = [](const GlBuffer& buffer, const std::vector<MeshVertex>& vertices) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(MeshVertex)),
                 vertices.data(), GL_STATIC_DRAW);
  };
  fill(vertices_, meshes.vertices);
  chunks_.meshes.vertices = {};
  describeVertices(array_, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(meshes.indices.size() * sizeof(std::uint32_t)), meshes.indices.data(),
               GL_STATIC_DRAW);
  fill(tileVertices_, meshes.tileVertices);
  describeVertices(tileArray_, eyeBuffer_);
  glBindBuffer(GL_ARRAY_BUFFER, eyeBuffer_);
  describeVertices(fineArray_, eyeBuffer_);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

/// Makes the array's vertices those in the buffer that is bound, by these indices, and leaves it bound.
void BodyDrawer::describeVertices(const GlVertexArray& array, const GlBuffer& indices) const {
  glBindVertexArray(array);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  constexpr std::array<std::size_t, 3> kOffsets{offsetof(MeshVertex, place_m), offsetof(MeshVertex, normal),
                                                offsetof(MeshVertex, surface)};
  for (std::size_t i = 0; i < kOffsets.size(); ++i) {
    glEnableVertexAttribArray(static_cast<GLuint>(i));
    glVertexAttribPointer(static_cast<GLuint>(i), 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                          reinterpret_cast<const void*>(kOffsets[i]));
  }
  glEnableVertexAttribArray(3);
  glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(MeshVertex),
                        reinterpret_cast<const void*>(offsetof(MeshVertex, lit)));
}

void BodyDrawer::makeColours() {
  const ColourTable table;
  glBindBuffer(GL_TEXTURE_BUFFER, colourBuffer_);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(table.texels().size() * sizeof(table.texels()[0])),
               table.texels().data(), GL_STATIC_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  attach(colourTexture_, colourBuffer_);
}

void BodyDrawer::takeLayer(ViewTime moment, std::span<const BodyView> bodies, const Lorentz& headFromBoard) {
  Layer& layer = layers_[static_cast<std::size_t>(moment)];
  const ViewFrame frame(headFromBoard, switches_, moment);
  layer.drawnFromSeen = glm::mat4(frame.drawnFromSeen.matrix());
  layer.ranges.clear();
  for (const BodyView& body : bodies) {
    layer.ranges.push_back({static_cast<int>(legs_.size()), static_cast<int>(body.legs.size()),
                            std::max(static_cast<float>(body.appears_m), kAlways_m)});
    for (const LegView& leg : body.legs) legs_.push_back(toFloat(leg));
  }
  layer.visible.look(bodies, frame);
}

void BodyDrawer::upload() {
  glBindBuffer(GL_TEXTURE_BUFFER, eyeBuffer_);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(uploaded_.size() * sizeof(std::uint32_t)),
               uploaded_.data(), GL_STREAM_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  soft_.upload();
}

void BodyDrawer::look(const Lorentz& headFromBoard, const EyeView& eye, std::span<const BodyView> bodies,
                      const Switches& switches, const Ghosts& ghosts, const SoftLook& soft,
                      std::span<const HotBlows> heat) {
  switches_ = switches;
  seenShare_ = ghosts.seenShare;
  heat_ = heat;
  legs_.clear();
  soft_.look(headFromBoard, eye, switches, soft);
  takeLayer(ViewTime::seen, bodies, headFromBoard);
  takeLayer(ViewTime::boardNow, ghosts.boardNow, headFromBoard);
  takeLayer(ViewTime::myNow, ghosts.myNow, headFromBoard);
  uploaded_.resize(legs_.size() * sizeof(GpuLeg) / sizeof(std::uint32_t));
  std::memcpy(uploaded_.data(), legs_.data(), legs_.size() * sizeof(GpuLeg));
  chosen_ = 0;
  const ViewFrame frame(headFromBoard, switches);
  eye_.boardFromDrawn = glm::mat4(frame.drawnFromBoard.inverse().matrix());
  const Vec3 u = headFromBoard.inverse().u();
  eye_.headOnBoard = glm::vec4(gammaFromU(u), u);
  const Exposure exposure =
      exposureFor(glm::length(betaFromU(u)), switches.colour != 0, switches.searchlight != 0);
  eye_.exposure = {exposure.gain, exposure.rise, exposure.fall};
  eye_.eyeOnBoard_m = glm::vec3(eye.observation.r_m);
  const double whole_s = std::clamp(std::floor(eye.observation.t_s), -kMostShown_s, kMostShown_s);
  eye_.observedWhole_s = static_cast<int>(whole_s);
  eye_.observedPart_s = static_cast<float>(eye.observation.t_s - whole_s);
  lookAtLamps(eye.observation);
  surfaces_.look(eye.observation.r_m, u);
}

/// Sets when the lamps that are followed go on, c (t_on − t_o). Beyond bounds it makes no difference, and
/// what rests is not drawn anew: all that they can light is lit, or nothing is.
void BodyDrawer::lookAtLamps(const Event& observation) {
  constexpr double kAllLit_m = 1e3, kNothingLit_m = 1.0;
  for (std::size_t i = 0; i < scene_.hall.lamps.size(); ++i) {
    const FollowedLamp& lamp = scene_.hall.lamps[i];
    eye_.lampsFromEye_m[i] = glm::vec3(lamp.place_m - observation.r_m);
    eye_.lampLights[i] = lamp.light;
    eye_.lampsOn_m[static_cast<int>(i)] = static_cast<float>(
        std::clamp(eye_.lightSpeed_m_s * (lamp.on_s - observation.t_s), -kAllLit_m, kNothingLit_m));
  }
}

BodyProgram& BodyDrawer::programFor(const BodyVariant& variant, BodyProgram*& last) {
  if (last && last->variant() == variant) return *last;
  const auto found = std::find_if(programs_.begin(), programs_.end(),
                                  [&](const auto& program) { return program->variant() == variant; });
  if (found == programs_.end()) {
    use(0);  // as its constructor leaves it
    last = programs_.emplace_back(std::make_unique<BodyProgram>(variant)).get();
  } else {
    last = found->get();
  }
  return *last;
}

PartUniforms BodyDrawer::uniformsOf(ViewTime moment, std::size_t number) const {
  const auto layerNumber = static_cast<std::size_t>(moment);
  const ScenePart& part = scene_.parts[number];
  const LegRange& range = layers_[layerNumber].ranges[part.body];
  const bool ghost = moment != ViewTime::seen;
  PartUniforms uniforms;
  uniforms.drawnFromSeen = layers_[layerNumber].drawnFromSeen;
  uniforms.legs = &legs_[static_cast<std::size_t>(range.first)];
  uniforms.firstLeg = range.first;
  uniforms.legCount = range.count;
  uniforms.appears_m = range.appears_m;
  uniforms.colour = part.colour;
  uniforms.roughness = part.roughness;
  if (!ghost && part.body != kRestingBody && part.paint != Paint::shadow) uniforms.seenShare = seenShare_;
  uniforms.tint = static_cast<float>(number % 3);
  // Bodies that go into each other until they turn have their tops in one plane: the later body's is seen.
  const float share = static_cast<float>(part.body) / static_cast<float>(scene_.bodyCount);
  uniforms.nearer = ghost || part.paint == Paint::shadow ? kDecalNearer : kBodiesNearer * share;
  uniforms.ghostColour = linearOf(moment == ViewTime::boardNow ? kBoardNowColour : kMyNowColour);
  uniforms.hatch_m = ghostStripes_m(scene_.reach_m.empty() ? 1.0 : scene_.reach_m[part.body]);
  if (part.body < heat_.size()) uniforms.heat = heat_[part.body];
  uniforms.cooling_m = eye_.lightSpeed_m_s * static_cast<float>(kCooling_s);
  return uniforms;
}

/// Whether its matter may glow visibly. Ghosts are glass, and what tells strain or heat by its colour does
/// not glow.
bool BodyDrawer::isHot(const ChosenPart& chosen) const {
  if (chosen.moment != ViewTime::seen) return false;
  if (chosen.sort == ChosenPart::Sort::softShadow) return false;
  if (chosen.sort == ChosenPart::Sort::soft)
    return soft_.told() == Told::nothing && soft_.bound(chosen.moment, chosen.number).hottest >= kLeastGlow;
  const ScenePart& part = scene_.parts[chosen.number];
  return part.paint != Paint::shadow && part.body < heat_.size() && heat_[part.body].heats != glm::vec4(0.0F);
}

/// With `keepsAlpha`, blending leaves the stored alpha: a shadow has no edge
/// (cave/render/edge_pixels.h).
void BodyDrawer::setState(bool blend, bool keepsAlpha, bool depthMask, bool clip) {
  if (keepsAlpha != keepsAlpha_) {
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, keepsAlpha ? GL_ZERO : GL_ONE,
                        keepsAlpha ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
  }
  keepsAlpha_ = keepsAlpha;
  if (blend != blend_) enable(GL_BLEND, blend);
  if (depthMask != depthMask_) glDepthMask(depthMask);
  if (clip != clip_) enable(GL_CLIP_DISTANCE0, clip);
  blend_ = blend;
  depthMask_ = depthMask;
  clip_ = clip;
}

void BodyDrawer::use(unsigned program) {
  if (program != program_) glUseProgram(program);
  program_ = program;
}

void BodyDrawer::bindArray(const GlVertexArray& array) {
  if (array != boundArray_) glBindVertexArray(array);
  boundArray_ = array;
}

/// Draws a soft body as rigid ones are drawn: by the same programs, but with its vertices solved for.
void BodyDrawer::drawSoft(const Choice& choice, const ChosenPart& chosen) {
  const SoftModel& model = soft_.model(chosen.number);
  const SeenBound& bound = soft_.bound(chosen.moment, chosen.number);
  const bool ghost = chosen.moment != ViewTime::seen, isShadow = chosen.sort == ChosenPart::Sort::softShadow;
  PartUniforms uniforms;
  uniforms.drawnFromSeen = layers_[static_cast<std::size_t>(chosen.moment)].drawnFromSeen;
  uniforms.appears_m = model.told ? SeenRows::kUnseen_m : kAlways_m;
  uniforms.colour = model.colour;
  uniforms.roughness = kSoftRoughness;
  if (!ghost && !isShadow) uniforms.seenShare = seenShare_;
  const std::size_t body = model.told ? scene_.bodyCount + chosen.number : model.body;
  uniforms.tint = static_cast<float>(body % 3);
  const float share = static_cast<float>(body) / static_cast<float>(scene_.bodyCount);
  uniforms.nearer = ghost || isShadow ? kDecalNearer : kBodiesNearer * share;
  uniforms.ghostColour = linearOf(chosen.moment == ViewTime::boardNow ? kBoardNowColour : kMyNowColour);
  uniforms.hatch_m = ghostStripes_m(model.told ? kPointReach_m : model.reach_m());
  uniforms.middleMotion = glm::vec4(gammaFromU(bound.middleU), bound.middleU);
  if (switches_ == kNoSwitches) uniforms.middleMotion = {1.0F, 0.0F, 0.0F, 0.0F};
  uniforms.telling = static_cast<int>(soft_.told());
  const bool isPlain = ghost || model.told != nullptr;
  const Paint paint = isPlain ? Paint::plain : isShadow ? Paint::shadow : Paint::soft;
  BodyProgram* program = nullptr;
  programFor({Legs::followed, paint, switches_, chosen.moment, !scene_.hall.lamps.empty(), isHot(chosen)},
             program);
  use(program->name());
  program->set(eye_, glm::mat4(choice.clipFromDrawn), uniforms);
  setState(isShadow || ghost, isShadow, !isShadow, model.told != nullptr);
  bindArray(soft_.array(chosen.moment));
  soft_.drawTriangles(chosen.number, isShadow);
}

void BodyDrawer::drawPart(const Choice& choice, const ChosenPart& chosen) {
  if (chosen.sort == ChosenPart::Sort::soft || chosen.sort == ChosenPart::Sort::softShadow)
    return drawSoft(choice, chosen);
  const ScenePart& part = scene_.parts[chosen.number];
  const PartUniforms uniforms = uniformsOf(chosen.moment, chosen.number);
  const bool ghost = chosen.moment != ViewTime::seen;
  const bool decal = part.paint == Paint::shadow;
  const Legs legs = !ghost && part.body == kRestingBody
                        ? Legs::rest
                        : legsOf({uniforms.legs, static_cast<std::size_t>(uniforms.legCount)}, part.isRound);
  const Paint paint = ghost ? Paint::plain : part.paint;
  Layer& layer = layers_[static_cast<std::size_t>(chosen.moment)];
  BodyProgram& program =
      programFor({legs, paint, switches_, chosen.moment, !scene_.hall.lamps.empty(), isHot(chosen)},
                 layer.programs[chosen.number]);
  use(program.name());
  program.set(eye_, glm::mat4(choice.clipFromDrawn), uniforms);
  setState(decal || ghost, decal && !ghost, !decal,
           uniforms.appears_m > kAlways_m);  // shadows overlap each other
  if (ghost && !part.isRound) {  // of a body with hollows the nearest surface alone: the glass is even
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawTriangles(choice, chosen);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  drawTriangles(choice, chosen);
}

void BodyDrawer::drawTriangles(const Choice& choice, const ChosenPart& chosen) {
  const auto count = static_cast<GLsizei>(chosen.count);
  if (chosen.sort == ChosenPart::Sort::chunks) {
    bindArray(array_);
    glMultiDrawElements(GL_TRIANGLES, &choice.counts[chosen.first], GL_UNSIGNED_INT,
                        &choice.offsets[chosen.first], count);
    return;
  }
  const auto* const first = reinterpret_cast<const void*>(chosen.first * sizeof(std::uint32_t));
  if (chosen.sort == ChosenPart::Sort::tiles) {
    bindArray(tileArray_);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, first);
  } else {
    bindArray(fineArray_);
    glDrawElementsBaseVertex(GL_TRIANGLES, count, GL_UNSIGNED_INT, const_cast<void*>(first),
                             static_cast<GLint>(choice.fineVertices));
  }
}

bool BodyDrawer::isStill(const ChosenPart& chosen) const {
  if (chosen.sort == ChosenPart::Sort::soft || chosen.sort == ChosenPart::Sort::softShadow) return false;
  const ViewTime moment = chosen.moment;
  const ScenePart& part = scene_.parts[chosen.number];
  return moment == ViewTime::seen && part.body == kRestingBody && part.paint != Paint::clock;
}

StillView BodyDrawer::stillView(const Choice& choice, const glm::ivec2& size_px) const {
  const Layer& layer = layers_[static_cast<std::size_t>(ViewTime::seen)];
  GpuLeg leg = legs_[static_cast<std::size_t>(layer.ranges[kRestingBody].first)];
  leg.boardTime = 0.0F;  // which only clocks show
  StillView view{{}, switches_, size_px, choice.levels};
  float* end = view.numbers.data();
  const auto append = [&](const auto& value) {
    std::memcpy(end, &value, sizeof(value));
    end += sizeof(value) / sizeof(float);
  };
  append(leg);
  append(layer.drawnFromSeen);
  append(eye_.boardFromDrawn);
  append(eye_.headOnBoard);
  append(eye_.eyeOnBoard_m);
  append(eye_.exposure);
  append(eye_.lampsOn_m);
  append(glm::mat4(choice.clipFromDrawn));
  static_assert(sizeof(leg) + 3 * sizeof(glm::mat4) + sizeof(glm::vec4) + 3 * sizeof(glm::vec3) <=
                sizeof(view.numbers));
  return view;
}

/// Appends what the wall may show of a part that is tiled.
void BodyDrawer::takeSurfaces(std::size_t number, Choice& choice) const {
  const auto take = [&](const TiledSurfaces::Range& range, std::size_t offset, ChosenPart::Sort sort) {
    const std::size_t count = range.end - range.first;
    if (count > 0) choice.parts.push_back({ViewTime::seen, number, offset + range.first, count, sort});
    choice.triangles += count / 3;
  };
  take(surfaces_.rangeOf(number), choice.tileIndices, ChosenPart::Sort::tiles);
  take(surfaces_.fineRangeOf(number), choice.fineIndices, ChosenPart::Sort::fine);
}

/// Appends the surfaces that were chosen for a wall to the eye's upload.
void BodyDrawer::appendSurfaces(Choice& choice) {
  constexpr std::size_t kVertexWords = sizeof(MeshVertex) / sizeof(std::uint32_t);
  static_assert(sizeof(MeshVertex) % sizeof(std::uint32_t) == 0);
  const std::size_t most = uploaded_.size() + surfaces_.indices().size() + surfaces_.fineIndices().size() +
                           (surfaces_.fineVertices().size() + 1) * kVertexWords;
  if (most > uploaded_.capacity()) uploaded_.reserve(2 * most);  // more comes into sight frame by frame
  choice.tileIndices = uploaded_.size();
  uploaded_.insert(uploaded_.end(), surfaces_.indices().begin(), surfaces_.indices().end());
  choice.fineVertices = (uploaded_.size() + kVertexWords - 1) / kVertexWords;
  const std::size_t place = choice.fineVertices * kVertexWords;
  choice.fineIndices = place + surfaces_.fineVertices().size() * kVertexWords;
  uploaded_.resize(choice.fineIndices);
  std::memcpy(uploaded_.data() + place, surfaces_.fineVertices().data(),
              surfaces_.fineVertices().size_bytes());
  uploaded_.insert(uploaded_.end(), surfaces_.fineIndices().begin(), surfaces_.fineIndices().end());
}

/// Appends the parts of a layer that the wall may show.
void BodyDrawer::takeParts(ViewTime moment, Choice& choice) const {
  const VisibleChunks& visible = layers_[static_cast<std::size_t>(moment)].visible;
  const bool ghosts = moment != ViewTime::seen;
  for (std::size_t number = 0; number < scene_.parts.size(); ++number) {
    const ScenePart& part = scene_.parts[number];
    const IndexRanges ranges = visible.of(number);
    if (ranges.counts.empty()) continue;
    if (ghosts && (part.body == kRestingBody || part.paint == Paint::shadow)) continue;
    if (isDrawnSoft(soft_, moment, part.body)) continue;
    if (chunks_.parts[number].tiled) {
      takeSurfaces(number, choice);
    } else {
      choice.parts.push_back({moment, number, choice.counts.size(), ranges.counts.size(), {}});
      choice.counts.insert(choice.counts.end(), ranges.counts.begin(), ranges.counts.end());
      for (const int count : ranges.counts) choice.triangles += static_cast<std::size_t>(count) / 3;
      choice.offsets.insert(choice.offsets.end(), ranges.offsets.begin(), ranges.offsets.end());
    }
  }
}

/// Appends the soft bodies that the wall may show; a shadow reaches further than its body.
void BodyDrawer::takeSoft(ViewTime moment, Choice& choice) const {
  for (std::size_t number = 0; number < soft_.modelCount(); ++number) {
    const SoftModel& model = soft_.model(number);
    const glm::dmat4& clip = choice.clipFromDrawn;
    const double shadow_m = scene_.longestShadow * model.height_m;
    if (moment == ViewTime::seen && !model.told && soft_.mayShow(moment, number, clip, shadow_m)) {
      choice.parts.push_back({moment, number, 0, 0, ChosenPart::Sort::softShadow});
      choice.triangles += model.shadow.size() / 3;
    }
    if (!soft_.mayShow(moment, number, clip)) continue;
    choice.parts.push_back({moment, number, 0, 0, ChosenPart::Sort::soft});
    choice.triangles += model.surface.size() / 3;
  }
}

const BodyDrawer::Choice& BodyDrawer::choose(const glm::dmat4& clipFromDrawn, double pixel_rad,
                                             bool everything) {
  if (chosen_ == choices_.size()) choices_.emplace_back();
  Choice& choice = choices_[chosen_++];
  choice.clipFromDrawn = clipFromDrawn;
  choice.parts.clear();
  choice.counts.clear();
  choice.offsets.clear();
  choice.triangles = 0;
  // A quarter of a pixel, so that less than half of one is changed where another mesh takes over.
  for (Layer& layer : layers_) layer.visible.choose(clipFromDrawn, 0.25 * pixel_rad, everything);
  surfaces_.choose(layers_[static_cast<std::size_t>(ViewTime::seen)].visible, 0.5 * pixel_rad);
  choice.levels = surfaces_.digest();
  appendSurfaces(choice);
  for (const ViewTime moment : kViewTimes) {  // ghosts last: they are transparent
    takeParts(moment, choice);
    takeSoft(moment, choice);
  }
  return choice;
}

void BodyDrawer::draw(const Choice& choice, What what) {
  const auto isMeant = [&](const ChosenPart& part) { return (what == What::still) == isStill(part); };
  if (std::none_of(choice.parts.begin(), choice.parts.end(), isMeant)) return;
  bindTextures(colourTexture_, legTexture_);
  for (const ChosenPart& part : choice.parts)
    if (isMeant(part)) drawPart(choice, part);
  setState(false, false, true, false);
  bindTextures(0, 0);
  glBindVertexArray(boundArray_ = 0);
  use(0);
}

}  // namespace carom
