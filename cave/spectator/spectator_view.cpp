#include "cave/spectator/spectator_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtk_glew.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/frame/bodies.h"
#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/line_batch.h"
#include "cave/mesh/mesh_builder.h"
#include "cave/room/off_axis.h"
#include "cave/spectator/orbit_camera.h"
#include "cave/spectator/room_simultaneity.h"
#include "shaders/backdrop_frag.h"
#include "shaders/ground_frag.h"
#include "shaders/panel_frag.h"
#include "shaders/panel_vert.h"
#include "shaders/solid_frag.h"
#include "shaders/solid_vert.h"
#include "shaders/stereo_vert.h"
#include "shaders/words_frag.h"

namespace carom {
namespace {

constexpr int kSamples = 4;
constexpr glm::ivec2 kWindowPlace_px{80, 80};
constexpr double kGround_m = 24.0;
constexpr float kTableCovers = 0.4F;   // the table is no thing of the room
constexpr float kBehindCovers = 0.5F;  // of what is behind a wall
const glm::vec3 kSkin(0.80F, 0.32F, 0.09F), kCoat(0.06F, 0.16F, 0.42F), kDark(0.02F),
    kWand(0.75F, 0.72F, 0.65F);
constexpr glm::vec4 kFrame(0.88F, 0.91F, 0.95F, 1.0F), kFarFrame(0.75F, 0.82F, 0.92F, 0.45F);
constexpr glm::vec4 kTableEdge(0.65F, 1.0F, 0.80F, 0.9F);
constexpr glm::vec4 kSight(1.0F, 0.85F, 0.45F, 0.55F);

/// One mesh on the graphics card, made once.
class Solid {
 public:
  Solid(vtkPolyData& mesh, const glm::vec3& reflects, unsigned program) : colour(reflects) {
    std::vector<float> points;
    vtkDataArray* normals = mesh.GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i) {
      std::array<double, 3> place{}, normal{0.0, 0.0, 1.0};
      mesh.GetPoint(i, place.data());
      if (normals) normals->GetTuple(i, normal.data());
      for (const double value : place) points.push_back(static_cast<float>(value));
      for (const double value : normal) points.push_back(static_cast<float>(value));
    }
    std::vector<unsigned> corners;
    const auto cells = vtk::TakeSmartPointer(mesh.GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCurrentCell(count, ids);
      for (vtkIdType i = 2; i < count; ++i) {
        for (const vtkIdType id : {ids[0], ids[i - 1], ids[i]}) corners.push_back(static_cast<unsigned>(id));
      }
    }
    count_ = static_cast<int>(corners.size());
    upload(points, corners, program);
  }
  ~Solid() {
    if (!vertexArray_) return;
    glDeleteBuffers(2, buffers_.data());
    glDeleteVertexArrays(1, &vertexArray_);
  }
  Solid(Solid&& other) noexcept
      : colour(other.colour),
        count_(other.count_),
        vertexArray_(other.vertexArray_),
        buffers_(other.buffers_) {
    other.vertexArray_ = 0;
  }
  Solid& operator=(Solid&&) = delete;

  void draw() const {
    glBindVertexArray(vertexArray_);
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  }

  glm::vec3 colour;  ///< linear

 private:
  void upload(const std::vector<float>& points, const std::vector<unsigned>& corners, unsigned program) {
    glGenVertexArrays(1, &vertexArray_);
    glGenBuffers(2, buffers_.data());
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(float)), points.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(unsigned)),
                 corners.data(), GL_STATIC_DRAW);
    for (const auto& [name, offset] : {std::pair("place_m", 0), std::pair("normal", 3)}) {
      const auto location = static_cast<GLuint>(glGetAttribLocation(program, name));
      glEnableVertexAttribArray(location);
      glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float),
                            reinterpret_cast<const void*>(static_cast<std::size_t>(offset) * sizeof(float)));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }

  int count_ = 0;
  unsigned vertexArray_ = 0;
  std::array<unsigned, 2> buffers_{};
};

/// A part of a body of the scene.
struct BodySolid {
  std::size_t body;
  Solid solid;
};

/// A wall's name as a picture.
struct Label {
  unsigned texture = 0;
  glm::ivec2 size_px{0};
};

