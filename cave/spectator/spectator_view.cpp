#include "cave/spectator/spectator_view.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <vtk_glew.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cave/frame/bodies.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/gl/line_batch.h"
#include "cave/render/draw_target.h"
#include "cave/render/edge_smoother.h"
#include "cave/room/headset_walls.h"
#include "cave/sculpture/room_sculpture.h"
#include "cave/spectator/orbit_camera.h"
#include "cave/spectator/outside_view.h"
#include "cave/spectator/room_simultaneity.h"
#include "cave/spectator/room_surfaces.h"
#include "cave/spectator/soft_solids.h"
#include "cave/spectator/solid_drawer.h"
#include "cave/spectator/viewer_model.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

constexpr int kSamples = 4;
constexpr float kTableCovers = 0.4F;   // the table is drawn transparent, as it is not in the room
constexpr float kBehindCovers = 0.5F;  // opacity of things behind a wall
constexpr glm::vec3 kClock(0.02F);
constexpr glm::vec4 kFrame(0.88F, 0.91F, 0.95F, 1.0F), kFarFrame(0.75F, 0.82F, 0.92F, 0.45F);
constexpr glm::vec4 kTableEdge(0.65F, 1.0F, 0.80F, 0.9F);
constexpr glm::vec4 kSight(1.0F, 0.85F, 0.45F, 0.55F);

/// A part of a body of the scene.
struct BodySolid {
  std::size_t body;
  Solid solid;
};

using Corners = std::array<glm::dvec3, 4>;  // in order around a rectangle

/// Returns the upper side of a mesh's bounding box.
Corners topOf(vtkPolyData& mesh) {
  const double* b = mesh.GetBounds();
  return {{{b[0], b[2], b[5]}, {b[1], b[2], b[5]}, {b[1], b[3], b[5]}, {b[0], b[3], b[5]}}};
}

Corners cornersOf(const Wall& wall) {
  const glm::dvec3 fourth_m = wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m;
  return {wall.lowerLeft_m, wall.lowerRight_m, fourth_m, wall.upperLeft_m};
}

bool isHall(Paint paint) { return paint == Paint::floor || paint == Paint::panels || paint == Paint::lamp; }

}  // namespace

struct SpectatorView::Drawing {
  Graphics& graphics;
  RoomGeometry room;
  OrbitCamera camera;
  std::unique_ptr<Window> window;
  glm::ivec2 size_px{0};
  std::unique_ptr<RenderTarget> picture;
  DrawTarget target;
  std::optional<EdgeSmoother> smoother;  ///< where the processor draws, instead of many samples
  RoomSurfaces surfaces;
  SolidDrawer solids;
  std::vector<Solid> head;
  std::vector<Solid> coats;  ///< of each viewer
  std::vector<Solid> below;
  Solid wand;
  std::array<RoomGeometry, kMostViewers> rooms;  ///< as each viewer sees it
  std::vector<Solid> table;
  std::vector<Corners> tableEdges;  ///< around the cloth and around the rails, on the board
  std::vector<BodySolid> bodies, people;
  std::size_t firstPerson = 0;  ///< as in the scene
  std::optional<SoftSolids> soft;
  SculptedGame sculpted;
  OwnLines ownLines;
  std::unique_ptr<RoomSculpture> sculpture;  ///< while it is shown
  LineBatch ribbons;
  std::vector<Ribbon> lines;
  OutsideView view;
  std::array<Wall, 2> hung;  ///< before the eyes of a headset,
  bool isWorn = false;       ///< while there is one

  Drawing(Graphics& graphicsIn, const RoomGeometry& roomIn, const ViewerModel& viewer);
  ~Drawing() { graphics.makeCurrent(); }
  void makeGame(const Scene& scene, std::span<const ScenePart> parts);
  void putOn(const HeadsetState& headset);
  void drawViewers(const FrameRecord& record) const;
  void drawBodies(const RoomSimultaneity& moment, std::span<const WorldLine> histories, float covers) const;
  void drawPeople(const RoomSimultaneity& moment, std::span<const ToldPath> paths, float covers) const;
  void drawSculpture(const FrameRecord& record, const World& world);
  void drawTable(const glm::dmat4& roomFromTable) const;
  void outline(const Wall& wall, std::span<const glm::dvec3> eyes_m);
  void drawLines(const FrameRecord& record, const std::optional<glm::dmat4>& roomFromTable);
};

