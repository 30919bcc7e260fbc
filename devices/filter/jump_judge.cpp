#include "devices/filter/jump_judge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/base/limits.h"

namespace carom {
namespace {

constexpr double kLeastInterval_s = 0.001;  // samples stamped closer than that were not taken so
constexpr double kStartle_m_s2 = 15.0;      // a standing head hardly ever leaves its place faster
constexpr double kMost_m_s2 = 40.0;         // nor any head its course
constexpr double kVigour_m_s2 = 20.0;       // for longer than an interval or two
constexpr double kQuick_m_s = 0.8;          // after a jump: what moves faster off the course is none of it
constexpr int kMoves = 3;                   // samples that must move
constexpr double kLeastJump_m = 0.002;      // smaller jumps are left to the filter
constexpr double kCertain = 5.0;            // standard deviations of a length that chance does not exceed
constexpr double kSurprise_s = 0.3;         // over which it is judged how well the course is known
constexpr double kCourse_s = 0.1;           // for how long it is known at all
constexpr double kNewPlace_s = 0.3;  // after which doubted samples that go on from each other are the head
constexpr double kBeside_s = 0.045;  // samples that keep beside it for so long are a step of the tracker
constexpr int kBeside = 3;           // the least number of them

// Whether a head gets from one place to another in that time, beyond what noise can do.
bool isTravel(const glm::dvec3& from_m, const glm::dvec3& to_m, double interval_s, double sigma_m) {
  const double noise_m = 6.0 * std::sqrt(2.0) * sigma_m;
  return glm::distance(from_m, to_m) <=
         kGlitchCelerity_m_s * std::max(interval_s, kLeastInterval_s) + noise_m;
}

}  // namespace

Jump JumpJudge::judge(const CelerityFilter& head, double time_s, const glm::dvec3& position_m) {
  const double interval_s = time_s - head.time_s();
  const Sample sample{time_s, position_m, position_m - head.predictedPosition_m(interval_s)};
  return count_ == 0 ? judgeFirst(head, sample, interval_s) : judgeNext(head, sample, interval_s);
}

Jump JumpJudge::judgeFirst(const CelerityFilter& head, const Sample& sample, double interval_s) {
  // After a gap the head may be where its course has led it since. Otherwise it may be anywhere.
  if (interval_s > kNewPlace_s) {
    const double reach_m = tolerance_m(head, kNewPlace_s, std::min(interval_s, kTrackLost_s));
    return glm::length(sample.offCourse_m) <= reach_m ? Jump::none : Jump::elsewhere;
  }
  const bool isFast = !isTravel(used_m_, sample.position_m, interval_s, head.trackerSigma_m());
  const double off_m = glm::length(sample.offCourse_m);
  const bool isOff = head.isTrackerSigmaKnown() && !(off_m <= tolerance_m(head, interval_s, interval_s));
  if (!isFast && !isOff) return Jump::none;
  count_ = 1;
  last_ = sample;
  travels_s_ = beside_s_ = sample.time_s;
  beside_ = 1;
  offset_m_ = sample.offCourse_m;
  offCelerity_m_s_ = sample.offCourse_m / interval_s;
  moves_ = glm::length(offCelerity_m_s_) <= kMost_m_s2 * interval_s ? 1 : 0;
  return Jump::doubted;
}

Jump JumpJudge::judgeNext(const CelerityFilter& head, const Sample& sample, double interval_s) {
  const double off_m = glm::length(sample.offCourse_m);
  const bool isCourseKnown = interval_s <= kNewPlace_s;
  const double within_m = tolerance_m(head, sample.time_s - last_.time_s, 0.0);
  if (isCourseKnown && off_m <= within_m) return Jump::none;

  follow(sample, within_m, head.trackerSigma_m());
  if (isCourseKnown && beside_ > 1) {
    const bool isLong = beside_ >= kBeside && sample.time_s - beside_s_ >= kBeside_s;
    return isLong ? Jump::shifted : Jump::doubted;
  }
  if (isCourseKnown) {
    if (moves_ == count_) return count_ == 2 ? Jump::quick : Jump::none;
    if (moves_ >= kMoves && glm::length(offCelerity_m_s_) <= kQuick_m_s) return Jump::none;
    const double known_s = std::min(interval_s, kCourse_s);
    const double reach_m = 0.5 * (kVigour_m_s2 - kStartle_m_s2) * known_s * known_s;
    if (off_m <= reach_m + tolerance_m(head, known_s, interval_s)) return Jump::none;
  }
  return sample.time_s - travels_s_ >= kNewPlace_s ? Jump::elsewhere : Jump::doubted;
}

// Whether the doubted samples travel, keep beside the course, or move as a head might.
void JumpJudge::follow(const Sample& sample, double within_m, double sigma_m) {
  const double interval_s = sample.time_s - last_.time_s;
  if (!isTravel(last_.position_m, sample.position_m, interval_s, sigma_m)) travels_s_ = sample.time_s;

  if (glm::distance(sample.offCourse_m, last_.offCourse_m) <= within_m) {
    ++beside_;
  } else {
    beside_ = 1;
    beside_s_ = sample.time_s;
  }
  offset_m_ += (sample.offCourse_m - offset_m_) / static_cast<double>(beside_);

  const glm::dvec3 offCelerity_m_s = (sample.offCourse_m - last_.offCourse_m) / interval_s;
  const double noise_m_s = 2.0 * kCertain * sigma_m / interval_s;
  const bool isMove = glm::distance(offCelerity_m_s, offCelerity_m_s_) <= kMost_m_s2 * interval_s + noise_m_s;
  moves_ = isMove ? moves_ + 1 : 0;
  offCelerity_m_s_ = offCelerity_m_s;
  last_ = sample;
  ++count_;
}

// How far off the course a sample may lie, after a startled head had so long and the course is that old.
double JumpJudge::tolerance_m(const CelerityFilter& head, double startled_s, double course_s) const {
  const double startle_m = std::max(0.5 * kStartle_m_s2 * startled_s * startled_s, kLeastJump_m);
  return startle_m + kCertain * std::max(head.predictedSigma_m(course_s), std::sqrt(surprise_m2_));
}

void JumpJudge::use(const CelerityFilter& head, double time_s, const glm::dvec3& position_m) {
  const double interval_s = time_s - head.time_s();
  const glm::dvec3 offCourse_m = position_m - head.predictedPosition_m(interval_s);
  const double share = -std::expm1(-interval_s / kSurprise_s);
  surprise_m2_ += share * (glm::dot(offCourse_m, offCourse_m) / 3.0 - surprise_m2_);
  used_m_ = position_m;
  count_ = 0;
}

void JumpJudge::start(const glm::dvec3& position_m) {
  surprise_m2_ = 0.0;
  used_m_ = position_m;
  count_ = 0;
}

}  // namespace carom