/// An ellipsoid; x right, y forward, z up.
void addEllipsoid(MeshBuilder& mesh, const glm::dvec3& middle_m, const glm::dvec3& radii_m) {
  constexpr int kAround = 32, kUp = 20;
  mesh.addPatch(kAround, kUp, [&](double u, double v) {
    const double east = 2.0 * M_PI * u, north = M_PI * (v - 0.5);
    return PatchPoint{middle_m + radii_m * glm::dvec3(std::cos(east) * std::cos(north),
                                                      std::sin(east) * std::cos(north), std::sin(north))};
  });
}

/// Skull and nose, and the eyes' 3-D glasses, from the point between the eyes.
void addHead(std::vector<Solid>& solids, unsigned program) {
  MeshBuilder skull, glasses;
  addEllipsoid(skull, {0.0, -0.09, 0.01}, {0.078, 0.10, 0.125});
  addEllipsoid(skull, {0.0, 0.015, -0.035}, {0.016, 0.035, 0.024});
  for (const double side : {-1.0, 1.0}) {
    addEllipsoid(glasses, {side * 0.033, 0.004, 0.0}, {0.030, 0.014, 0.024});
    addEllipsoid(glasses, {side * 0.078, -0.045, 0.0}, {0.004, 0.055, 0.006});
  }
  solids.emplace_back(*skull.build(), kSkin, program);
  solids.emplace_back(*glasses.build(), kDark, program);
}

/// A body of height 1 up to the eyes, without arms: as wide as a coat hangs, wider than deep.
vtkSmartPointer<vtkPolyData> coat() {
  constexpr std::array<glm::dvec2, 9> kProfile{{{0.0, 0.0},
                                                {0.15, 0.01},
                                                {0.15, 0.06},
                                                {0.125, 0.45},
                                                {0.14, 0.62},
                                                {0.20, 0.78},
                                                {0.17, 0.85},
                                                {0.055, 0.88},
                                                {0.05, 0.97}}};
  constexpr double kDeep = 0.68;
  constexpr int kAround = 40, kUp = 48;
  MeshBuilder mesh;
  mesh.addPatch(kAround, kUp, [&](double u, double v) {
    const double place = v * (kProfile.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kProfile.size() - 2);
    const double share = glm::smoothstep(0.0, 1.0, place - static_cast<double>(i));
    const double radius = glm::mix(kProfile[i].x, kProfile[i + 1].x, share);
    const double height = glm::mix(kProfile[i].y, kProfile[i + 1].y, place - static_cast<double>(i));
    return PatchPoint{{radius * std::cos(2.0 * M_PI * u), kDeep * radius * std::sin(2.0 * M_PI * u), height}};
  });
  return mesh.build();
}

/// A wand with a ball where it is held.
vtkSmartPointer<vtkPolyData> wand() {
  MeshBuilder mesh;
  addEllipsoid(mesh, glm::dvec3(0.0), glm::dvec3(0.035));
  addEllipsoid(mesh, {0.0, 0.13, 0.0}, {0.012, 0.13, 0.012});
  return mesh.build();
}

glm::dmat4 matrixOf(const Pose& pose) {
  return glm::translate(glm::dmat4(1.0), pose.position_m) * glm::mat4_cast(pose.orientation);
}

void setMatrix(unsigned program, const char* name, const glm::dmat4& matrix) {
  glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, glm::value_ptr(glm::mat4(matrix)));
}

void setVector(unsigned program, const char* name, const glm::dvec3& vector) {
  glUniform3fv(glGetUniformLocation(program, name), 1, glm::value_ptr(glm::vec3(vector)));
}

void drawRectangle(unsigned program, const glm::dmat4& clip, const Wall& place) {
  setMatrix(program, "clipFromRoom", clip);
  setVector(program, "lowerLeft_m", place.lowerLeft_m);
  setVector(program, "across_m", place.lowerRight_m - place.lowerLeft_m);
  setVector(program, "upwards_m", place.upperLeft_m - place.lowerLeft_m);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

/// The corners of the upper side of a mesh's bounding box.
std::array<glm::dvec3, 4> topOf(vtkPolyData& mesh) {
  const double* b = mesh.GetBounds();
  return {{{b[0], b[2], b[5]}, {b[1], b[2], b[5]}, {b[1], b[3], b[5]}, {b[0], b[3], b[5]}}};
}

bool isHall(Paint paint) { return paint == Paint::floor || paint == Paint::panels || paint == Paint::lamp; }

}  // namespace