SpectatorView::Drawing::Drawing(Graphics& graphicsIn, const RoomGeometry& roomIn, const ViewerModel& viewer)
    : graphics(graphicsIn),
      room(roomIn),
      camera(roomIn),
      target(graphics.inSoftware() ? 1 : kSamples),
      surfaces(roomIn),
      wand(solids.upload(*viewer.wand.mesh, viewer.wand.colour)) {
  if (graphics.inSoftware()) smoother.emplace(EdgePixels::Tones::luminance);
  for (const ModelPart& part : viewer.head) head.push_back(solids.upload(*part.mesh, part.colour));
  for (const ModelPart& part : viewer.below) below.push_back(solids.upload(*part.mesh, part.colour));
  for (std::size_t i = 0; i < room.viewers.size(); ++i) {
    coats.push_back(solids.upload(*viewer.coats.at(i).mesh, viewer.coats[i].colour));
    rooms[i] = seenBy(room, i);
  }
  for (std::size_t eye = 0; eye < 2; ++eye) hung[eye].name = kEyeWalls[eye];
}

void SpectatorView::Drawing::putOn(const HeadsetState& headset) {
  isWorn = room.isHeadset && headset.isWorn;
  for (std::size_t eye = 0; eye < 2 && isWorn; ++eye) hang(hung[eye], headset.eyes[eye]);
}

void SpectatorView::Drawing::makeGame(const Scene& scene, std::span<const ScenePart> parts) {
  table.clear();
  tableEdges.clear();
  bodies.clear();
  people.clear();
  firstPerson = scene.firstPerson;
  for (const ScenePart& part : parts) {
    if (isHall(part.paint)) continue;
    table.push_back(solids.upload(*part.mesh, part.paint == Paint::clock ? kClock : part.colour));
    if (part.paint == Paint::cloth || part.paint == Paint::wood) tableEdges.push_back(topOf(*part.mesh));
  }
  for (const ScenePart& part : scene.parts) {
    if (part.body == kRestingBody || part.paint == Paint::shadow) continue;
    const bool isPerson = scene.firstPerson != 0 && part.body >= scene.firstPerson;
    (isPerson ? people : bodies).push_back({part.body, solids.upload(*part.mesh, part.colour)});
  }
  soft.emplace(scene, solids);
  sculpture.reset();
  sculpted = scene.sculpted;
}

void SpectatorView::Drawing::drawViewers(const FrameRecord& record) const {
  for (std::size_t i = 0; i < std::min<std::size_t>(record.viewerCount, room.viewers.size()); ++i) {
    const ViewerPlaces places = viewerPlaces({record, i}, rooms[i], surfaces.floor_m());
    for (const Solid& part : head) solids.draw(part, places.roomFromHead);
    if (places.roomFromCoat) {
      solids.draw(coats[i], *places.roomFromCoat);
      for (const Solid& part : below) solids.draw(part, *places.roomFromCoat);
    }
    if (places.roomFromWand) solids.draw(wand, *places.roomFromWand);
  }
}

void SpectatorView::Drawing::drawBodies(const RoomSimultaneity& moment, std::span<const WorldLine> histories,
                                        float covers) const {
  std::size_t placed = histories.size();
  std::optional<glm::dmat4> place;
  soft->draw(solids, covers);
  for (const BodySolid& part : bodies) {
    if (soft->has(part.body)) continue;
    if (part.body != placed) place = moment.roomFromBody(histories[part.body]);
    placed = part.body;
    if (place) solids.draw(part.solid, *place, covers);
  }
}

