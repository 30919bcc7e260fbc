#pragma once
// Decides whether a tracker's sample is motion of the head or a jump of the tracker.

#include <glm/vec3.hpp>

#include "devices/filter/celerity_filter.h"

namespace carom {

/// The kinds of samples.
enum class Jump {
  none,       ///< the head, which continues from the last used sample
  doubted,    ///< where a head cannot get: not to be used, or not yet
  quick,      ///< the head; the doubted sample before was the head, too: both are to be used
  shifted,    ///< the head, which the tracker shows beside its place before: see offset_m()
  elsewhere,  ///< the head, out of reach or after many doubts: nothing is known of its motion
};

/// Judges samples by the head's course, as its filter foresees it. A head that stands reaches 15 m/s² within
/// an interval at most, and quickly moving ones surprise their filter evenly; what lies further off the
/// course than either, than 2 mm, and than noise explains, is doubted. The samples that follow show what it
/// was:
///
///  * on the course again: an outlier of the tracker;
///  * off the course by ever more, by accelerations below 40 m/s²: motion;
///  * beside the course by always the same, for 45 ms: a step of the tracker. The head goes on as it did;
///  * anything else, from place to place at below 12 m/s, for long: the head's new place.
///
/// After a gap of over 0.3 s a sample is believed at once. It is the head on its course where a head that
/// left it with 15 m/s² for 0.3 s might be, and otherwise the head elsewhere: a tracker that was set up anew
/// meanwhile.
///
/// So one sample that is 5 mm off at 60 Hz leaves no trace, nor a step of half a metre, spread over several
/// samples or not. No allocation, the same bits in every run.
class JumpJudge {
 public:
  /// Returns the kind of the next sample. Its time is after that of the last one that was judged or used.
  Jump judge(const CelerityFilter& head, double time_s, const glm::dvec3& position_m);

  /// Must be called with each sample before the filter takes it.
  void use(const CelerityFilter& head, double time_s, const glm::dvec3& position_m);
  /// Must be called with a sample with which the filter starts.
  void start(const glm::dvec3& position_m);

  /// Whether the newest sample was doubted, and its time.
  bool doubts() const { return count_ > 0; }
  double doubted_s() const { return last_.time_s; }
  /// After Jump::shifted: by how much the tracker's places now lie beside those before.
  const glm::dvec3& offset_m() const { return offset_m_; }

 private:
  struct Sample {
    double time_s = 0.0;
    glm::dvec3 position_m{0.0};
    glm::dvec3 offCourse_m{0.0};
  };
  Jump judgeFirst(const CelerityFilter& head, const Sample& sample, double interval_s);
  Jump judgeNext(const CelerityFilter& head, const Sample& sample, double interval_s);
  void follow(const Sample& sample, double within_m, double sigma_m);
  double tolerance_m(const CelerityFilter& head, double startled_s, double course_s) const;

  glm::dvec3 used_m_{0.0};    // where the newest used sample was
  double surprise_m2_ = 0.0;  // how far used samples were off the course of late: variance of a coordinate

  // Doubted samples since then.
  int count_ = 0;
  Sample last_;
  double travels_s_ = 0.0;           // from when on they go on from each other
  int beside_ = 0;                   // how many of them keep beside the course, up to the last
  double beside_s_ = 0.0;            // since when
  glm::dvec3 offset_m_{0.0};         // by how much, on average
  int moves_ = 0;                    // how many move as a head might, up to the last
  glm::dvec3 offCelerity_m_s_{0.0};  // how fast the last of them left the course
};

}  // namespace carom