struct SpectatorView::Drawing {
  Graphics& graphics;
  RoomGeometry room;
  std::vector<Wall> walls;  ///< of the room, each screen once
  OrbitCamera camera;
  double floor_m = 0.0;       ///< along up
  glm::dmat4 roomFromPerson;  ///< right, forward and up to the room's axes
  std::unique_ptr<Window> window;
  glm::ivec2 size_px{0};
  std::unique_ptr<RenderTarget> picture;
  unsigned framebuffer = 0;
  std::array<unsigned, 2> buffers{};  ///< colour and depth, with many samples
  unsigned solidProgram = 0, panelProgram = 0, groundProgram = 0, backdropProgram = 0, wordsProgram = 0;
  unsigned vertexArray = 0;
  std::vector<Solid> head;
  std::optional<Solid> body, hand;
  std::vector<Solid> table;
  std::vector<std::array<glm::dvec3, 4>> tableEdges;  ///< around the cloth and around the rails, on the board
  std::vector<BodySolid> bodies;
  std::vector<Label> labels;  ///< of each wall
  LineBatch ribbons;
  std::vector<Ribbon> lines;
  glm::dmat4 clip{1.0};

  Drawing(Graphics& graphics, const RoomGeometry& room);
  ~Drawing();
  void makePerson();
  void makeGame(const Scene& scene, std::span<const ScenePart> parts);
  void makeLabels(int height_px);
  void makePicture(const glm::ivec2& wanted_px);
  bool isInside(const Wall& wall) const;
  void drawGround();
  void drawPanels(const DisplayWalls& shown);
  void useSolids() const;
  void drawSolid(const Solid& solid, const glm::dmat4& roomFromModel, float covers) const;
  void drawPerson(const FrameRecord& record) const;
  void drawGame(const RoomSimultaneity& moment, std::span<const WorldLine> histories, float covers) const;
  void drawTable(const glm::dmat4& roomFromTable) const;
  void drawLines(const FrameRecord& record, const std::optional<glm::dmat4>& roomFromTable);
  void drawLabels() const;
};

SpectatorView::Drawing::Drawing(Graphics& graphicsIn, const RoomGeometry& roomIn)
    : graphics(graphicsIn),
      room(roomIn),
      camera(roomIn),
      floor_m(std::numeric_limits<double>::infinity()),
      solidProgram(makeProgram("solid", shaders::solid_vert, shaders::solid_frag)),
      panelProgram(makeProgram("panel", shaders::panel_vert, shaders::panel_frag)),
      groundProgram(makeProgram("ground", shaders::panel_vert, shaders::ground_frag)),
      backdropProgram(makeProgram("backdrop", shaders::stereo_vert, shaders::backdrop_frag)),
      wordsProgram(makeProgram("words", shaders::stereo_vert, shaders::words_frag)) {
  glGenVertexArrays(1, &vertexArray);
  for (const Wall& wall : room.walls) {
    const bool known =
        std::any_of(walls.begin(), walls.end(), [&](const Wall& other) { return standSame(wall, other); });
    if (!known) walls.push_back(wall);
    for (const glm::dvec3& corner_m : {wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m})
      floor_m = std::min(floor_m, glm::dot(corner_m, room.up));
  }
  roomFromPerson = glm::dmat4(glm::dmat3(glm::cross(room.forward, room.up), room.forward, room.up));
}

SpectatorView::Drawing::~Drawing() {
  graphics.makeCurrent();
  for (const Label& label : labels) glDeleteTextures(1, &label.texture);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteRenderbuffers(2, buffers.data());
  glDeleteVertexArrays(1, &vertexArray);
  for (const unsigned program : {solidProgram, panelProgram, groundProgram, backdropProgram, wordsProgram})
    glDeleteProgram(program);
}

void SpectatorView::Drawing::makePerson() {
  addHead(head, solidProgram);
  body.emplace(*coat(), kCoat, solidProgram);
  hand.emplace(*wand(), kWand, solidProgram);
}

void SpectatorView::Drawing::makeGame(const Scene& scene, std::span<const ScenePart> parts) {
  table.clear();
  tableEdges.clear();
  bodies.clear();
  for (const ScenePart& part : parts) {
    if (isHall(part.paint)) continue;
    table.emplace_back(*part.mesh, part.paint == Paint::clock ? kDark : part.colour, solidProgram);
    if (part.paint == Paint::cloth || part.paint == Paint::wood) tableEdges.push_back(topOf(*part.mesh));
  }
  for (const ScenePart& part : scene.parts) {
    if (part.body == kRestingBody || part.paint == Paint::shadow) continue;
    bodies.push_back({part.body, Solid(*part.mesh, part.colour, solidProgram)});
  }
}

