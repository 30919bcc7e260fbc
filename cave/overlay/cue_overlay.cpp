#include "cave/overlay/cue_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/gl/gl_state_guard.h"
#include "cave/gl/letter_atlas.h"
#include "cave/room/off_axis.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

constexpr glm::vec4 kUnaimed(0.75F, 0.85F, 1.0F, 0.45F), kAimed(1.0F, 0.93F, 0.55F, 0.95F);
constexpr glm::vec4 kWood(0.80F, 0.56F, 0.30F, 1.0F), kTip(0.92F, 0.92F, 0.95F, 1.0F);
constexpr glm::vec4 kScaleGround(0.05F, 0.055F, 0.07F, 0.70F), kInk(0.93F, 0.93F, 0.93F, 1.0F),
    kTrack(0.25F, 0.26F, 0.30F, 1.0F);
constexpr double kOwnRay_m = 0.15;  // a ray that begins nearer to the eyes is seen end-on
constexpr double kRay_m = 0.002, kDot_m = 0.008;
constexpr std::array<double, 4> kTicks{0.5, 0.8, 0.9, 0.95};  // of c
constexpr double kDigits = 0.025, kTickDigits = 0.016;        // heights, as fractions of the distance
constexpr double kBar = 0.010, kPanel = 0.086,
                 kPanelMiddle = 0.065;                     // half widths, and the place of the panel's middle
constexpr double kReadout = 0.092, kForceReadout = 0.064;  // heights of the numbers below the bar

/// Whether a sign is a blank, also one that keeps a number and its unit together.
bool isBlank(char32_t sign) { return sign == U' ' || sign == 0x00A0 || sign == 0x2009 || sign == 0x202F; }

/// Returns the speed, in units of c, of u = γβ.
double betaOf(double u) { return u / std::sqrt(1.0 + u * u); }

/// Returns the colour of a cost, from low to high.
glm::vec4 colourOf(double cost) {
  const glm::vec3 easy(0.35F, 0.85F, 0.55F), dear(1.0F, 0.35F, 0.22F), between(1.0F, 0.80F, 0.30F);
  const auto share = static_cast<float>(std::min(cost / 2.0, 1.0));
  return {share < 0.5F ? glm::mix(easy, between, 2.0F * share) : glm::mix(between, dear, 2.0F * share - 1.0F),
          1.0F};
}

/// How far to the right of the target's centre the stroke passes, in the room.
glm::dvec3 asideOf(const HandView& hand, const RoomGeometry& room) {
  return hand.offset_m * glm::cross(hand.towards, room.up);
}

}  // namespace

FacingPlane facing(const glm::dvec3& place_m, const glm::dvec3& eyes_m, const RoomGeometry& room) {
  constexpr double kAslant_rad = 0.6;  // up to this angle from facing the eye, the plane is still readable
  FacingPlane plane{place_m, {}, {}, std::max(glm::distance(place_m, eyes_m), 0.1)};
  const glm::dvec3 sight = (place_m - eyes_m) / plane.distance_m;
  glm::dvec3 right = glm::cross(sight, room.up);
  if (glm::length(right) < 0.05) right = glm::cross(room.forward, room.up);  // the place lies straight below
  plane.right = glm::normalize(right);
  const double below_rad = std::asin(std::clamp(-glm::dot(sight, room.up), -1.0, 1.0));
  const double leans_rad = below_rad - std::clamp(below_rad, -kAslant_rad, kAslant_rad);
  plane.up = std::cos(leans_rad) * room.up + std::sin(leans_rad) * glm::cross(room.up, plane.right);
  return plane;
}

double CueOverlay::rimOf(const HandView& hand) const {
  return hand.target < rims_m_.size() ? std::max(kRim_m, rims_m_[hand.target]) : kRim_m;
}

double CueOverlay::ringOf(const HandView& hand) const { return std::max(kRing_m, rimOf(hand) + kBeside_m); }

double CueOverlay::scaleFoot(const FacingPlane& target, const glm::dvec3& eyes_m, const RoomGeometry& room) {
  constexpr double kBelowEyes = 0.33;  // the slope of sight to the far end of a table
  const double below_m = glm::dot(eyes_m - target.place_m, room.up);
  const double along_m = std::sqrt(std::max(target.distance_m * target.distance_m - below_m * below_m, 0.0));
  const double rises_m = below_m - kBelowEyes * along_m;
  return std::max(kScaleFoot, rises_m / target.distance_m + kReadout);
}

double CueOverlay::heightOf(double cost) { return kPerCost * std::clamp(cost, 0.0, kMostCost); }

void CueOverlay::addLine(const glm::dvec3& from_m, const glm::dvec3& to_m, double halfWidth_m,
                         const glm::vec4& colour) {
  marks_.push_back({from_m, to_m, halfWidth_m, colour});
}

