#pragma once
// Reads a picture of a wall: the hues of things, and the words on plates, letter by letter.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/stage/lesson_sight.h"
#include "cave/gl/letter_atlas.h"
#include "cave/gl/view_colours.h"
#include "cave/marks/mark_buffer.h"
#include "cave/pictures/image.h"

namespace carom::test {

/// sRGB of a place of the picture, between its pixels.
inline glm::dvec3 colourAt(const Image& image, const glm::dvec2& at_px) {
  const glm::dvec2 low = glm::floor(at_px - 0.5), share = at_px - 0.5 - low;
  glm::dvec3 sum(0.0);
  for (int k = 0; k < 4; ++k) {
    const glm::ivec2 at =
        glm::clamp(glm::ivec2(low) + glm::ivec2(k % 2, k / 2), glm::ivec2(0), image.size_px - 1);
    const std::uint8_t* rgb =
        &image.rgb[3 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(image.size_px.x) +
                        static_cast<std::size_t>(at.x))];
    const double weight = (k % 2 ? share.x : 1.0 - share.x) * (k / 2 ? share.y : 1.0 - share.y);
    sum += weight * glm::dvec3(rgb[0], rgb[1], rgb[2]) / 255.0;
  }
  return sum;
}

inline bool isInside(const Image& image, const glm::dvec2& at_px) {
  return at_px.x >= 1.0 && at_px.y >= 1.0 && at_px.x < image.size_px.x - 1.0 &&
         at_px.y < image.size_px.y - 1.0;
}

/// Angle on the circle of colours, degrees, and how far from grey, 0 to 1.
struct Hue {
  explicit Hue(const glm::dvec3& rgb) {
    const double most = std::max({rgb.r, rgb.g, rgb.b}), least = std::min({rgb.r, rgb.g, rgb.b});
    angle_deg = std::atan2(std::numbers::sqrt3 * (rgb.g - rgb.b), 2.0 * rgb.r - rgb.g - rgb.b) * 180.0 /
                std::numbers::pi;
    strength = most > 0.0 ? (most - least) / most : 0.0;
    light = most;
  }
  double angle_deg, strength, light;
};

inline double apart_deg(double a, double b) { return std::abs(std::remainder(a - b, 360.0)); }

/// Whether a colour of the picture is that of a thing in some light: bright and grey for a grey thing, and
/// otherwise of its hue, which a white light leaves.
inline bool hasHue(const glm::dvec3& shown, const glm::dvec3& thing) {
  constexpr double kHue_deg = 25.0, kGrey = 0.25;
  const Hue seen(shown), own(thing);
  if (own.strength < kGrey) return seen.strength < kGrey && seen.light > 0.4;
  return seen.strength > kGrey && apart_deg(seen.angle_deg, own.angle_deg) < kHue_deg;
}

/// A plate that stands at a place of the board, as it is described in the room of the lessons' marks: letters
/// 33 × 55 mm, enlarged beyond 1.6 m from the eye, at most three times.
struct PlateWanted {
  Vec3 foot_m{0.0};
  std::string words;
  PlateShape shape = PlateShape::box;
  double scale = 1.25;
  std::optional<Vec3> likeAt_m{};  ///< as large, and facing as, a plate at this place
  std::optional<double>
      at_s{};  ///< it stands at an event of this board time, where the observer's "now" is drawn
};
struct PlateRead {
  double match = -1.0;  ///< correlation of its pixels with the letters, from −1 to 1
  std::string words;    ///< letter by letter the one that matches best
  double capital_px = 0.0;
  glm::dvec2 low_px{0.0}, high_px{0.0};
  double raised_m = 0.0;
};

class PlateReader {
 public:
  PlateReader(const Image& image, const LessonEye& eye) : image_(image), eye_(eye) {}

  /// Finds the plate above its place, where other plates may have pushed it, and reads it.
  PlateRead read(const PlateWanted& wanted) const {
    const std::vector<std::string> letters = lettersOf(wanted.words);
    std::vector<double> inked, shown(letters.size() * kWide * kHigh);
    for (const std::string& letter : letters) {
      const Cell ink = inkOf(letter);
      inked.insert(inked.end(), ink.begin(), ink.end());
    }
    PlateRead best;
    Cells found;
    for (double raised_m = -0.06; raised_m < 0.9; raised_m += 0.003) {
      const Cells cells = cellsOf(wanted, letters.size(), raised_m);
      if (!cells.isInside) continue;
      for (std::size_t i = 0; i < letters.size(); ++i)
        std::copy(cells.light[i].begin(), cells.light[i].end(),
                  shown.begin() + static_cast<std::ptrdiff_t>(i * kWide * kHigh));
      const double match = (wanted.shape == PlateShape::flag ? -1.0 : 1.0) * correlation(shown, inked);
      if (match <= best.match) continue;
      best = {match, "", cells.capital_px, cells.low_px, cells.high_px, raised_m};
      found = cells;
    }
    for (const Cell& cell : found.light) best.words += bestLetter(cell, letters, wanted.shape);
    return best;
  }

 private:
  static constexpr int kWide = 12, kHigh = 20;  // samples of a letter
  using Cell = std::array<double, kWide * kHigh>;
  struct Cells {
    std::vector<Cell> light;
    bool isInside = true;
    double capital_px = 0.0;
    glm::dvec2 low_px{1e6}, high_px{-1e6};
  };