void SpectatorView::Drawing::makeLabels(int height_px) {
  for (const Wall& wall : walls) {
    const GlyphBitmap name = ink(wall.name, height_px);
    std::vector<std::uint8_t> rgba(4 * name.alpha.size(), 255);
    for (std::size_t i = 0; i < name.alpha.size(); ++i) rgba[4 * i + 3] = name.alpha[i];
    Label label{0, name.size_px};
    glGenTextures(1, &label.texture);
    glBindTexture(GL_TEXTURE_2D, label.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, name.size_px.x, name.size_px.y, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
    labels.push_back(label);
  }
}

/// Made anew only when the window has another size.
void SpectatorView::Drawing::makePicture(const glm::ivec2& wanted_px) {
  if (wanted_px == size_px && picture) return;
  size_px = wanted_px;
  picture = std::make_unique<RenderTarget>(size_px);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteRenderbuffers(2, buffers.data());
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(2, buffers.data());
  const GlStateGuard state(framebuffer, size_px);
  constexpr std::array<GLenum, 2> kFormats{GL_RGBA8, GL_DEPTH_COMPONENT24};
  constexpr std::array<GLenum, 2> kPlaces{GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (std::size_t i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, kFormats[i], size_px.x, size_px.y);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, kPlaces[i], GL_RENDERBUFFER, buffers[i]);
  }
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
}

/// Whether the camera sees the side that the person sees.
bool SpectatorView::Drawing::isInside(const Wall& wall) const {
  return glm::dot(normalOf(wall), camera.place_m() - wall.lowerLeft_m) > 0.0;
}

void SpectatorView::Drawing::drawGround() {
  glBindVertexArray(vertexArray);
  glUseProgram(backdropProgram);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  if (glm::dot(camera.place_m(), room.up) < floor_m) return;  // seen from below it would hide the room
  constexpr double kBelow_m = 0.01;                           // a wall may be the floor
  const glm::dvec3 right = glm::cross(room.forward, room.up);
  Wall ground;
  ground.lowerLeft_m = (floor_m - kBelow_m) * room.up - 0.5 * kGround_m * (right + room.forward);
  ground.lowerRight_m = ground.lowerLeft_m + kGround_m * right;
  ground.upperLeft_m = ground.lowerLeft_m + kGround_m * room.forward;
  blendOver();
  glUseProgram(groundProgram);
  glUniform1f(glGetUniformLocation(groundProgram, "size_m"), static_cast<float>(kGround_m));
  drawRectangle(groundProgram, clip, ground);
}

void SpectatorView::Drawing::drawPanels(const DisplayWalls& shown) {
  glUseProgram(panelProgram);
  glBindVertexArray(vertexArray);
  glUniform1i(glGetUniformLocation(panelProgram, "shown"), 0);
  for (const Wall& wall : walls) {
    if (!isInside(wall)) continue;
    const RenderTarget* live = shown.pictureOf(wall.name);
    glUniform1i(glGetUniformLocation(panelProgram, "empty"), live ? 0 : 1);
    if (live) glBindTexture(GL_TEXTURE_2D, live->texture());
    drawRectangle(panelProgram, clip, wall);
  }
}

void SpectatorView::Drawing::useSolids() const {
  glUseProgram(solidProgram);
  setMatrix(solidProgram, "clipFromRoom", clip);
  const glm::dvec3 camera_m = camera.place_m(), right = glm::cross(room.forward, room.up);
  setVector(solidProgram, "camera_m", camera_m);
  setVector(solidProgram, "up", room.up);
  setVector(solidProgram, "toLamp", glm::normalize(glm::normalize(camera_m) + room.up - 0.5 * right));
}

void SpectatorView::Drawing::drawSolid(const Solid& solid, const glm::dmat4& roomFromModel,
                                       float covers) const {
  setMatrix(solidProgram, "roomFromModel", roomFromModel);
  const glm::mat3 normals(glm::inverseTranspose(glm::dmat3(roomFromModel)));
  glUniformMatrix3fv(glGetUniformLocation(solidProgram, "normalsToRoom"), 1, GL_FALSE,
                     glm::value_ptr(normals));
  glUniform4fv(glGetUniformLocation(solidProgram, "material"), 1,
               glm::value_ptr(glm::vec4(solid.colour, covers)));
  solid.draw();
}