void CueOverlay::addRing(const FacingPlane& plane, double radius_m, double halfWidth_m,
                         const glm::vec4& colour) {
  constexpr int kSides = 32;
  const auto at = [&](int i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kSides;
    return plane.place_m + radius_m * (std::cos(angle_rad) * plane.right + std::sin(angle_rad) * plane.up);
  };
  for (int i = 0; i < kSides; ++i) addLine(at(i), at(i + 1), halfWidth_m, colour);
}

/// Adds a dot as an octagon.
void CueOverlay::addDot(const FacingPlane& plane, double radius_m, const glm::vec4& colour) {
  for (int i = 0; i < 4; ++i) {
    const double angle_rad = std::numbers::pi * i / 4.0;
    const glm::dvec3 way_m = radius_m * (std::cos(angle_rad) * plane.right + std::sin(angle_rad) * plane.up);
    addLine(plane.place_m - way_m, plane.place_m + way_m, radius_m * std::tan(std::numbers::pi / 8.0),
            colour);
  }
}

/// Adds text whose lower left end is at (across, upwards), with capitals of this height. Points and blanks
/// are narrower than the face has them.
void CueOverlay::addText(const FacingPlane& plane, double across, double upwards, double height,
                         std::string_view text) {
  constexpr double kNarrow = 0.45;
  while (!text.empty()) {
    std::string_view after = text;
    const std::optional<char32_t> sign = takeCodePoint(after);
    const bool blank = sign && isBlank(*sign);
    const double advance = height * (blank || sign == U'.' || sign == U',' ? kNarrow : kLetterAdvance);
    if (!blank) {
      std::string_view letter = sign == U'^' ? kRaisedTwo : text;
      const std::uint8_t code = takeLetter(letter);
      const double size_m = height * plane.distance_m;
      words_.push_back(
          {code, plane.at(across + 0.5 * advance, upwards), size_m * plane.right, size_m * plane.up, kInk});
    }
    text = after;
    across += advance;
  }
}

/// Adds the ray. For the eye from which a ray starts it is a point, so only its end is drawn.
void CueOverlay::addRay(const HandView& hand, const glm::dvec3& eyes_m, const RoomGeometry& room) {
  const glm::vec4& colour = hand.target ? kAimed : kUnaimed;
  if (glm::distance(hand.from_m, eyes_m) > kOwnRay_m) addLine(hand.from_m, hand.to_m, kRay_m, colour);
  const FacingPlane end = facing(hand.to_m, eyes_m, room);
  const double dot_m = std::max(kDot_m, 0.004 * end.distance_m);
  addDot(end, dot_m, colour);
  if (!hand.target) return;
  addRing(facing(hand.target_m, eyes_m, room), ringOf(hand), 0.003 * std::max(end.distance_m, 1.0), colour);
}

/// Adds a stick behind the puck, thicker towards the hand, drawn back in proportion to the stroke's momentum.
void CueOverlay::addCue(const HandView& hand, const RoomGeometry& room) {
  constexpr int kPieces = 10;
  constexpr double kLength_m = 0.9, kThin_m = 0.006, kThick_m = 0.014;
  const glm::dvec3 tip_m =
      hand.target_m + asideOf(hand, room) - (rimOf(hand) + kDrawn_m * hand.u) * hand.towards;
  for (int i = 0; i < kPieces; ++i) {
    const double from = static_cast<double>(i) / kPieces, to = static_cast<double>(i + 1) / kPieces;
    addLine(tip_m - kLength_m * from * hand.towards, tip_m - kLength_m * to * hand.towards,
            glm::mix(kThin_m, kThick_m, 0.5 * (from + to)), i == 0 ? kTip : kWood);
  }
}

void CueOverlay::addArrow(const HandView& hand, const FacingPlane& plane, const RoomGeometry& room) {
  const double length_m = 0.1 + 0.4 * betaOf(hand.u), width_m = 0.003 * plane.distance_m;
  const glm::dvec3 foot_m = hand.target_m + asideOf(hand, room) + ringOf(hand) * hand.towards;
  const glm::dvec3 head_m = foot_m + length_m * hand.towards;
  const glm::vec4 colour = colourOf(costOf(hand.u));
  glm::dvec3 aside =
      glm::cross(hand.towards, glm::cross(plane.right, plane.up));  // across the arrow, as the person sees it
  if (!(glm::length(aside) > 1e-6)) aside = plane.right;
  aside = 0.04 * glm::normalize(aside);
  addLine(foot_m, head_m, width_m, colour);
  for (const double side : {-1.0, 1.0})
    addLine(head_m - 0.07 * hand.towards + side * aside, head_m, width_m, colour);
}

