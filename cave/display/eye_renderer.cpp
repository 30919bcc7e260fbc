#include "cave/display/eye_renderer.h"

#include <algorithm>
#include <array>

#include <vtk_glew.h>
#include <glm/geometric.hpp>

#include "cave/bodies/people_view.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/marks/travelling_light.h"

namespace carom {
namespace {

/// How bright pucks and bodies are as they are seen, as a share, while a lesson explains what ghosts show.
constexpr float kSeenBehindGhosts = 0.35F;

/// Returns whether the body always keeps this motion. If so, at any moment of the frame with this motion it
/// is where it is seen.
bool stays(const WorldLine& line, const Vec3& u) {
  constexpr double kSame_u = 1e-6;
  const Knot& first = line.knots().front();
  return line.knots().size() == 1 && first.deceleration_m_s2 == 0.0 && glm::distance(first.u, u) < kSame_u;
}

}  // namespace

void drawSplitLine(const RenderTarget& picture) {
  const glm::ivec2 size_px = picture.size_px();
  const GlStateGuard state(picture.framebuffer(), size_px);
  glEnable(GL_SCISSOR_TEST);
  glScissor(size_px.x / 2 - EyeRenderer::kSplitLine_px / 2, 0, EyeRenderer::kSplitLine_px, size_px.y);
  const std::array<float, 4> white{1.0F, 1.0F, 1.0F, 1.0F};
  glClearBufferfv(GL_COLOR, 0, white.data());
}

Wall columnsOf(const Wall& wall, int left_px, int right_px) {
  const glm::dvec3 along = (wall.lowerRight_m - wall.lowerLeft_m) / static_cast<double>(wall.pixels.x);
  Wall part = wall;
  part.lowerLeft_m += along * static_cast<double>(left_px);
  part.upperLeft_m += along * static_cast<double>(left_px);
  part.lowerRight_m = wall.lowerLeft_m + along * static_cast<double>(right_px);
  part.pixels.x = right_px - left_px;
  return part;
}

EyeRenderer::EyeRenderer(Graphics& graphics, const Scene& scene, double lightSpeed_m_s)
    : graphics_(graphics),
      scene_(scene),
      renderer_(graphics, scene, lightSpeed_m_s),
      hot_(scene.coldMasses_kg, scene.bodyCount, lightSpeed_m_s),
      bodies_(scene.bodyCount) {}

EyeRenderer::~EyeRenderer() { graphics_.makeCurrent(); }

void EyeRenderer::draw(const FrameRecord& record, const World& world, const ObserverView& observer,
                       const EyeView& eye, std::span<const PicturedWall> walls, std::size_t viewer) {
  hot_.follow(world.events, record.eventsKept);
  if (walls.empty()) return;
  const bool split = record.views.split != 0;
  look(renderer_, record.switches, record, world, observer, eye);
  lookAtSculpture(record, world, observer, eye, viewer);
  drawPart(renderer_, split ? Part::left : Part::whole, eye, walls);
  if (!split) return;
  if (!beside_)
    beside_ = std::make_unique<WallRenderer>(graphics_, scene_, world.histories.front().lightSpeed_m_s());
  look(*beside_, record.views.beside, record, world, observer, eye);
  drawPart(*beside_, Part::right, eye, walls);
  for (const PicturedWall& wall : walls)
    if (wall.split_px > 0 && wall.split_px < wall.wall->pixels.x) drawSplitLine(*wall.picture);
}

void EyeRenderer::look(WallRenderer& renderer, const Switches& switches, const FrameRecord& record,
                       const World& world, const ObserverView& observer, const EyeView& eye) {
  for (std::size_t body = 0; body < world.histories.size(); ++body) {
    viewBody(world.histories[body], eye.observation, observer.headFromBoard, bodies_[body], switches);
  }
  const SeenPeople people = viewPeople(scene_, world.people, switches, observer, eye, bodies_);
  const TimeViews& views = record.views;
  const Ghosts ghosts = viewGhosts(switches, record, world, observer, eye);
  SoftLook soft{world.soft, views.strain ? Told::strain : views.heat ? Told::heat : Told::nothing};
  if (!ghosts.boardNow.empty()) soft.boardNow = Event{observer.middle.observation.t_s, eye.observation.r_m};
  if (!ghosts.myNow.empty()) soft.myNow = eye.observation;
  renderer.look(observer.headFromBoard, eye, bodies_, switches, ghosts, soft, hot_.seenFrom(eye.observation));
  marked_ = !scene_.pulses.empty() || people.count > 0 || record.lesson.phase != LessonPhase::none ||
            isStrokeUnderWay(world.events, observer) ||
            std::any_of(kNamedViews.begin(), kNamedViews.end(),
                        [&](const NamedView& view) { return view.isMark && views.*view.value; });
  if (!marked_) return;
  graphics_.makeCurrent();
  if (!marks_) marks_ = std::make_unique<SpacetimeMarks>(scene_);
  marks_->look({observer, eye, switches, views, record.pucks, world.histories, bodies_, world.events, ghosts,
                record.lesson, record.boardFromRoom, people.all()});
}

/// The sculpture is the same for both halves of a split wall; its threads lead to what the left half shows.
void EyeRenderer::lookAtSculpture(const FrameRecord& record, const World& world, const ObserverView& observer,
                                  const EyeView& eye, std::size_t viewer) {
  lines_.follow(record);
  if (record.views.spacetime == 0 || scene_.sculpted.bodies.empty()) return sculpture_.reset();
  graphics_.makeCurrent();
  if (!sculpture_) sculpture_ = std::make_unique<RoomSculpture>(scene_.sculpted);
  const MarkContext sight{
      observer, eye, record.switches, record.views, record.pucks, world.histories, bodies_, world.events, {}};
  tops_.clear();
  for (std::size_t i = 0; i < scene_.sculpted.bodies.size(); ++i) {
    const SculptedBody& body = scene_.sculpted.bodies[i];
    const OnBody seen(sight, bodies_[body.body], ViewTime::seen);
    tops_.push_back({i, seen({0.0, 0.0, 0.5 * body.puck.height_m})});
  }
  sculpture_->look(record, world, lines_, eye.seenFromInRoom_m, viewer, tops_);
}

Ghosts EyeRenderer::viewGhosts(const Switches& switches, const FrameRecord& record, const World& world,
                               const ObserverView& observer, const EyeView& eye) {
  const TimeViews& views = record.views;
  // Scripted scenery, and scripted bodies that move with the person, need no ghost: it would coincide with
  // them. People of another room have no ghosts: their places at those moments are not known yet.
  const auto view = [&](std::vector<BodyView>& ghosts, const Event& observation, ViewTime moment,
                        const Vec3& u) {
    ghosts.resize(bodies_.size());
    for (std::size_t body = world.histories.size(); body < ghosts.size(); ++body) ghosts[body].legs.clear();
    for (std::size_t body = 0; body < world.histories.size(); ++body) {
      const WorldLine& line = world.histories[body];
      viewBody(line, observation, observer.headFromBoard, ghosts[body], switches, moment);
      if (body > record.pucks && stays(line, u)) ghosts[body].legs.clear();
    }
    return std::span<const BodyView>(ghosts);
  };
  Ghosts ghosts;
  // The ghosts are at one moment for both eyes, that of the point between them, so that both eyes see the
  // same. Without retardation the bodies themselves are drawn there.
  if (views.boardNow && switches.retardation) {
    const Event moment{observer.middle.observation.t_s, eye.observation.r_m};
    ghosts.boardNow = view(boardNow_, moment, ViewTime::boardNow, Vec3(0.0));
  }
  if (views.myNow) ghosts.myNow = view(myNow_, eye.observation, ViewTime::myNow, record.boardFromRoom.u());
  const bool showGhosts = !ghosts.boardNow.empty() || !ghosts.myNow.empty();
  if (record.lesson.phase == LessonPhase::explains && showGhosts) ghosts.seenShare = kSeenBehindGhosts;
  return ghosts;
}

void EyeRenderer::drawPart(WallRenderer& renderer, Part part, const EyeView& eye,
                           std::span<const PicturedWall> walls) {
  parts_.clear();
  pictures_.clear();
  parts_.reserve(walls.size());
  for (const auto& [wall, picture, meters, split_px] : walls) {
    if (part == Part::left && split_px == 0) continue;
    if (part == Part::right && split_px == wall->pixels.x) continue;
    WallDrawing drawing;
    drawing.seenFromEye_m = eye.seenFromInRoom_m - eye.positionInRoom_m;
    drawing.left_px = part == Part::right ? split_px : 0;
    drawing.sculpture = sculpture_.get();
    drawing.marks = marked_ ? marks_.get() : nullptr;
    const bool isCut = part != Part::whole && split_px > 0 && split_px < wall->pixels.x;
    drawing.cutAt = !isCut ? 0.0F : part == Part::left ? 1.0F : -1.0F;
    const Wall* drawn = wall;
    if (part != Part::whole) {
      const int right_px = part == Part::left ? split_px : wall->pixels.x;
      drawn = &parts_.emplace_back(columnsOf(*wall, drawing.left_px, right_px));
    }
    pictures_.push_back(
        {drawn, picture, drawing, meters ? &(*meters)[part == Part::right ? 1 : 0] : nullptr});
  }
  renderer.draw(pictures_, eye.positionInRoom_m);
}

}  // namespace carom