void SpectatorView::Drawing::drawPerson(const FrameRecord& record) const {
  const Tracked& tracked = record.tracked;
  const glm::dvec3& eyes_m = record.observer.eyes[2].positionInRoom_m;
  Pose roomFromHead{eyes_m, {1.0, 0.0, 0.0, 0.0}};
  if (tracked.headKnown)
    roomFromHead.orientation = (tracked.roomFromHeadSensor * room.sensorFromEyes).orientation;
  const glm::dmat4 turned = matrixOf(roomFromHead) * roomFromPerson;
  for (const Solid& part : head) drawSolid(part, turned, 1.0F);
  if (const double height_m = glm::dot(eyes_m, room.up) - floor_m; height_m > 0.5) {
    // Under the head's middle, behind the eyes.
    glm::dvec3 back = roomFromHead.orientation * room.forward;
    back = back - room.up * glm::dot(back, room.up);
    const glm::dvec3 foot_m = eyes_m - height_m * room.up - 0.09 * back;
    drawSolid(*body,
              glm::translate(glm::dmat4(1.0), foot_m) * roomFromPerson *
                  glm::scale(glm::dmat4(1.0), {1.0, 1.0, height_m}),
              1.0F);
  }
  if (tracked.handKnown) drawSolid(*hand, matrixOf(tracked.roomFromHand) * roomFromPerson, 1.0F);
}

void SpectatorView::Drawing::drawGame(const RoomSimultaneity& moment, std::span<const WorldLine> histories,
                                      float covers) const {
  std::size_t placed = histories.size();
  std::optional<glm::dmat4> place;
  for (const BodySolid& part : bodies) {
    if (part.body != placed) place = moment.roomFromBody(histories[part.body]);
    placed = part.body;
    if (place) drawSolid(part.solid, *place, covers);
  }
}

/// Its nearest surface alone: depth first.
void SpectatorView::Drawing::drawTable(const glm::dmat4& roomFromTable) const {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (const Solid& part : table) drawSolid(part, roomFromTable, kTableCovers);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  for (const Solid& part : table) drawSolid(part, roomFromTable, kTableCovers);
  glDepthFunc(GL_LESS);
}

void SpectatorView::Drawing::drawLines(const FrameRecord& record,
                                       const std::optional<glm::dmat4>& roomFromTable) {
  constexpr double kFrame_m = 0.014, kSight_m = 0.003, kEdge_m = 0.005;
  lines.clear();
  const glm::dvec3& eyes_m = record.observer.eyes[2].positionInRoom_m;
  for (const Wall& wall : walls) {
    const glm::dvec3 fourth_m = wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m;
    const std::array<glm::dvec3, 4> corners_m{wall.lowerLeft_m, wall.lowerRight_m, fourth_m,
                                              wall.upperLeft_m};
    const bool inside = isInside(wall);
    for (std::size_t i = 0; i < 4; ++i) {
      lines.push_back({corners_m[i], corners_m[(i + 1) % 4], inside ? kFrame_m : 0.3 * kFrame_m,
                       inside ? kFrame : kFarFrame});
      lines.push_back({eyes_m, corners_m[i], kSight_m, kSight});
    }
  }
  const std::size_t ofRoom = lines.size();
  for (const std::array<glm::dvec3, 4>& edge : tableEdges) {
    for (std::size_t i = 0; i < 4 && roomFromTable; ++i) {
      lines.push_back({glm::dvec3(*roomFromTable * glm::dvec4(edge[i], 1.0)),
                       glm::dvec3(*roomFromTable * glm::dvec4(edge[(i + 1) % 4], 1.0)), kEdge_m, kTableEdge});
    }
  }
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);  // before the edges that they follow
  glPolygonOffset(-2.0F, -2.0F);
  ribbons.draw(lines, clip, size_px);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthFunc(GL_GREATER);  // the table's edges behind a wall, dimly
  for (std::size_t i = ofRoom; i < lines.size(); ++i) lines[i].colour.a *= kBehindCovers;
  ribbons.draw(std::span<const Ribbon>(lines).subspan(ofRoom), clip, size_px);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
}

