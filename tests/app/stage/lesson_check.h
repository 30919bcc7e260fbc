#pragma once
// What a lesson names, looked for in its picture: whether it is on the wall, uncovered, large enough, where
// the world says, and of its colour.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/stage/lesson_sight.h"
#include "app/stage/picture_reader.h"
#include "cave/frame/body_colour.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/hud/hud_text.h"
#include "cave/overlay/wall_buttons.h"
#include "cave/room/off_axis.h"

namespace carom::test {

class LessonCheck {
 public:
  /// The least size of a thing that is told by its shape or colour, as a fraction of the wall's height: a
  /// capital of the band, which the last row of a room can read, and half of it again, since a shape has no
  /// letters' contrast. Of 600 lines 22 pixels.
  static constexpr double kLeastThing = 1.5 / 40.0;
  /// The least height of a plate's capitals: smaller letters are illegible (cave/overlay/hud_panel.cpp).
  static constexpr double kLeastCapital_px = 9.0;

  LessonCheck(const LessonMoment& lesson, const Wall& front, const Image& image)
      : moment(lesson), eye(moment, front), picture(image), wall_(front), reader_(picture, eye) {
    text_.setWall(front, {});
    text_.setLesson(moment.scenario.lesson->words, moment.plan());
    text_.follow(moment.record);
    layOut(front, front.pixels, text_.lines(), band_);
    bandFrom_px_ = bandCorner_px(front, glm::dvec2(front.pixels) / sizeOf_m(front), band_.size_px.y);
    addTiles(front, moment.record, {moment.scenario.choices, true, false}, tiles_);
  }

  const LessonMoment& moment;
  const LessonEye eye;
  const Image& picture;

  /// Expects a place on the wall and covered by nothing of the panel.
  void onWall(const glm::dvec2& at_px, const std::string& what) const {
    EXPECT_TRUE(isFree(at_px)) << what << " is at " << at_px.x << ", " << at_px.y << " of "
                               << picture.size_px.x << " x " << picture.size_px.y
                               << ", where it is covered or beyond the wall";
  }
  bool isFree(const glm::dvec2& at_px) const {
    const glm::dvec2 inBand = at_px - glm::dvec2(bandFrom_px_);
    const bool isBand =
        inBand.x >= 0.0 && inBand.y >= 0.0 && inBand.x < band_.size_px.x && inBand.y < band_.size_px.y;
    const glm::dvec2 on_m = at_px / glm::dvec2(wall_.pixels) * sizeOf_m(wall_);
    for (const WallButton& tile : tiles_) {
      const glm::dvec2 in_m = on_m - tile.place.from_m;
      if (in_m.x >= 0.0 && in_m.y >= 0.0 && in_m.x < tile.place.size_m.x && in_m.y < tile.place.size_m.y)
        return false;
    }
    return isInside(picture, at_px) && !isBand;
  }

  /// Expects these places, the border of a thing, on the wall, and it as large as it must be to be told.
  void isLarge(std::span<const glm::dvec2> border_px, const std::string& what) const {
    glm::dvec2 low(1e9), high(-1e9);
    for (const glm::dvec2& at_px : border_px) {
      low = glm::min(low, at_px);
      high = glm::max(high, at_px);
      onWall(at_px, what);
    }
    EXPECT_GE(std::max(high.x - low.x, high.y - low.y), kLeastThing * picture.size_px.y)
        << what << " is small: " << high.x - low.x << " x " << high.y - low.y << " pixels";
  }