/// Adds an arc around the target that points the way in which the stroke would turn it: anticlockwise, seen
/// from above, where it strikes to the right.
void CueOverlay::addTurning(const HandView& hand, const FacingPlane& plane, const RoomGeometry& room) {
  constexpr int kSides = 16;
  constexpr double kArc_rad = 1.8, kHead_m = 0.02;
  const double sense = hand.offset_m > 0.0 ? 1.0 : -1.0, width_m = 0.003 * plane.distance_m;
  const glm::dvec3 left = glm::cross(room.up, hand.towards);
  const auto at = [&](double angle_rad, double radius_m) {
    return hand.target_m +
           radius_m * (std::cos(angle_rad) * hand.towards + sense * std::sin(angle_rad) * left);
  };
  const double ring_m = ringOf(hand);
  const glm::vec4 colour = colourOf(costOf(hand.u));
  const double first_rad = 0.5 * std::numbers::pi - 0.5 * kArc_rad, last_rad = first_rad + kArc_rad;
  for (int i = 0; i < kSides; ++i) {
    const double from_rad = first_rad + kArc_rad * i / kSides;
    addLine(at(from_rad, ring_m), at(from_rad + kArc_rad / kSides, ring_m), width_m, colour);
  }
  for (const double side_m : {-kHead_m, kHead_m})
    addLine(at(last_rad - kHead_m / ring_m, ring_m + side_m), at(last_rad, ring_m), width_m, colour);
}

/// Returns whether the scale stands to the left of the target: on the side away from the stroke, but of a
/// target far aside on the side of the middle, where walls reach farther.
static bool standsLeft(const HandView& hand, const FacingPlane& target, const glm::dvec3& eyes_m,
                       const RoomGeometry& room) {
  constexpr double kFarAside = 0.4;  // the sine of the angle
  const double aside =
      glm::dot(target.place_m - eyes_m, glm::cross(room.forward, room.up)) / target.distance_m;
  if (std::abs(aside) > kFarAside) return aside > 0.0;
  return glm::dot(hand.towards, target.right) > 1e-6;
}

/// Adds, from the bottom of the panel, the speed and the cost that the stroke would have, and the bar above
/// them; with a force device also the force in the hand, and how many newtons at the cue one in the hand is.
void CueOverlay::addScale(const HandView& hand, const ForceView& force, const FacingPlane& target,
                          const glm::dvec3& eyes_m, const RoomGeometry& room) {
  const double cost = costOf(hand.u), unit_m = target.distance_m;
  // The force's lines do not reach below the scale's usual end: a low puck is near a wall's rim.
  const double foot = scaleFoot(target, eyes_m, room) + (force.shown ? kForceReadout : 0.0);
  const auto up = [foot](double of) { return foot + heightOf(of); };
  const double aside = standsLeft(hand, target, eyes_m, room) ? kScaleLeft : kScaleRight;
  const auto on = [&](double across, double upwards) { return target.at(aside + across, upwards); };
  const double readout = force.shown ? kReadout + kForceReadout : kReadout;
  addLine(on(kPanelMiddle, foot - readout), on(kPanelMiddle, up(kMostCost) + 0.015), kPanel * unit_m,
          kScaleGround);
  addLine(on(0.0, up(0.0)), on(0.0, up(kMostCost)), kBar * unit_m, kTrack);
  addLine(on(0.0, up(0.0)), on(0.0, up(cost)), kBar * unit_m, colourOf(cost));
  for (std::size_t i = 0; i < kTicks.size(); ++i) {
    const double tick = up(1.0 / std::sqrt(1.0 - kTicks[i] * kTicks[i]) - 1.0);
    addLine(on(-kBar, tick), on(kBar + 0.008, tick), 0.0012 * unit_m, kInk);
    addText(target, aside + kBar + 0.014, tick - 0.5 * kTickDigits, kTickDigits, texts::cue::kMarks[i]);
  }
  std::array<char, 24> words{};
  const auto say = [&](double upwards, const texts::Text& format, double value, double height = kDigits) {
    addText(target, aside - kBar, foot + upwards, height, texts::formatTo(words, format, value));
  };
  say(-0.042, texts::cue::kSpeed, betaOf(hand.u));
  say(-0.080, texts::cue::kEnergy, cost);
  if (!force.shown) return;
  say(-0.118, texts::cue::kForce, glm::length(force.force_n));
  say(-0.145, texts::cue::kForceScale, 1.0 / force.scale, kTickDigits);
}

void CueOverlay::draw(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m,
                      const SeenFrame& seen, const RenderTarget& picture) {
  const HandView& hand = seen.self.hand;
  if (!hand.shown) return;
  const std::optional<glm::dmat4> clip = clipFromRoom(wall, eyeInRoom_m);
  if (!clip) return;
  const glm::dvec3& eyes_m = seen.self.observer.middle.positionInRoom_m;
  marks_.clear();
  words_.clear();
  const FacingPlane target = facing(hand.target_m, eyes_m, room);
  if (hand.pulling && hand.towards != glm::dvec3(0.0)) addCue(hand, room);
  if (hand.pulling && hand.u > 0.0) addArrow(hand, target, room);
  if (hand.pulling && hand.offset_m != 0.0) addTurning(hand, target, room);
  addRay(hand, eyes_m, room);
  if (hand.pulling)
    addScale(hand, seen.self.force, target, eyes_m, room);  // last, so that nothing covers the scale
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  blendOver();
  ribbons_.draw(marks_, *clip, picture.size_px());
  letters_.draw(words_, *clip);
}

}  // namespace carom
