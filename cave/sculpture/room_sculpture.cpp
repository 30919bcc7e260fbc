#include "cave/sculpture/room_sculpture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtk_glew.h>

#include "cave/gl/gl_state_guard.h"
#include "cave/gl/view_colours.h"
#include "cave/sculpture/sculpture_marks.h"
#include "engine/sculpture/sculpture_reach.h"

namespace carom {
namespace {

// Times on the graphics card are counted from a multiple of this, so that single precision is good to 0.03 mm
// in the room.
constexpr double kBase_s = 1024.0;
constexpr double kFine_m = 1e-3;  // by which tubes may be off in the room
const Vec3 kShadowAside(-0.22, -0.05,
                        0.12);  // how far beside it the shadow of a metre's height lies, room frame
constexpr double kOverFloor_m = 0.004;

/// Returns the same for the board, as a power of two, so that tubes are seldom made anew while they are
/// scaled.
double fineOf(const SculpturePlace& place) { return std::exp2(std::floor(std::log2(kFine_m / place.scale))); }

/// Returns the person about whose present spacetime stands.
const ObserverView& firstOf(const FrameRecord& record) { return record.viewers[record.ofRoom(0)].observer; }

SculptureMap mapOf(const FrameRecord& record) {
  const ObserverView& first = firstOf(record);
  return {record.sculpture.place, first.middle.observation, first.headFromBoard.lightSpeed_m_s()};
}

/// Of a disc the borders are bright; the sides of an outline are wide, and would be so all over.
GlassLook tubeLook(const SculptedBody& body) {
  GlassLook look;
  look.colour = codeOf(glm::max(body.colour, glm::vec3(0.06F)));
  look.taken = 0.70F;
  look.shine = 0.10F;
  look.edge = body.puck.outline_m.empty() ? 0.24F : 0.12F;
  look.closed = true;
  return look;
}

}  // namespace

RoomSculpture::RoomSculpture(const SculptedGame& game)
    : shape_(game),
      cushions_(glass_.mesh()),
      seen_(glass_.mesh()),
      boardNow_(glass_.mesh()),
      myNow_(glass_.mesh()) {
  for (const SculptedBody& body : game.bodies) tubes_.push_back({{}, glass_.mesh(), tubeLook(body)});
  for (const Tube& tube : tubes_) pieces_.push_back({&tube.mesh, tube.look});
  pieces_.push_back({&cushions_, sheetLook({0.55F, 0.75F, 0.70F}, 0.03F)});
  pieces_.push_back({&boardNow_, sheetLook(kBoardNowColour, 0.06F)});
  pieces_.push_back({&myNow_, sheetLook(kMyNowColour, 0.06F)});
  pieces_.push_back({&seen_, sheetLook(glm::vec3(1.0F, 0.98F, 0.9F), 0.08F)});
}

void RoomSculpture::follow(const FrameRecord& record, const World& world) {
  if (frame_ == record.number) return;
  frame_ = record.number;
  shape_.follow(record, world);
  followTubes(record, world);
  makeSurfaces(record);
}

void RoomSculpture::followTubes(const FrameRecord& record, const World& world) {
  const ObserverView& first = firstOf(record);
  const Event& now = first.middle.observation;
  const SculpturePlace& place = record.sculpture.place;
  const double c_m_s = first.headFromBoard.lightSpeed_m_s(), fine_m = fineOf(place);
  // Pucks between cushions are never further away than this; it is rounded up, so that it seldom changes.
  const double slice_m = c_m_s * GrowingTube::kSlice_s,
               away_m = glm::length(glm::dvec2(now.r_m)) + glm::length(shape_.game().half_m);
  const double within_s = reachWithin_s(place, c_m_s, slice_m * std::ceil(away_m / slice_m)),
               past_s = sculptureReach_s(place, c_m_s);
  base_s_ = kBase_s * std::floor(now.t_s / kBase_s);
  for (std::size_t i = 0; i < tubes_.size(); ++i) {
    const SculptedBody& body = shape_.game().bodies[i];
    Tube& tube = tubes_[i];
    const bool isHeld = shape_.game().hasCushions && body.body <= record.pucks;
    const double shown_s = isHeld ? within_s : past_s;
    const std::optional<SoftRim> soft = shape_.softRim(i, world);
    const bool isNew =
        soft ? tube.shape.follow(*soft, shown_s, now.t_s, base_s_, fine_m)
             : tube.shape.follow(body.puck, world.histories[body.body], shown_s, now.t_s, base_s_, fine_m);
    if (!isNew) continue;
    tube.mesh.upload(tube.shape.points(), tube.shape.triangles());
    tube.reach_m = 0.0;
    for (const glm::vec3& point : tube.shape.points())
      tube.reach_m = std::max<double>({tube.reach_m, std::abs(point.x), std::abs(point.y)});
  }
}

/// Leaves out what of the tubes is shown below the foot or above the top.
void RoomSculpture::chooseTriangles(const SculptureMap& map) {
  for (std::size_t i = 0; i < tubes_.size(); ++i) {
    const double away_m =
        glm::length(glm::dvec2(map.present().r_m)) + std::numbers::sqrt2 * tubes_[i].reach_m;
    pieces_[i].triangles = tubes_[i].shape.trianglesIn(map.shownWithin(away_m));
  }
}

/// Spreads the surfaces of all viewers over the rectangle, and the cushions as panes.
void RoomSculpture::makeSurfaces(const FrameRecord& record) {
  const double c_m_s = firstOf(record).headFromBoard.lightSpeed_m_s();
  const auto corner = [&](const Event& event) {
    return glm::vec3(event.r_m.x, event.r_m.y, c_m_s * (event.t_s - base_s_));
  };
  const auto sheet = [&](std::size_t viewer, ViewTime moment, int cells) {
    const auto first = static_cast<std::uint32_t>(corners_.size()),
               row = static_cast<std::uint32_t>(cells + 1);
    for (int y = 0; y <= cells; ++y) {
      for (int x = 0; x <= cells; ++x) {
        const glm::dvec2 share(static_cast<double>(x) / cells, static_cast<double>(y) / cells);
        const glm::dvec2 place_m = shape_.low_m() + (shape_.high_m() - shape_.low_m()) * share;
        corners_.push_back(corner(surfaceEvent(record.viewers[record.ofRoom(viewer)].observer, moment,
                                               place_m, shape_.game().top_m)));
      }
    }
    for (std::uint32_t y = 0; y + 1 < row; ++y) {
      for (std::uint32_t x = 0; x + 1 < row; ++x) {
        const std::uint32_t at = first + y * row + x;
        triangles_.push_back({at, at + 1, at + row + 1});
        triangles_.push_back({at, at + row + 1, at + row});
      }
    }
  };
  const auto fill = [&](GlassMesh& mesh, std::size_t viewers, ViewTime moment, int cells) {
    corners_.clear();
    triangles_.clear();
    for (std::size_t viewer = 0; viewer < viewers; ++viewer) sheet(viewer, moment, cells);
    mesh.upload(corners_, triangles_);
  };
  fill(seen_, record.viewerCount, ViewTime::seen, kSurfaceCells);
  fill(myNow_, record.viewerCount, ViewTime::myNow, 1);
  fill(boardNow_, 1, ViewTime::boardNow, 1);
  corners_.clear();
  triangles_.clear();
  const glm::dvec2 half_m = shape_.game().half_m;
  const std::array<glm::dvec2, 4> around{{-half_m, {half_m.x, -half_m.y}, half_m, {-half_m.x, half_m.y}}};
  const double now_s = firstOf(record).middle.observation.t_s;
  const double reach_s = sculptureReach_s(record.sculpture.place, c_m_s);
  for (std::uint32_t k = 0; k < 4 && shape_.game().hasCushions; ++k) {
    for (const double t_s : {now_s - reach_s, now_s + reach_s})
      for (const std::size_t at : {std::size_t{k}, std::size_t{k + 1} % 4})
        corners_.push_back(corner({t_s, {around[at], 0.0}}));
    triangles_.push_back({4 * k, 4 * k + 1, 4 * k + 3});
    triangles_.push_back({4 * k, 4 * k + 3, 4 * k + 2});
  }
  cushions_.upload(corners_, triangles_);
}

// The map is affine: its matrix follows from where the origin and three unit steps are shown. The origin is
// taken at the present, so that the differences are small.
GlassPlace RoomSculpture::placeFrom(const SculptureMap& map, const Vec3& viewpoint_m) const {
  const double c_m_s = map.lightSpeed_m_s();
  const Event origin{map.present().t_s, Vec3(0.0)};
  const double origin_m = c_m_s * (origin.t_s - base_s_);
  const std::array<Event, 3> steps{Event{origin.t_s, {1.0, 0.0, 0.0}}, Event{origin.t_s, {0.0, 1.0, 0.0}},
                                   Event{origin.t_s + 1.0 / c_m_s, Vec3(0.0)}};
  const Vec3 room_m = map.room_m(origin), model_m = map.model_m(origin);
  glm::dmat4 drawn(1.0);
  glm::dvec4 height(0.0);
  for (int k = 0; k < 3; ++k) {
    const Event& step = steps[static_cast<std::size_t>(k)];
    drawn[k] = glm::dvec4(map.room_m(step) - room_m, 0.0);
    height[k] = map.model_m(step).z - model_m.z;
  }
  drawn[3] = glm::dvec4(room_m - viewpoint_m, 1.0) - drawn[2] * origin_m;
  drawn[3].w = 1.0;
  height.w = model_m.z - height.z * origin_m;
  GlassPlace place;
  place.drawnFromEvent = glm::mat4(drawn);
  // The light falls along one way of the room, however the sculpture is turned: its shadow at the height h is
  // h kShadowAside beside it.
  const SculpturePlace& at = map.place();
  const Vec3 up = at.roomFromFoot.orientation * Vec3(0.0, 0.0, 1.0);
  const Vec3 aside = kShadowAside - up * glm::dot(kShadowAside, up);
  place.shadowFromEvent =
      glm::mat4(drawn + glm::outerProduct(glm::dvec4(at.scale * (aside - up), 0.0), height));
  place.shadowFromEvent[3] += glm::vec4(glm::vec3(up * kOverFloor_m), 0.0F);
  place.heightOfEvent = glm::vec4(height);
  place.present_m = static_cast<float>(map.present_m());
  place.top_m = static_cast<float>(map.top_m());
  return place;
}

// In a frame of β an event at x and height h over the present is shown at x_o + (x − x_o)/γ − β h, where x_o
// is the present's: at most the larger of |x| and |x_o|, and β h more.
void RoomSculpture::bound(const SculptureMap& map, const Vec3& viewpoint_m) {
  const SculpturePlace& place = map.place();
  const Vec3 present_m = glm::abs(map.present().r_m), low_m = glm::abs(Vec3(shape_.low_m(), 0.0)),
             high_m = glm::abs(Vec3(shape_.high_m(), 0.0));
  double reach_m = 0.0;
  for (const Vec3& each : {present_m, low_m, high_m}) reach_m = std::max({reach_m, each.x, each.y});
  for (const Tube& tube : tubes_) reach_m = std::max(reach_m, tube.reach_m);
  reach_m += glm::length(place.beta) * std::max(map.present_m(), map.top_m() - map.present_m());
  for (std::size_t i = 0; i < boundCorners_.size(); ++i) {
    const Vec3 model_m((i & 1U) ? reach_m : -reach_m, (i & 2U) ? reach_m : -reach_m,
                       (i & 4U) ? map.top_m() : 0.0);
    boundCorners_[i] = glm::vec4(place.roomFromFoot * (place.scale * model_m) - viewpoint_m, 1.0);
  }
}

/// Returns whether the box is not wholly on the far side of one of the picture's borders, or behind the eye.
bool RoomSculpture::mayShow(const glm::mat4& clipFromDrawn) const {
  std::array<int, 5> beyond{};
  for (const glm::vec4& corner : boundCorners_) {
    const glm::vec4 clip = clipFromDrawn * corner;
    for (int axis = 0; axis < 2; ++axis) {
      beyond[static_cast<std::size_t>(2 * axis)] += clip[axis] > clip.w ? 1 : 0;
      beyond[static_cast<std::size_t>(2 * axis + 1)] += clip[axis] < -clip.w ? 1 : 0;
    }
    beyond[4] += clip.w < 0.0F ? 1 : 0;
  }
  return std::find(beyond.begin(), beyond.end(), 8) == beyond.end();
}

void RoomSculpture::look(const FrameRecord& record, const World& world, const OwnLines& lines,
                         const Vec3& viewpoint_m, std::size_t viewer, std::span<const SeenTop> tops) {
  follow(record, world);
  const SculptureMap map = mapOf(record);
  place_ = placeFrom(map, viewpoint_m);
  bound(map, viewpoint_m);
  chooseTriangles(map);
  marks_.batch.clear();
  const SculptureSight sight{map, shape_, lines, record, world.events, viewpoint_m, viewer, marks_.memory};
  addSculpture(sight, marks_.batch);
  for (const SeenTop& top : tops) {
    for (const TubeCut& cut : shape_.cuts())
      if (cut.body == top.body && cut.viewer == viewer && cut.moment == ViewTime::seen)
        addThread(sight, cut, top.drawn_m, marks_.batch);
  }
  marks_.drawer.upload(marks_.batch);
}

void RoomSculpture::draw(const glm::mat4& clipFromDrawn, unsigned framebuffer, const glm::ivec2& size_px,
                         float cutAt) const {
  const GlStateGuard state(framebuffer, size_px);
  glEnable(GL_DEPTH_TEST);
  if (mayShow(clipFromDrawn)) glass_.draw(pieces_, place_, clipFromDrawn);
  glDepthMask(GL_FALSE);
  blendOver();
  marks_.drawer.draw(clipFromDrawn, cutAt);
}

}  // namespace carom