  /// Expects that most of these places show a hue, and that few of those around do.
  void isThere(std::span<const glm::dvec2> within_px, std::span<const glm::dvec2> around_px,
               const glm::vec3& thing, const std::string& what, double most = 0.5) const {
    const auto share = [&](std::span<const glm::dvec2> places_px) {
      double like = 0.0;
      for (const glm::dvec2& at_px : places_px)
        like += hasHue(colourAt(picture, at_px), thing) ? 1.0 / static_cast<double>(places_px.size()) : 0.0;
      return like;
    };
    EXPECT_GE(share(within_px), most)
        << what << " has not its colour where it should be: " << shownAt(within_px);
    if (!around_px.empty()) {
      EXPECT_LE(share(around_px), 0.75 * most)
          << what << ": its colour is around, too: " << shownAt(around_px);
    }
  }
  /// Expects that on the way from the colour around to that of a ghost, which is like glass, most of these
  /// places have gone a tenth.
  void isTinted(std::span<const glm::dvec2> within_px, std::span<const glm::dvec2> around_px,
                const glm::vec3& ghost, const std::string& what) const {
    glm::dvec3 ground(0.0);
    for (const glm::dvec2& at_px : around_px)
      ground += colourAt(picture, at_px) / static_cast<double>(around_px.size());
    const glm::dvec3 way = glm::dvec3(ghost) - ground;
    std::size_t tinted = 0;
    for (const glm::dvec2& at_px : within_px)
      tinted += glm::dot(colourAt(picture, at_px) - ground, way) > 0.1 * glm::dot(way, way) ? 1 : 0;
    EXPECT_GE(2 * tinted, within_px.size()) << what << " is not there: " << shownAt(within_px);
  }
  std::string shownAt(std::span<const glm::dvec2> places_px) const {
    std::string all;
    for (const glm::dvec2& at_px : places_px) {
      const glm::dvec3 rgb = 255.0 * colourAt(picture, at_px);
      all += fmt::format(" ({:.0f},{:.0f}: {:.0f} {:.0f} {:.0f})", at_px.x, at_px.y, rgb.r, rgb.g, rgb.b);
    }
    return all;
  }

  /// The seen rim of a round puck, `share` of its radius from its centre, on its upper face.
  std::vector<glm::dvec2> rim_px(const std::string& name, double share, int points = 24) const {
    const std::size_t body = moment.bodyNamed(name);
    const Puck& puck = moment.scenario.billiard.pucks.at(body - 1);
    std::vector<glm::dvec2> places;
    for (int i = 0; i < points; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / points;
      places.push_back(
          eye.seen(moment.line(name), {share * puck.radius_m * std::cos(angle),
                                       share * puck.radius_m * std::sin(angle), 0.5 * puck.height_m}));
    }
    return places;
  }
  /// Expects a round puck where it is seen.
  void puck(const std::string& name) const { puck(name, codeOf(colourOf(name, moment.bodyNamed(name) - 1))); }
  /// The same, in this colour.
  void puck(const std::string& name, const glm::vec3& shown) const {
    isLarge(rim_px(name, 1.0), name);
    isThere(rim_px(name, 0.7), rim_px(name, 1.6), shown, name);
  }
  /// Whether the upper face of a round puck is seen at this place.
  bool isOnPuck(const glm::dvec2& at_px) const {
    return std::ranges::any_of(moment.scenario.billiard.pucks, [&](const Puck& puck) {
      const std::vector<glm::dvec2> rim = rim_px(puck.name, 1.0);
      std::size_t left = 0;
      for (std::size_t i = 0; i < rim.size(); ++i) {
        const glm::dvec2 side = rim[(i + 1) % rim.size()] - rim[i], to = at_px - rim[i];
        left += side.x * to.y > side.y * to.x ? 1 : 0;
      }
      return left == 0 || left == rim.size();
    });
  }

  /// Expects a plate with these words.
  PlateRead plate(const PlateWanted& wanted) const {
    const PlateRead read = reader_.read(wanted);
    EXPECT_EQ(read.words, wanted.words)
        << "match " << read.match << ", at " << read.low_px.x << ", " << read.low_px.y;
    EXPECT_GE(read.capital_px, kLeastCapital_px) << wanted.words << ": its letters are small";
    onWall(read.low_px, "plate " + wanted.words);
    onWall(read.high_px, "plate " + wanted.words);
    return read;
  }
  /// Expects the plate above a body with a quantity of it.
  void gauge(const std::string& body, const std::string& words) const {
    constexpr double kStem_m = 0.07;
    const Vec3 at_m = eye.emitting(moment.line(body)).event.r_m;
    plate({at_m + Vec3(0.0, 0.0, kStem_m), words});
  }
  /// Expects the plate of a label.
  void label(const std::string& words) const {
    for (const LessonLabel& label : moment.plan().labels)
      if (label.words == words) plate({label.at_m + Vec3(0.0, 0.0, 0.07), words});
  }

