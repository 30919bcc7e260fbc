#pragma once
// Estimates how noisy a tracker is from its own samples, whether it moves or not.

#include <array>
#include <glm/vec3.hpp>

namespace carom {

/// Estimates the standard deviation of a tracker's position noise per axis. Noise is what fifth differences
/// hold: a path that is locally a polynomial of degree four cancels in them, and of a component at 2 Hz, the
/// quickest that is large in a head's motion, a ten-thousandth is left at 120 Hz and four at 60 Hz. Below
/// 30 Hz more would be left, and the estimate then stays as it is while the sensor moves.
///
/// They see noise at half the rate of the samples. Of white noise that is all there is to know. But many a
/// tracker smooths its samples, and errors that last for several of them do more to a celerity than white
/// ones of the same size. So noise is measured at three spacings: as the samples come, of 11 ms and of 22 ms
/// at least. Where the wider ones show more than the narrower, beyond chance, the estimate is raised, to
/// twice its value at most: more than that may be motion.
///
/// While the sensor is still, it is no motion. Then means over 0.1 s show how large the errors are that last
/// (a magnetic tracker near metal: 1 mm for 50 ms), by Allan's method (1966) with fifth differences: of white
/// noise a mean over n samples keeps 1/n of the variance, of errors that last it keeps more. The ratio, its
/// colour, is remembered while the sensor moves. A sensor is still where it has not gone further within half
/// a second than such errors explain.
///
/// A tracker that rounds its positions has errors of a third of its step q (Widrow's q/√12), and none for
/// seconds where the sensor is still: the estimate is no smaller than that.
class TrackerNoise {
 public:
  /// Starts with an estimate, which counts as much as a few samples.
  explicit TrackerNoise(double sigma_m);
  /// Starts with none: sigma_m() is 0 before the first six samples.
  TrackerNoise() = default;

  /// Takes the next position, at a later time.
  void add(double time_s, const glm::dvec3& position_m);

  /// Forgets the positions (not the estimate): the next position does not continue them.
  void interrupt();

  /// Lets the present estimate count for no more than an initial one.
  void doubt();

  /// Returns the standard deviation of white noise that disturbs a celerity as much as the tracker's noise
  /// does.
  double sigma_m() const { return sigma_m_; }

  /// Whether enough samples were seen for the estimate to rest on them and not on the initial value.
  bool isKnown() const { return near_.isKnown(); }

  /// Whether the sensor keeps its place at present, as far as its noise shows.
  bool isStill() const;

 private:
  /// The estimate from samples that lie at least `least_s` apart.
  class Spacing {
   public:
    explicit Spacing(double least_s) : least_s_(least_s) {}
    Spacing(double least_s, double variance_m2, double weight)
        : least_s_(least_s), variance_m2_(variance_m2), averaged_(weight) {}
    bool take(double time_s, const glm::dvec3& position_m);  ///< returns whether there is a new difference
    void interrupt() { count_ = 0; }
    void doubt(double weight);
    void learn();

    bool isFull() const { return count_ == kPoints; }
    bool isKnown() const;
    double interval_s() const { return (times_s_.back() - times_s_.front()) / (kPoints - 1); }
    double noise_m2() const { return noise_m2_; }  ///< of the newest difference
    double spread_m2() const;                      ///< of the newest step over all points, the same way
    double variance_m2() const { return variance_m2_; }

   private:
    static constexpr int kPoints = 6;
    double differenced_m2() const;

    double least_s_;
    std::array<double, kPoints> times_s_{};
    std::array<glm::dvec3, kPoints> positions_m_{};
    int count_ = 0;
    double noise_m2_ = 0.0;
    double variance_m2_ = 0.0;
    double averaged_ = 0.0;  // how many differences the variance holds
  };
  /// Tells the step to which a tracker rounds, whichever way its axes are turned: squares of the distances
  /// from each position to the next are then multiples of the square of the step.
  class Rounding {
   public:
    void add(const glm::dvec3& position_m);
    double step_m() const;  ///< 0 where positions are not rounded as far as is known

   private:
    glm::dvec3 last_m_{0.0};
    bool hasLast_ = false;
    double square_m2_ = 0.0;  // the smallest distance so far but 0
    int agreeing_ = 0;        // how many on end were multiples of it, or 0
  };

  /// Means over a time.
  struct Block {
    int count = 0;
    double begin_s = 0.0, sum_s = 0.0;
    glm::dvec3 sum_m{0.0};
  };
  void addToBlock(double time_s, const glm::dvec3& position_m);
  void learnColour();
  void estimate();

  static constexpr double kNear_s = 0.011;
  Spacing all_{0.0};
  Spacing near_{kNear_s};
  Spacing far_{2.0 * kNear_s};
  Block block_;
  Spacing means_{0.0};            // of blocks
  double recentMeans_m2_ = 0.0;   // of their fifth differences
  double recentCourse_m2_ = 0.0;  // of their steps over five intervals
  double stillColour_ = 1.0;      // when the sensor was last still; of variances
  Rounding rounding_;
  double sigma_m_ = 0.0;
  double recentNoise_m2_ = 0.0;   // of fifth differences, as variance of one coordinate
  double recentSpread_m2_ = 0.0;  // of steps over five intervals, the same way
};

}  // namespace carom
