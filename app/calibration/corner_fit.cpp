#include "app/calibration/corner_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "app/calibration/corner_order.h"

namespace carom {
namespace {

constexpr std::size_t kFewestTouches = 4;  // three corners fit almost any touches
constexpr double kFlat_m = 0.05;           // points that deviate less from a plane tell no mirror image
constexpr double kThin_m = 0.05;           // points that deviate less from a line leave a turn open
constexpr double kTwice = 0.1;             // of the distance that two corners should have
constexpr double kBehind_m = 0.03;         // a sensor so far behind a wall cannot touch it from the room

double mm(double length_m) { return 1e3 * length_m; }

std::vector<PointPair> pairsOf(std::span<const Touch> touches) {
  std::vector<PointPair> pairs;
  for (const Touch& touch : touches) pairs.push_back({touch.corner.at_m, touch.tip_m});
  return pairs;
}

double largestMiss_m(const RigidFit& fit) {
  double largest_m = 0.0;
  for (const glm::dvec3& miss_m : fit.misses_m) largest_m = std::max(largest_m, glm::length(miss_m));
  return largest_m;
}

/// Returns how a tracker's unit is mistaken if its lengths are to be multiplied by `scale`.
std::string unitFor(double scale) {
  struct Mistake {
    double scale;
    std::string_view words;
  };
  constexpr std::array<Mistake, 6> kMistakes{
      {{1e-3, "it sends millimetres as metres"},
       {1e3, "it sends metres as millimetres"},
       {1e-2, "it sends centimetres as metres"},
       {0.0254, "it sends inches as metres"},
       {0.3048, "it sends feet as metres"},
       {1.0 / 2.54, "it sends inches as centimetres, or the reverse"}}};
  for (const Mistake& mistake : kMistakes) {
    if (std::abs(scale / mistake.scale - 1.0) < 0.02) return fmt::format(": {}", mistake.words);
  }
  return ": calibrate the tracker itself anew, with its own wand, or measure the walls again";
}

/// Returns a sentence for each two touches at one place whose corners are apart.
std::vector<std::string> touchedTwice(std::span<const Touch> touches, double scale) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double expected_m = glm::distance(touches[i].corner.at_m, touches[j].corner.at_m);
      const double found_m = scale * glm::distance(touches[i].tip_m, touches[j].tip_m);
      if (expected_m == 0.0 || !(found_m < kTwice * expected_m)) continue;
      sentences.push_back(
          fmt::format("{} and {} were touched at places {:.0f} mm apart, expected {:.0f} mm: one corner was "
                      "touched twice",
                      touches[j].corner.name, touches[i].corner.name, mm(found_m), mm(expected_m)));
    }
  }
  return sentences;
}

/// What would make the touches fit, with the misses that remain.
struct Explanation {
  double largest_m = std::numeric_limits<double>::infinity();
  std::string words;
};

Explanation otherScale(const std::vector<PointPair>& pairs, double scale) {
  std::vector<PointPair> scaled = pairs;
  for (PointPair& pair : scaled) pair.inB_m *= scale;
  return {
      largestMiss_m(fitRigid(scaled)),
      fmt::format("the tracker's lengths are {:.5g} times those of the room{}", 1.0 / scale, unitFor(scale))};
}

Explanation mirrored(const std::vector<PointPair>& pairs) {
  return {
      largestMiss_m(fitMirrored(pairs)),
      "what the tracker sees is mirrored: its axes are left-handed, or left and right, or up and down, were "
      "exchanged while touching"};
}

/// Explains by an order in which at most `most` corners are elsewhere.
Explanation otherOrder(std::span<const Touch> touches, std::size_t most) {
  const CornerOrder order = likeliestOrder(pairsOf(touches));
  std::vector<std::string> exchanged;
  for (std::size_t i = 0; i < order.corner.size(); ++i) {
    if (order.corner[i] == i) continue;
    exchanged.push_back(fmt::format("{} where {} was asked for", touches[order.corner[i]].corner.name,
                                    touches[i].corner.name));
  }
  if (exchanged.empty() || exchanged.size() > most) return {};
  return {order.largest_m,
          fmt::format("the corners were touched in another order: {}", fmt::join(exchanged, ", "))};
}

/// Returns the corner without which the others fit best.
Explanation oneBad(std::span<const Touch> touches, const std::vector<PointPair>& pairs) {
  Explanation best;
  if (pairs.size() <= kFewestTouches) return best;  // without one, too few are left
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::vector<PointPair> others = pairs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const RigidFit fit = fitRigid(others);
    const double largest_m = largestMiss_m(fit);
    if (largest_m >= best.largest_m) continue;
    best = {
        largest_m,
        fmt::format("{} alone is {:.0f} mm off: touch it again, or measure this corner again for the rig",
                    touches[i].corner.name, mm(glm::distance(fit.aFromB * pairs[i].inB_m, pairs[i].inA_m)))};
  }
  return best;
}