  /// Expects the arrows of this phase on the wall: each ends above a puck or at its place, and comes from
  /// above on the right, in its colour.
  void arrows() const {
    for (const LessonArrow& arrow : moment.plan().arrows) {
      const bool isShown = arrow.explains == (moment.record.lesson.phase == LessonPhase::explains);
      if (!isShown || moment.record.lesson.phase == LessonPhase::asks) continue;
      const auto& pucks = moment.scenario.billiard.pucks;
      if (arrow.body && *arrow.body > pucks.size()) continue;  // a scripted body, whose height a mesh has
      Vec3 tip_m = arrow.at_m;
      if (arrow.body) {
        const Puck& puck = pucks[*arrow.body - 1];
        tip_m = eye.emitting(moment.line(puck.name)).event.r_m + Vec3(0.0, 0.0, 0.5 * puck.height_m);
      }
      tip_m.z += 0.015;
      const Vec3 way = tip_m - eye.at().r_m;
      const Vec3 right = glm::normalize(Vec3(way.y, -way.x, 0.0));
      const Vec3 back = glm::normalize(0.6 * right + Vec3(0.0, 0.0, 1.0));
      onWall(eye.seen(tip_m), "arrow");
      std::vector<glm::dvec2> within, beside;
      for (const double along_m : {0.02, 0.03, 0.04, 0.05, 0.06}) {
        within.push_back(eye.seen(tip_m + along_m * back));
        beside.push_back(eye.seen(tip_m + along_m * back - 0.2 * right));
      }
      isThere(within, beside, kFlashColour, "arrow", 0.75);
    }
  }

  /// Expects a line on the cloth, where no body covers it: on most of it, in its colour.
  void clothLine(const ClothLine& line) const {
    std::vector<glm::dvec2> on, onCloth, beside;
    const Vec3 way = glm::normalize(line.to_m - line.from_m);
    for (int i = 1; i < 40; ++i) {
      const Vec3 at_m = glm::mix(line.from_m, line.to_m, i / 40.0) + Vec3(0.0, 0.0, 0.003);
      if (!isFree(eye.seen(at_m))) continue;
      on.push_back(eye.seen(at_m));
      if (isOnPuck(on.back())) continue;
      onCloth.push_back(on.back());
      beside.push_back(eye.seen(at_m + 0.05 * Vec3(-way.y, way.x, 0.0)));
    }
    EXPECT_GE(on.size(), 20U) << "half of the line is on the wall";
    isLarge(on, "line");
    ASSERT_FALSE(onCloth.empty());
    isThere(onCloth, beside, kFlashColour, "line");
  }

  /// Expects the ghost of a round puck where it is now, on the board or for the observer.
  void ghost(const std::string& name, bool isMine) const {
    const Puck& puck = moment.scenario.billiard.pucks.at(moment.bodyNamed(name) - 1);
    std::vector<glm::dvec2> border, within, around;
    for (int i = 0; i < 24; ++i) {
      const double angle = std::numbers::pi * i / 12.0;
      const auto at = [&](double share) {
        const Vec3 offset_m(share * puck.radius_m * std::cos(angle), share * puck.radius_m * std::sin(angle),
                            0.5 * puck.height_m);
        return isMine ? eye.forMeNow(moment.line(name), offset_m)
                      : eye.onBoardNow(moment.line(name), offset_m);
      };
      border.push_back(at(1.0));
      within.push_back(at(0.6));
      around.push_back(at(1.7));
    }
    isLarge(border, "ghost of " + name);
    isTinted(within, around, isMine ? kMyNowColour : kBoardNowColour, "ghost of " + name);
  }
  /// Expects the ghost of a bar, as far as its half lengths along x and y reach, where it is for the
  /// observer.
  void ghostBar(const std::string& name, double along_m, double across_m) const {
    std::vector<glm::dvec2> within, beyond;
    for (int i = -10; i <= 10; ++i)
      within.push_back(eye.forMeNow(moment.line(name), {0.95 * along_m * i / 10.0, 0.0, 0.015}));
    for (const double way : {-1.0, 1.0})
      for (const double share : {1.05, 1.1, 1.15})
        beyond.push_back(eye.forMeNow(moment.line(name), {way * share * along_m, 0.0, 0.015}));
    (void)across_m;
    isLarge(within, "ghost of " + name);
    isTinted(within, beyond, kMyNowColour, "ghost of " + name);
  }