/// Above a wall, before the near edge of one that lies on the floor, and at the foot of one that is seen from
/// behind.
void SpectatorView::Drawing::drawLabels() const {
  constexpr double kAway_m = 0.14;
  glUseProgram(wordsProgram);
  glBindVertexArray(vertexArray);
  glUniform1i(glGetUniformLocation(wordsProgram, "words"), 0);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Wall& wall = walls[i];
    const glm::dvec3 upwards_m = wall.upperLeft_m - wall.lowerLeft_m;
    const bool stands = std::abs(glm::dot(glm::normalize(upwards_m), room.up)) > 0.5;
    const glm::dvec3 middle_m = 0.5 * (wall.lowerLeft_m + wall.lowerRight_m);
    glm::dvec3 place_m = middle_m - kAway_m * glm::normalize(upwards_m);
    if (stands && isInside(wall)) {
      place_m = middle_m + upwards_m + kAway_m * room.up;
    } else if (stands) {
      place_m = middle_m - 2.0 * kAway_m * normalOf(wall);
    }
    const glm::dvec4 at = clip * glm::dvec4(place_m, 1.0);
    if (!(at.w > 0.0)) continue;
    const glm::ivec2 middle_px = (glm::dvec2(at) / at.w * 0.5 + 0.5) * glm::dvec2(size_px);
    const glm::ivec2 from_px = middle_px - labels[i].size_px / 2;
    glBindTexture(GL_TEXTURE_2D, labels[i].texture);
    glViewport(from_px.x, from_px.y, labels[i].size_px.x, labels[i].size_px.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

SpectatorView::SpectatorView(Graphics& graphics, const RoomGeometry& room, const Scene& scene,
                             std::span<const ScenePart> table, bool visible) {
  graphics.makeCurrent();
  drawing_ = std::make_unique<Drawing>(graphics, room);
  drawing_->makePerson();
  drawing_->makeGame(scene, table);
  constexpr int kLabel_px = 26;
  drawing_->makeLabels(kLabel_px);
  if (visible) {
    const WindowPlacement place{0, kWindowPlace_px, kPicture_px, false};
    drawing_->window = std::make_unique<Window>(graphics, "Carom: the room from outside", place);
    graphics.makeCurrent();
  }
}

void SpectatorView::play(const Scene& scene, std::span<const ScenePart> table) {
  drawing_->graphics.makeCurrent();
  drawing_->makeGame(scene, table);
}

SpectatorView::~SpectatorView() { drawing_->graphics.makeCurrent(); }

void SpectatorView::draw(const FrameRecord& record, std::span<const WorldLine> histories,
                         const DisplayWalls& walls) {
  Drawing& d = *drawing_;
  d.graphics.makeCurrent();
  d.makePicture(d.window ? glm::max(d.window->size_px(), glm::ivec2(1)) : kPicture_px);
  d.clip = d.camera.clipFromRoom(d.size_px);
  const EyeView& middle = record.observer.eyes[2];
  const RoomSimultaneity moment(record.boardFromRoom, middle.observation, middle.seenFromInRoom_m);

  const GlStateGuard state(d.framebuffer, d.size_px);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  d.drawGround();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  d.drawPanels(walls);
  d.useSolids();
  // What stands behind a wall, dimly.
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_FALSE);
  d.drawGame(moment, histories, kBehindCovers);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  d.drawPerson(record);
  d.drawGame(moment, histories, 1.0F);
  const std::optional<glm::dmat4> roomFromTable = moment.roomFromBody(histories[kRestingBody]);
  if (roomFromTable) d.drawTable(*roomFromTable);
  d.drawLines(record, roomFromTable);
  glDisable(GL_DEPTH_TEST);
  d.drawLabels();

  GLint readBefore = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readBefore);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, d.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, d.picture->framebuffer());
  glBlitFramebuffer(0, 0, d.size_px.x, d.size_px.y, 0, 0, d.size_px.x, d.size_px.y, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readBefore));
}

const RenderTarget& SpectatorView::picture() const { return *drawing_->picture; }

Capture::Taken SpectatorView::taken() const {
  static const std::string kName = "outside";
  return {drawing_->picture.get(), &kName, Eye::mono};
}

void SpectatorView::show() {
  Drawing& d = *drawing_;
  if (!d.window) return;
  const PointerInput pointer = d.window->takePointer();
  d.camera.turn(pointer.dragged_px);
  d.camera.zoom(pointer.wheel);
  d.graphics.finishDrawing();
  const Pane pane{d.picture.get(), nullptr, StereoMode::mono, {0, 0}, d.window->size_px(), nullptr};
  d.window->show({&pane, 1});
}

void SpectatorView::swap() {
  if (drawing_->window) drawing_->window->swap();
}

}  // namespace carom