  /// What is simultaneous with the plate's event for the observer: t + β·Δr/c.
  double timeOf(const PlateWanted& wanted, const Vec3& place_m) const {
    return *wanted.at_s + glm::dot(eye_.beta(), place_m - wanted.foot_m) / eye_.c_m_s();
  }

  static std::vector<std::string> lettersOf(std::string_view words) {
    std::vector<std::string> letters;
    while (!words.empty()) {
      std::string_view rest = words;
      takeLetter(rest);
      letters.emplace_back(words.substr(0, words.size() - rest.size()));
      words = rest;
    }
    return letters;
  }

  /// The part of the atlas with a letter, averaged over each sample.
  static Cell inkOf(std::string_view letter) {
    const LetterAtlas& atlas = letterAtlas();
    const int code = takeLetter(letter);
    const glm::ivec2 corner = glm::ivec2(code % kLetterColumns, code / kLetterColumns) * kLetterCell_px;
    Cell cell{};
    for (int y = 0; y < kHigh; ++y) {
      for (int x = 0; x < kWide; ++x) {
        const glm::ivec2 from = kLetterCell_px * glm::ivec2(x, y) / glm::ivec2(kWide, kHigh),
                         to = kLetterCell_px * glm::ivec2(x + 1, y + 1) / glm::ivec2(kWide, kHigh);
        double sum = 0.0;
        for (int j = from.y; j < to.y; ++j)
          for (int i = from.x; i < to.x; ++i)
            sum += atlas.ink[static_cast<std::size_t>((corner.y + j) * atlas.size_px.x + corner.x + i)];
        cell[static_cast<std::size_t>(y * kWide + x)] = sum / ((to.x - from.x) * (to.y - from.y));
      }
    }
    return cell;
  }

  Cells cellsOf(const PlateWanted& wanted, std::size_t letters, double raised_m) const {
    constexpr std::array kMargins{0.12, 0.30, 0.20};
    const Vec3 way_m = wanted.likeAt_m.value_or(wanted.foot_m) - eye_.at().r_m;
    const double scale = wanted.scale * glm::clamp(glm::length(way_m) / 1.6, 1.0, 3.0);
    const Vec3 right = Vec3(way_m.y, -way_m.x, 0.0) / std::hypot(way_m.x, way_m.y);
    const double place_m = 0.033 * scale, high_m = 0.055 * scale;
    const double margin = kMargins[static_cast<std::size_t>(wanted.shape)];
    const auto at = [&](double places, double up) {
      const Vec3 place = wanted.foot_m + (places - 0.5 * static_cast<double>(letters)) * place_m * right +
                         Vec3(0.0, 0.0, raised_m + up * high_m);
      return wanted.at_s ? eye_.pixelIn(eye_.inMyFrame({timeOf(wanted, place), place})) : eye_.seen(place);
    };
    Cells cells;
    for (const double places : {-margin, static_cast<double>(letters) + margin}) {
      for (const double up : {0.0, 1.0}) {
        cells.isInside = cells.isInside && isInside(image_, at(places, up));
        cells.low_px = glm::min(cells.low_px, at(places, up));
        cells.high_px = glm::max(cells.high_px, at(places, up));
      }
    }
    if (!cells.isInside) return cells;
    constexpr double kCapital = 0.6;  // of the plate's height
    const double middle = 0.5 * static_cast<double>(letters);
    cells.capital_px = kCapital * glm::distance(at(middle, 0.0), at(middle, 1.0));
    cells.light.resize(letters);
    for (std::size_t i = 0; i < letters; ++i)
      for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x)
          cells.light[i][static_cast<std::size_t>(y * kWide + x)] =
              glm::dot(colourAt(image_, at(static_cast<double>(i) + (x + 0.5) / kWide, (y + 0.5) / kHigh)),
                       glm::dvec3(0.3, 0.6, 0.1));
    return cells;
  }

  template <typename Range>
  static double correlation(const Range& a, const Range& b) {
    double meanA = 0.0, meanB = 0.0, ab = 0.0, aa = 0.0, bb = 0.0;
    const auto count = static_cast<double>(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      meanA += a[i] / count;
      meanB += b[i] / count;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      ab += (a[i] - meanA) * (b[i] - meanB);
      aa += (a[i] - meanA) * (a[i] - meanA);
      bb += (b[i] - meanB) * (b[i] - meanB);
    }
    return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
  }

  /// The letter, of digits and those wanted, that a cell matches best. A blank is where there is no ink.
  static std::string bestLetter(const Cell& light, const std::vector<std::string>& wanted, PlateShape shape) {
    std::vector<std::string> all(wanted);
    for (char digit = '0'; digit <= '9'; ++digit) all.emplace_back(1, digit);
    // Within the plate's border.
    const auto [least, most] = std::minmax_element(light.begin() + 4 * kWide, light.end() - 4 * kWide);
    constexpr double kInk = 0.12;  // less contrast than this is no letter
    if (*most - *least < kInk) return " ";
    std::string best;
    double match = -1.0;
    for (const std::string& letter : all) {
      if (letter == " ") continue;
      const double like = (shape == PlateShape::flag ? -1.0 : 1.0) * correlation(light, inkOf(letter));
      if (like <= match) continue;
      match = like;
      best = letter;
    }
    return best;
  }

  const Image& image_;
  const LessonEye& eye_;
};

}  // namespace carom::test