/// Draws the people of another room where they were told last, by this time of the room.
void SpectatorView::Drawing::drawPeople(const RoomSimultaneity& moment, std::span<const ToldPath> paths,
                                        float covers) const {
  if (firstPerson == 0) return;
  for (std::size_t person = 0; person < paths.size(); ++person) {
    const auto at = paths[person].at([&](const Event& event) { return moment.since_s(event); });
    if (!at) continue;
    for (const BodySolid& part : people) {
      const std::size_t number = part.body - firstPerson;
      if (number / kBodiesOfPerson != person) continue;
      const auto which = static_cast<PersonBody>(number % kBodiesOfPerson);
      if (which == PersonBody::hand && !at->handMoment->hasHand) continue;
      if (which == PersonBody::cue && !at->handMoment->hasCue) continue;
      const double angle_rad = which == PersonBody::cue ? at->handMoment->cue_rad : at->moment->facing_rad;
      const glm::dmat4 place = moment.roomFrom(which == PersonBody::head ? at->head : at->hand, at->u);
      solids.draw(part.solid, glm::rotate(place, angle_rad, glm::dvec3(0.0, 0.0, 1.0)), covers);
    }
  }
}

void SpectatorView::Drawing::drawSculpture(const FrameRecord& record, const World& world) {
  ownLines.follow(record);
  if (!record.views.spacetime || sculpted.bodies.empty()) return sculpture.reset();
  if (!sculpture) sculpture = std::make_unique<RoomSculpture>(sculpted);
  sculpture->look(record, world, ownLines, view.camera_m, 0, {});
  sculpture->draw(glm::mat4(glm::translate(view.clipFromRoom, view.camera_m)), target.framebuffer(), size_px);
}

/// Draws only the table's nearest surface, by drawing its depth first.
void SpectatorView::Drawing::drawTable(const glm::dmat4& roomFromTable) const {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (const Solid& part : table) solids.draw(part, roomFromTable, kTableCovers);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  for (const Solid& part : table) solids.draw(part, roomFromTable, kTableCovers);
  glDepthFunc(GL_LESS);
}

/// Adds the frame of a wall, and lines of sight from eyes to its corners.
void SpectatorView::Drawing::outline(const Wall& wall, std::span<const glm::dvec3> eyes_m) {
  constexpr double kFrame_m = 0.014, kFarFrame_m = 0.3 * kFrame_m, kSight_m = 0.003;
  const Corners corners_m = cornersOf(wall);
  const bool inside = showsInside(wall, view.camera_m);
  for (std::size_t i = 0; i < 4; ++i) {
    lines.push_back(
        {corners_m[i], corners_m[(i + 1) % 4], inside ? kFrame_m : kFarFrame_m, inside ? kFrame : kFarFrame});
    for (const glm::dvec3& eye_m : eyes_m) lines.push_back({eye_m, corners_m[i], kSight_m, kSight});
  }
}

void SpectatorView::Drawing::drawLines(const FrameRecord& record,
                                       const std::optional<glm::dmat4>& roomFromTable) {
  constexpr double kEdge_m = 0.005;
  std::array<glm::dvec3, kMostViewers> heads_m;
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer)
    heads_m[viewer] = record.viewers[viewer].observer.middle.positionInRoom_m;
  lines.clear();
  for (const Wall& wall : surfaces.walls())
    outline(wall, std::span(heads_m).first(room.isHeadset ? 0 : record.viewerCount));
  const ObserverView& first = record.viewers.front().observer;
  const std::array<glm::dvec3, 2> eyes_m{first.left.positionInRoom_m, first.right.positionInRoom_m};
  for (std::size_t eye = 0; eye < 2 && isWorn; ++eye) outline(hung[eye], std::span(eyes_m).subspan(eye, 1));
  const std::size_t ofRoom = lines.size();
  const auto inRoom_m = [&](const glm::dvec3& onBoard_m) {
    return glm::dvec3(*roomFromTable * glm::dvec4(onBoard_m, 1.0));
  };
  for (const Corners& edge_m : tableEdges) {
    for (std::size_t i = 0; i < 4 && roomFromTable; ++i)
      lines.push_back({inRoom_m(edge_m[i]), inRoom_m(edge_m[(i + 1) % 4]), kEdge_m, kTableEdge});
  }
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);  // in front of the edges that they follow
  glPolygonOffset(-2.0F, -2.0F);
  ribbons.draw(lines, view.clipFromRoom, size_px);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthFunc(GL_GREATER);  // the table's edges behind a wall are dim
  for (std::size_t i = ofRoom; i < lines.size(); ++i) lines[i].colour.a *= kBehindCovers;
  ribbons.draw(std::span<const Ribbon>(lines).subspan(ofRoom), view.clipFromRoom, size_px);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
}

