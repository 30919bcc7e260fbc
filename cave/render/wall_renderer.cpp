#include "cave/render/wall_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkCullerCollection.h>
#include <vtkDataObject.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkShaderProperty.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/frame/bodies.h"
#include "cave/frame/clock_time.h"
#include "cave/gl/view_colours.h"
#include "cave/render/body_shaders.h"
#include "cave/render/spacetime_marks.h"
#include "cave/room/off_axis.h"
#include "engine/colour/doppler_colour.h"
#include "engine/colour/exposure.h"

namespace carom {
namespace {

using GpuLeg = kernel_float::LegView;
constexpr int kTexels = 16;
static_assert(sizeof(GpuLeg) == kTexels * 4 * sizeof(float),
              "shaders/leg_at.glsl reads sixteen texels a leg");

constexpr float kAlways_m = -1e30F;     // means that the body has always existed
constexpr float kDecalNearer = 0.002F;  // fraction of the distance by which a decal is drawn nearer
constexpr float kHatch = 0.5F;          // of a ghost, as a fraction of its body's reach from its centre

/// The range of one body's legs in the buffer.
struct LegRange {
  int first = 0;
  int count = 0;
  float appears_m = kAlways_m;
};

/// The bodies as they are seen, or one kind of ghosts.
struct Layer {
  std::vector<LegRange> ranges;  ///< of each body; empty: not drawn
  glm::mat4 drawnFromSeen{1.0F};
  bool made = false;  ///< there are actors
};

/// The uniforms that the shaders of all parts share, for one eye and one wall.
struct EyeUniforms {
  glm::mat4 clipFromDrawn{1.0F};
  glm::mat4 boardFromDrawn{1.0F};
  glm::vec4 headOnBoard{1.0F, 0.0F, 0.0F, 0.0F};
  glm::vec3 eyeOnBoard_m{0.0F};
  glm::vec3 exposure{0.0F};
  int observedWhole_s = 0;
  float observedPart_s = 0.0F;
  int legTexels = 0;     ///< texture unit
  int colourTexels = 0;  ///< texture unit
  std::vector<GpuLeg> legs;
  std::array<Layer, 3> layers;  ///< as ViewTime numbers them
  std::array<glm::vec3, 3> lamps_m{};
  float lightSpeed_m_s = 0.0F;
};

/// Returns where the body of a leg is drawn, shifted to its centre, if its frame is the one that is drawn:
/// when all switches are off.
glm::mat4 placement(const GpuLeg& leg) {
  const auto column = [&](int i) { return glm::vec4(leg.toSeenX[i], leg.toSeenY[i], leg.toSeenZ[i], 0.0F); };
  return {column(1), column(2), column(3), glm::vec4(leg.seenCentre, 1.0F)};
}

/// Sets one part's uniforms and the OpenGL state it needs when VTK is about to draw it.
class PartUniforms : public vtkCommand {
 public:
  static PartUniforms* New() { return new PartUniforms; }

  void Execute(vtkObject*, unsigned long, void* programPointer) override {
    vtkShaderProgram& program = *static_cast<vtkShaderProgram*>(programPointer);
    const Layer& layer = eye->layers[static_cast<std::size_t>(moment)];
    const LegRange& legs = layer.ranges[part->body];
    const bool ghost = moment != ViewTime::seen;
    const bool decal = part->paint == Paint::shadow;
    state->SetEnumState(GL_BLEND, decal || ghost);
    state->vtkglDepthMask(decal ? GL_FALSE : GL_TRUE);  // shadows overlap each other
    state->SetEnumState(GL_CLIP_DISTANCE0, legs.appears_m > kAlways_m);
    program.SetUniformi("legTexels", eye->legTexels);
    program.SetUniformi("firstLeg", legs.first);
    program.SetUniformi("legCount", legs.count);
    program.SetUniformf("appears_m", legs.appears_m);
    program.SetUniformi("colourTexels", eye->colourTexels);
    const GpuLeg& first = eye->legs[static_cast<std::size_t>(legs.first)];
    program.SetUniform4fv("onlyLeg", kTexels, reinterpret_cast<const float(*)[4]>(&first));
    set(program, "drawnFromBody", placement(first));
    set(program, "clipFromDrawn", eye->clipFromDrawn);
    set(program, "drawnFromSeen", layer.drawnFromSeen);
    set(program, "boardFromDrawn", eye->boardFromDrawn);
    program.SetUniform4f("headOnBoard", glm::value_ptr(eye->headOnBoard));
    program.SetUniform3f("eyeOnBoard_m", glm::value_ptr(eye->eyeOnBoard_m));
    program.SetUniform3f("exposure", glm::value_ptr(eye->exposure));
    program.SetUniform3fv("lamps_m", 3, reinterpret_cast<const float(*)[3]>(eye->lamps_m.data()));
    program.SetUniform3f("colour", glm::value_ptr(part->colour));
    program.SetUniformf("gloss", part->gloss);
    program.SetUniformf("nearer", decal || ghost ? kDecalNearer : 0.0F);
    if (ghost) {
      program.SetUniform3f("ghostColour", glm::value_ptr(ghostColour));
      program.SetUniformf("hatch_m", hatch_m);
    }
    if (part->paint != Paint::clock) return;
    program.SetUniformi("observedWhole_s", eye->observedWhole_s);
    program.SetUniformf("observedPart_s", eye->observedPart_s);
    program.SetUniformf("lightSpeed_m_s", eye->lightSpeed_m_s);
  }

