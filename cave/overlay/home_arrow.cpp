#include "cave/overlay/home_arrow.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/gl/gl_state_guard.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/hud/hud_text.h"
#include "cave/overlay/comfort_overlay.h"
#include "cave/room/off_axis.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

constexpr double kLetters = 0.045;  // of the wall's height
constexpr double kLength = 0.16,
                 kOff = 0.30;  // of the wall's height: the arrow, and its middle from the wall's
constexpr double kHalfLine = 0.008, kHead = 0.06;  // of the wall's height
constexpr double kSeenByHead = 0.77;               // cosine of 40°, which every headset shows
constexpr double kBeside = 1.02;                   // a point just beside a wall counts as on it
constexpr glm::vec4 kColour{1.0F, 0.75F, 0.2F, 0.95F}, kRim{0.0F, 0.0F, 0.0F, 0.6F};

/// Returns whether the wall shows what an eye sees in this direction.
bool shows(const Wall& wall, const glm::dvec3& eye_m, const glm::dvec3& towards) {
  const std::optional<glm::dmat4> clip = clipFromEye(wall, eye_m);
  if (!clip) return false;
  const glm::dvec4 at = *clip * glm::dvec4(towards, 1.0);
  return at.w > 0.0 && std::abs(at.x) <= kBeside * at.w && std::abs(at.y) <= kBeside * at.w;
}

}  // namespace

SeenTable seenTable(const SeenFrame& seen) {
  const Event& eye = seen.self.observer.middle.observation;
  const double far_m = glm::length(eye.r_m);
  // The light's way as an event: it leaves the table at r = 0, far/c before it arrives.
  const glm::dmat4 roomFromBoard = seen.record.boardFromRoom.inverse().matrix();
  const glm::dvec4 way = roomFromBoard * glm::dvec4(-far_m, -eye.r_m.x, -eye.r_m.y, -eye.r_m.z);
  const glm::dvec3 inRoom_m(way.y, way.z, way.w);
  const double seen_m = glm::length(inRoom_m);
  return {seen_m > 0.0 ? inRoom_m / seen_m : glm::dvec3(0.0), far_m};
}

std::optional<glm::dvec2> wayHome(const RoomGeometry& room, const SeenFrame& seen) {
  const std::optional<Wall> front = frontWall(room);
  // A lesson and a scripted flight take their observers where they want them.
  const bool isFree =
      seen.record.drive.mode != DriveMode::tour && seen.record.lesson.phase == LessonPhase::none;
  if (!front || !isFree) return {};
  const glm::dvec3 eye_m = seen.self.observer.middle.positionInRoom_m;
  const glm::dvec3 towards = seenTable(seen).towards;
  const bool isSeen = room.isHeadset
                          ? glm::dot(sightOf(room, seen), towards) > kSeenByHead
                          : std::any_of(room.walls.begin(), room.walls.end(),
                                        [&](const Wall& wall) { return shows(wall, eye_m, towards); });
  if (isSeen || !(glm::length(towards) > 0.0)) return {};
  const glm::dvec3 right = glm::normalize(front->lowerRight_m - front->lowerLeft_m),
                   up = glm::normalize(front->upperLeft_m - front->lowerLeft_m);
  const glm::dvec2 way(glm::dot(towards, right), glm::dot(towards, up));
  const bool isBehind = glm::dot(towards, normalOf(*front)) > 0.0;
  if (isBehind) return glm::dvec2(way.x < 0.0 ? -1.0 : 1.0, 0.0);  // to turn round is to turn sideways first
  const double length = glm::length(way);
  return length > 1e-9 ? way / length : glm::dvec2(1.0, 0.0);
}

void HomeArrow::draw(const RoomGeometry& room, const Wall& front, const glm::dvec3& eyeInRoom_m,
                     const SeenFrame& seen, const RenderTarget& picture) {
  const std::optional<glm::dvec2> way = wayHome(room, seen);
  const std::optional<glm::dmat4> clip = way ? clipFromRoom(front, eyeInRoom_m) : std::nullopt;
  if (!clip) return;
  const glm::dvec2 size_m = sizeOf_m(front);
  const glm::dvec3 right = (front.lowerRight_m - front.lowerLeft_m) / size_m.x,
                   up = (front.upperLeft_m - front.lowerLeft_m) / size_m.y;
  const glm::dvec3 middle_m = 0.5 * (front.lowerRight_m + front.upperLeft_m);
  const auto onWall_m = [&](const glm::dvec2& at) {
    return middle_m + size_m.y * (at.x * right + at.y * up);
  };
  const glm::dvec2 tip = (kOff + 0.5 * kLength) * *way, foot = (kOff - 0.5 * kLength) * *way;
  const glm::dvec2 aside(-way->y, way->x);
  lines_.clear();
  for (const bool isRim : {true, false}) {
    const double half_m = (isRim ? 1.6 : 1.0) * kHalfLine * size_m.y;
    const glm::vec4& colour = isRim ? kRim : kColour;
    lines_.push_back({onWall_m(foot), onWall_m(tip), half_m, colour});
    for (const double side : {-0.7, 0.7})
      lines_.push_back({onWall_m(tip), onWall_m(tip - kHead * *way + side * kHead * aside), half_m, colour});
  }
  {
    const GlStateGuard state(picture.framebuffer(), picture.size_px());
    blendOver();
    ribbons_.draw(lines_, *clip, picture.size_px());
  }
  const int height_px = std::max(8, static_cast<int>(kLetters * picture.size_px().y));
  const long distance_m = std::lround(seenTable(seen).distance_m);
  if (height_px != height_px_ || distance_m != distance_m_ || language_ != texts::language()) {
    language_ = texts::language();
    height_px_ = height_px;
    distance_m_ = distance_m;
    const std::string words = texts::format(texts::message::kWayHome, distance_m);
    const int room_px = picture.size_px().x - height_px;
    GlyphBitmap text = ink(words, height_px);
    if (text.size_px.x > room_px) text = ink(words, std::max(8, height_px * room_px / text.size_px.x));
    words_.begin(text.size_px + glm::ivec2(height_px), {10, 14, 20, 190});
    words_.write(glm::ivec2(height_px / 2), text, glm::vec3(245.0F));
    words_.upload();
  }
  const glm::ivec2 foot_px(0.5 * (picture.size_px().x - words_.size_px().x), 0.28 * picture.size_px().y);
  words_.draw(picture, foot_px, 1.0);
}

}  // namespace carom