  /// Expects the panel to say a stopwatch's reading, in whole letters.
  void stopwatch(const std::string& name, double value_s) const {
    const std::string words = fmt::format("{}: {:.2f} s", name, value_s);
    std::string all;
    for (const HudLine& line : text_.lines()) all += line.text + " ";
    EXPECT_NE(all.find(words), std::string::npos) << words << " is not in: " << all;
    isWritten(fmt::format("{:.2f} s", value_s));
  }
  /// Expects the line of the panel that has these words to be written in the picture: where its letters are
  /// whole, most of it is bright. A line that is a little too wide has smaller letters, so not all of it is.
  void isWritten(const std::string& words) const {
    const auto& lines = text_.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].text.find(words) == std::string::npos) continue;
      const GlyphBitmap letters = ink(lines[i].text, band_.height_px);
      const glm::ivec2 from = bandFrom_px_ + band_.lines[i].from_px +
                              glm::ivec2(static_cast<int>(kBandMargin * band_.height_px) +
                                             (lines[i].setIn ? 8 * band_.height_px / 5 : 0),
                                         (band_.lines[i].size_px.y - band_.height_px) / 2 + letters.below_px);
      double inked = 0.0, bright = 0.0;
      for (int y = 0; y < letters.size_px.y; ++y) {
        for (int x = 0; x < letters.size_px.x; ++x) {
          if (letters.alpha[static_cast<std::size_t>(y * letters.size_px.x + x)] < 230) continue;
          ++inked;
          const glm::dvec3 shown = colourAt(picture, glm::dvec2(from + glm::ivec2(x, y)) + 0.5);
          if (std::max({shown.r, shown.g, shown.b}) > 0.7) ++bright;
        }
      }
      EXPECT_GT(bright, 0.75 * inked) << "not written: " << lines[i].text;
      return;
    }
    ADD_FAILURE() << "the panel does not say " << words;
  }

  /// Where the ring of a flash's light crosses the cloth now, at these angles, and as far as it is on the
  /// wall. `more_m` farther out.
  std::vector<glm::dvec2> ring_px(const std::string& flash, double more_m = 0.0) const {
    const Event at = moment.flash(flash);
    const double reach_m = moment.c_m_s() * (eye.at().t_s - at.t_s);
    std::vector<glm::dvec2> places;
    if (!(reach_m > at.r_m.z)) return places;
    const double onCloth_m = std::sqrt(reach_m * reach_m - at.r_m.z * at.r_m.z);
    for (int i = 0; i < 360; ++i) {
      const double angle = std::numbers::pi * i / 180.0;
      const Vec3 way(std::cos(angle), std::sin(angle), 0.0);
      const auto at_m = [&](double radius_m) { return Vec3(at.r_m.x, at.r_m.y, 0.003) + radius_m * way; };
      if (isFree(eye.seen(at_m(onCloth_m)))) places.push_back(eye.seen(at_m(onCloth_m + more_m)));
    }
    return places;
  }
  /// Expects the ring of a flash in its colour, in at least so many degrees of its circle.
  void ring(const std::string& flash, const glm::vec3& colour, int degrees = 20) const {
    const auto light = [&](const glm::dvec2& at_px) {
      const glm::dvec3 rgb = colourAt(picture, at_px);
      return -glm::distance(rgb, glm::dvec3(colour));
    };
    const std::vector<glm::dvec2> on = ring_px(flash), out = ring_px(flash, 0.06), in = ring_px(flash, -0.06);
    int seen = 0;
    for (std::size_t i = 0; i < on.size(); ++i)
      seen += light(on[i]) > std::max(light(out[i]), light(in[i])) + 0.05;
    EXPECT_GE(seen, degrees) << "ring of " << flash << ", of " << on.size() << " places on the wall";
  }

 private:
  const Wall& wall_;
  PlateReader reader_;
  HudText text_;
  BandLayout band_;
  glm::ivec2 bandFrom_px_{0};
  std::vector<WallButton> tiles_;
};

}  // namespace carom::test