/// Returns why touches do not fit: every explanation that makes them fit, the simplest first.
std::string reasonFor(std::span<const Touch> touches, const CornerFit& judged) {
  const std::vector<PointPair> pairs = pairsOf(touches);
  std::vector<Explanation> known{otherScale(pairs, judged.scale), oneBad(touches, pairs)};
  const Explanation mirror = judged.flat ? Explanation{} : mirrored(pairs);
  known.push_back(mirror);
  // The mirror image of a symmetric room is the room with most of its corners exchanged.
  known.push_back(otherOrder(touches, mirror.largest_m <= kMostMiss_m ? 2 : touches.size()));
  // An explanation explains if little is left; of several, those that leave about as little as the best.
  const double worst_m = largestMiss_m(judged.fit);
  double best_m = std::min(kMostMiss_m, worst_m / 2.0);
  for (const Explanation& one : known) best_m = std::min(best_m, std::max(2.0 * one.largest_m, kGoodMiss_m));
  std::vector<std::string> words;
  for (const Explanation& one : known) {
    if (one.largest_m <= best_m && one.largest_m <= worst_m / 2.0) words.push_back(one.words);
  }
  if (words.empty()) {
    return "no single corner, order, scale or mirror image explains it: the tracker is noisy or bent by "
           "metal, "
           "the tip is wrong, or the walls are measured wrongly";
  }
  return fmt::format("{}", fmt::join(words, "; or "));
}

/// Notes single corners that fit badly although the whole fits.
void noteMisses(std::span<const Touch> touches, CornerFit& judged) {
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const double miss_m = glm::length(judged.fit.misses_m[i]);
    if (miss_m <= kGoodMiss_m) continue;
    judged.remarks.push_back(fmt::format("{} misses its place by {:.1f} mm, expected at most {:.0f} mm",
                                         touches[i].corner.name, mm(miss_m), mm(kGoodMiss_m)));
  }
}

/// A sensor has a body, which stays in front of what its tip touches.
void noteSides(std::span<const Touch> touches, CornerFit& judged) {
  std::size_t behind = 0, before = 0;
  for (const Touch& touch : touches) {
    const double side_m =
        glm::dot(judged.fit.aFromB * touch.sensor_m - touch.corner.at_m, touch.corner.normal);
    behind += side_m < -kBehind_m ? 1 : 0;
    before += side_m > kBehind_m ? 1 : 0;
  }
  if (behind <= before) return;
  judged.faults.push_back(
      "the sensor would have been behind the walls that it touched: left and right, or up and down, were "
      "exchanged while touching");
}

/// A scale that differs by more than its own error, though too little to be refused.
void noteScale(std::span<const PointPair> pairs, CornerFit& judged) {
  double spread_m2 = 0.0;
  glm::dvec3 middle_m(0.0);
  for (const PointPair& pair : pairs) middle_m += pair.inA_m / static_cast<double>(pairs.size());
  for (const PointPair& pair : pairs) spread_m2 += glm::dot(pair.inA_m - middle_m, pair.inA_m - middle_m);
  const auto count = static_cast<double>(pairs.size());
  const double error = judged.fit.rms_m * std::sqrt(count / (3.0 * count - 6.0) / spread_m2);
  const double excess = std::abs(judged.scale - 1.0);
  if (excess < 0.002 || excess < 3.0 * error) return;
  judged.remarks.push_back(
      fmt::format("the tracker's lengths are {:.2f} % too {}: calibrate the tracker itself anew, or measure "
                  "the walls again",
                  100.0 * excess, judged.scale < 1.0 ? "long" : "short"));
}

}  // namespace

CornerFit fitCorners(std::span<const Touch> touches) {
  CornerFit judged;
  if (touches.size() < kFewestTouches) {
    judged.faults.push_back(
        fmt::format("{} touched corners are too few, expected at least {}, not all on one wall",
                    touches.size(), kFewestTouches));
    return judged;
  }
  const std::vector<PointPair> pairs = pairsOf(touches);
  std::vector<glm::dvec3> corners_m;
  for (const PointPair& pair : pairs) corners_m.push_back(pair.inA_m);
  const glm::dvec3 extent_m = extentOf(corners_m);
  judged.flat = extent_m.z < kFlat_m;
  judged.scale = scaleBetween(pairs);
  judged.fit = fitRigid(pairs);
  judged.error = errorOf(judged.fit, pairs);
  judged.mirroredRms_m = fitMirrored(pairs).rms_m;
  if (extent_m.y < kThin_m) {
    judged.faults.push_back("the corners lie on one line, expected corners of a whole wall at least");
    return judged;
  }
  judged.faults = touchedTwice(touches, judged.scale);
  if (!judged.faults.empty()) return judged;
  const double worst_m = largestMiss_m(judged.fit);
  if (!(worst_m <= kMostMiss_m)) {
    judged.faults.push_back(
        fmt::format("the corners miss their places by up to {:.1f} mm, expected at most "
                    "{:.0f} mm; {}",
                    mm(worst_m), mm(kMostMiss_m), reasonFor(touches, judged)));
    return judged;
  }
  noteMisses(touches, judged);
  noteScale(pairs, judged);
  noteSides(touches, judged);
  if (judged.flat) {
    judged.remarks.push_back(
        "all corners lie in one plane, which cannot tell a mirrored tracker: touch a corner of another wall, "
        "too, if there is one");
  }
  return judged;
}

}  // namespace carom