  const ScenePart* part = nullptr;
  const EyeUniforms* eye = nullptr;
  vtkOpenGLState* state = nullptr;
  ViewTime moment = ViewTime::seen;
  glm::vec3 ghostColour{0.0F};  ///< linear
  float hatch_m = 1.0F;         ///< from stripe to stripe of a ghost

 private:
  /// Sets a matrix; VTK takes its elements in OpenGL's order.
  static void set(vtkShaderProgram& program, const char* name, const glm::mat4& matrix) {
    program.SetUniformMatrix4x4(name, const_cast<float*>(glm::value_ptr(matrix)));
  }
};

}  // namespace

struct WallRenderer::Stage {
  Graphics* graphics = nullptr;
  Scene scene;
  Switches switches;
  EyeUniforms eye;
  struct PartActor {
    vtkSmartPointer<vtkActor> actor;
    Legs legs;
    ViewTime moment;
    const ScenePart* part;
  };
  std::vector<PartActor> actors;
  glm::ivec2 buffer_px{0};
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkOpenGLBufferObject> legBuffer;
  vtkNew<vtkTextureObject> legTexture;
  vtkNew<vtkOpenGLBufferObject> colourBuffer;
  vtkNew<vtkTextureObject> colourTexture;

  void prepareWindow(int samples);
  void prepareColours();
  void addPart(const ScenePart& part, Legs legs, ViewTime moment = ViewTime::seen);
  void addGhosts(ViewTime moment);
  void chooseShaders();
  void takeHead(const Lorentz& headFromBoard);
  void takeLegs(ViewTime moment, std::span<const BodyView> bodies);
  void chooseActors();
  void upload();
  void drawScene(const RenderTarget& picture, const glm::ivec2& size, const WallDrawing& drawing);
};

void WallRenderer::Stage::prepareWindow(int samples) {
  window->SetOwnContext(0);
  window->SetReadyForRendering(true);
  window->SetIsCurrent(true);
  window->SetIsDirect(1);
  window->SetSupportsOpenGL(1);
  window->SetMapped(1);
  window->SetOffScreenRendering(1);
  window->SetFrameBlitModeToNoBlit();
  window->SetMultiSamples(samples > 1 ? samples : 0);
  window->SetSwapBuffers(0);
  window->AddRenderer(renderer);
  window->OpenGLInit();

  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->GetCullers()->RemoveAllItems();  // VTK's cullers assume Euclidean places
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkCamera> camera;  // unused by the shaders; without a camera VTK would compute the scene's bounds
  renderer->SetActiveCamera(camera);
}

void WallRenderer::Stage::prepareColours() {
  const ColourTable table;
  const std::size_t texels = table.texels().size();
  colourBuffer->Upload(reinterpret_cast<const float*>(table.texels().data()), 4 * texels,
                       vtkOpenGLBufferObject::TextureBuffer);
  colourTexture->SetContext(window);
  colourTexture->CreateTextureBuffer(static_cast<unsigned>(texels), 4, VTK_FLOAT, colourBuffer);
}

/// Adds a part. A part of a body that can turn has two actors, of which one is visible, since the shader is
/// much shorter for a body that the eye sees on one straight leg. They share the mesh's buffers.
void WallRenderer::Stage::addPart(const ScenePart& part, Legs legs, ViewTime moment) {
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputData(part.mesh);
  mapper->StaticOn();
  mapper->ScalarVisibilityOff();
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  mapper->MapDataArrayToVertexAttribute("surfaceMC", "surface", vtkDataObject::FIELD_ASSOCIATION_POINTS);

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->ForceOpaqueOn();

  const auto uniforms = vtkSmartPointer<PartUniforms>::New();
  uniforms->part = &part;
  uniforms->eye = &eye;
  uniforms->state = window->GetState();
  uniforms->moment = moment;
  if (moment != ViewTime::seen) {
    uniforms->ghostColour = linearOf(moment == ViewTime::boardNow ? kBoardNowColour : kMyNowColour);
    uniforms->hatch_m = kHatch * static_cast<float>(scene.reach_m.empty() ? 1.0 : scene.reach_m[part.body]);
  }
  mapper->AddObserver(vtkCommand::UpdateShaderEvent, uniforms);
  renderer->AddActor(actor);
  actors.push_back({actor.Get(), legs, moment, &part});
}

/// Adds ghosts after everything else, because they are transparent.
void WallRenderer::Stage::addGhosts(ViewTime moment) {
  Layer& layer = eye.layers[static_cast<std::size_t>(moment)];
  if (layer.made) return;
  layer.made = true;
  for (const ScenePart& part : scene.parts) {
    if (part.body == kRestingBody || part.paint == Paint::shadow) continue;
    addPart(part, Legs::one, moment);
    addPart(part, Legs::many, moment);
  }
  chooseShaders();
}

/// Selects the shaders for the switches. VTK keeps the programs it has compiled, so switching back costs
/// little.
void WallRenderer::Stage::chooseShaders() {
  for (const auto& [actor, legs, moment, part] : actors) {
    vtkShaderProperty& shaders = *actor->GetShaderProperty();
    shaders.SetVertexShaderCode(bodyVertexShader(legs, part->paint, switches, moment).c_str());
    shaders.SetFragmentShaderCode(surfaceFragmentShader(part->paint, switches, moment).c_str());
  }
}

void WallRenderer::Stage::takeHead(const Lorentz& headFromBoard) {
  for (const ViewTime moment : {ViewTime::seen, ViewTime::boardNow, ViewTime::myNow}) {
    eye.layers[static_cast<std::size_t>(moment)].drawnFromSeen =
        glm::mat4(ViewFrame(headFromBoard, switches, moment).drawnFromSeen.matrix());
  }
  const ViewFrame frame(headFromBoard, switches);
  eye.boardFromDrawn = glm::mat4(frame.drawnFromBoard.inverse().matrix());
  const Vec3 u = headFromBoard.inverse().u();
  eye.headOnBoard = glm::vec4(gammaFromU(u), u);
  const Exposure exposure =
      exposureFor(glm::length(betaFromU(u)), switches.colour != 0, switches.searchlight != 0);
  eye.exposure = {exposure.gain, exposure.rise, exposure.fall};
}

void WallRenderer::Stage::takeLegs(ViewTime moment, std::span<const BodyView> bodies) {
  std::vector<LegRange>& ranges = eye.layers[static_cast<std::size_t>(moment)].ranges;
  ranges.clear();
  for (const BodyView& body : bodies) {
    ranges.push_back({static_cast<int>(eye.legs.size()), static_cast<int>(body.legs.size()),
                      std::max(static_cast<float>(body.appears_m), kAlways_m)});
    for (const LegView& leg : body.legs) eye.legs.push_back(toFloat(leg));
  }
}

void WallRenderer::Stage::chooseActors() {
  for (const auto& [actor, legs, moment, part] : actors) {
    const std::vector<LegRange>& ranges = eye.layers[static_cast<std::size_t>(moment)].ranges;
    if (ranges.empty()) {
      actor->SetVisibility(false);
      continue;
    }
    const LegRange& range = ranges[part->body];
    if (range.count == 0) {
      actor->SetVisibility(false);
      continue;
    }
    const GpuLeg& first = eye.legs[static_cast<std::size_t>(range.first)];
    const bool many = range.count > 1 || first.glide.w > 0.0F || first.spin.w > 0.0F;
    actor->SetVisibility(many == (legs == Legs::many));
  }
}

void WallRenderer::Stage::upload() {
  legBuffer->Upload(reinterpret_cast<const float*>(eye.legs.data()),
                    eye.legs.size() * sizeof(GpuLeg) / sizeof(float), vtkOpenGLBufferObject::TextureBuffer);
  if (legTexture->GetHandle() == 0) {
    legTexture->SetContext(window);
    legTexture->CreateTextureBuffer(static_cast<unsigned>(kTexels * eye.legs.size()), 4, VTK_FLOAT,
                                    legBuffer);
  }
}

void WallRenderer::Stage::drawScene(const RenderTarget& picture, const glm::ivec2& size,
                                    const WallDrawing& drawing) {
  // VTK's buffers grow to the largest picture and keep that size: creating them for every size would cost
  // more than the drawing.
  buffer_px = glm::max(buffer_px, size);
  window->SetSize(buffer_px.x, buffer_px.y);
  renderer->SetViewport(0.0, 0.0, static_cast<double>(size.x) / buffer_px.x,
                        static_cast<double>(size.y) / buffer_px.y);
  legTexture->Activate();
  colourTexture->Activate();
  eye.legTexels = legTexture->GetTextureUnit();
  eye.colourTexels = colourTexture->GetTextureUnit();
  window->Render();
  colourTexture->Deactivate();
  legTexture->Deactivate();
  if (drawing.marks) {
    drawing.marks->draw(eye.clipFromDrawn, window->GetRenderFramebuffer()->GetFBOIndex(), size,
                        drawing.cutAt);
  }

  vtkOpenGLState::ScopedglEnableDisable scissor(window->GetState(), GL_SCISSOR_TEST);
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  window->GetState()->PushFramebufferBindings();
  window->GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window->GetRenderFramebuffer()->ActivateReadBuffer(0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture.framebuffer());
  glBlitFramebuffer(0, 0, size.x, size.y, drawing.left_px, 0, drawing.left_px + size.x, size.y,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  window->GetState()->PopFramebufferBindings();
}

WallRenderer::WallRenderer(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, int samples)
    : stage_(std::make_unique<Stage>()) {
  graphics.makeCurrent();
  stage_->graphics = &graphics;
  stage_->scene = scene;
  stage_->eye.lightSpeed_m_s = static_cast<float>(lightSpeed_m_s);
  for (std::size_t i = 0; i < 3; ++i) stage_->eye.lamps_m[i] = glm::vec3(scene.lamps_m[i]);
  stage_->prepareWindow(samples);
  stage_->prepareColours();
  for (const ScenePart& part : stage_->scene.parts) {
    if (part.body == kRestingBody) {
      stage_->addPart(part, Legs::rest);
    } else {
      stage_->addPart(part, Legs::one);
      stage_->addPart(part, Legs::many);
    }
  }
  stage_->chooseShaders();
}

WallRenderer::~WallRenderer() {
  stage_->graphics->makeCurrent();
  for (vtkTextureObject* texture : {stage_->legTexture.Get(), stage_->colourTexture.Get()}) {
    texture->ReleaseGraphicsResources(stage_->window);
  }
  stage_->legBuffer->ReleaseGraphicsResources();
  stage_->colourBuffer->ReleaseGraphicsResources();
  stage_->window->Finalize();
}

void WallRenderer::look(const Lorentz& headFromBoard, const EyeView& eye, std::span<const BodyView> bodies,
                        const Switches& switches, const Ghosts& ghosts) {
  for (const std::span<const BodyView> views : {bodies, ghosts.boardNow, ghosts.myNow}) {
    if (views.size() == stage_->scene.bodyCount || (views.empty() && views.data() != bodies.data())) continue;
    throw std::invalid_argument(fmt::format("the scene has {} bodies, views of {} were given",
                                            stage_->scene.bodyCount, views.size()));
  }
  if (bodies[kRestingBody].legs.size() != 1) {
    throw std::invalid_argument("what rests on the board has turned");
  }
  stage_->graphics->makeCurrent();
  stage_->eye.legs.clear();
  stage_->takeLegs(ViewTime::seen, bodies);
  stage_->takeLegs(ViewTime::boardNow, ghosts.boardNow);
  stage_->takeLegs(ViewTime::myNow, ghosts.myNow);
  stage_->upload();
  const bool switched = switches != stage_->switches;
  stage_->switches = switches;
  if (switched) stage_->chooseShaders();
  if (!ghosts.boardNow.empty()) stage_->addGhosts(ViewTime::boardNow);
  if (!ghosts.myNow.empty()) stage_->addGhosts(ViewTime::myNow);
  stage_->chooseActors();
  stage_->takeHead(headFromBoard);
  stage_->eye.eyeOnBoard_m = glm::vec3(eye.observation.r_m);
  const double whole_s = std::clamp(std::floor(eye.observation.t_s), -kMostShown_s, kMostShown_s);
  stage_->eye.observedWhole_s = static_cast<int>(whole_s);
  stage_->eye.observedPart_s = static_cast<float>(eye.observation.t_s - whole_s);
}

bool WallRenderer::draw(const Wall& wall, const glm::dvec3& eyeInRoom_m, RenderTarget& picture,
                        const WallDrawing& drawing) {
  stage_->graphics->makeCurrent();
  const std::optional<glm::dmat4> projection = clipFromEye(wall, eyeInRoom_m);
  if (!projection) {
    picture.clear();
    return false;
  }
  stage_->eye.clipFromDrawn = glm::mat4(glm::translate(*projection, drawing.seenFromEye_m));
  stage_->drawScene(picture, wall.pixels, drawing);
  return true;
}

}  // namespace carom