SpectatorView::SpectatorView(Graphics& graphics, const RoomGeometry& room, const Scene& scene,
                             std::span<const ScenePart> table, const std::optional<WindowPlacement>& window) {
  graphics.makeCurrent();
  drawing_ = std::make_unique<Drawing>(graphics, room, makeViewerModel());
  drawing_->makeGame(scene, table);
  if (window) {
    drawing_->window = std::make_unique<Window>(graphics, texts::title::kOutside.words(), *window);
    graphics.makeCurrent();
  }
}

void SpectatorView::setScene(const Scene& scene, std::span<const ScenePart> table) {
  drawing_->graphics.makeCurrent();
  drawing_->makeGame(scene, table);
}

SpectatorView::~SpectatorView() { drawing_->graphics.makeCurrent(); }

void SpectatorView::draw(const FrameRecord& record, const World& world, const DisplayWalls& walls) {
  Drawing& d = *drawing_;
  d.graphics.makeCurrent();
  d.size_px = d.window ? glm::max(d.window->size_px(), glm::ivec2(1)) : kPicture_px;
  if (!d.picture || d.picture->size_px() != d.size_px) d.picture = std::make_unique<RenderTarget>(d.size_px);
  d.view = {d.camera.clipFromRoom(d.size_px), d.camera.place_m(), d.size_px};
  d.putOn(record.headset);
  const EyeView& middle = record.viewers.front().observer.middle;
  const RoomSimultaneity moment(record.boardFromRoom, middle.observation, middle.seenFromInRoom_m);

  d.soft->place(record.boardFromRoom, middle.observation, middle.seenFromInRoom_m, world.soft);

  d.target.forgetViewport();
  d.target.begin(d.size_px);
  const GlStateGuard state(d.target.framebuffer(), d.size_px);
  d.surfaces.drawGround(d.view);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  d.surfaces.drawPanels(d.view, walls);
  if (d.isWorn) d.surfaces.drawPanel(d.hung[0], d.view, walls);
  d.solids.begin(d.view, d.room.up, glm::cross(d.room.forward, d.room.up));
  // Draws dimly what stands behind a wall.
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_FALSE);
  d.drawBodies(moment, world.histories, kBehindCovers);
  d.drawPeople(moment, world.people, kBehindCovers);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  d.drawViewers(record);
  d.drawBodies(moment, world.histories, 1.0F);
  d.drawPeople(moment, world.people, 1.0F);
  const std::optional<glm::dmat4> roomFromTable = moment.roomFromBody(world.histories[kRestingBody]);
  if (roomFromTable) d.drawTable(*roomFromTable);
  d.drawLines(record, roomFromTable);
  glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  d.surfaces.drawNames(d.view);
  d.drawSculpture(record, world);
  glViewport(0, 0, d.size_px.x, d.size_px.y);
  if (d.smoother) {
    d.smoother->copy(d.target, *d.picture, 0);
  } else {
    d.target.copyTo(*d.picture, 0);
  }
}

const RenderTarget& SpectatorView::picture() const { return *drawing_->picture; }

Capture::Taken SpectatorView::taken() const {
  static const std::string kName = "outside";
  return {drawing_->picture.get(), &kName, Eye::middle};
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

std::optional<ScreenPlace> SpectatorView::place() const {
  return drawing_->window ? std::optional(drawing_->window->place()) : std::nullopt;
}

void SpectatorView::swap() {
  if (drawing_->window) drawing_->window->swap();
}

}  // namespace carom
