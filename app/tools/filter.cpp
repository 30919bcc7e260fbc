#include "app/tools/filter.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "app/tools/option_values.h"
#include "devices/filter/aberration_error.h"
#include "devices/filter/head_filter.h"
#include "devices/tracker/trace.h"
#include "engine/text/whole_file.h"

namespace carom {

namespace {

/// Accumulates a root mean square.
class MeanSquare {
 public:
  void add(double square) {
    sum_ += square;
    ++count_;
  }
  long count() const { return count_; }
  double root() const { return count_ > 0 ? std::sqrt(sum_ / static_cast<double>(count_)) : 0.0; }

 private:
  double sum_ = 0.0;
  long count_ = 0;
};

/// Statistics of a filtered trace.
struct Summary {
  long glitches = 0;
  double lag_s = 0.0;   // sum over the rows
  MeanSquare celerity;  // of its magnitude
  double fastest_m_s = 0.0;
  MeanSquare sigma;           // estimated by the filter, of one component
  MeanSquare swing_rad;       // estimated by the filter
  double quietest_m_s = 0.0;  // RMS of one component in the quietest second
  double trackerSigma_m = 0.0;
};

std::string rowOf(const HeadEstimate& head) {
  const glm::dvec3 &r = head.pose.position_m, &w = head.celerity_m_s;
  return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", head.time_s, r.x,
                     r.y, r.z, w.x, w.y, w.z, head.sigma_m_s);
}

/// Calls `each` with the head estimate at every row, computed without later rows.
template <class Each>
Summary filterTrace(const std::vector<TrackerSample>& rows, double lightSpeed_m_s, const Each& each) {
  constexpr double kWindow_s = 1.0;
  Summary summary;
  HeadFilter filter;
  MeanSquare window;
  double windowBegin_s = rows.front().time_s;
  bool windowed = false;
  for (const TrackerSample& row : rows) {
    summary.glitches += filter.add(row.time_s, row.pose) != SampleUse::used;
    const HeadEstimate head = filter.at(row.time_s);
    each(head);
    const double square_m2_s2 = glm::dot(head.celerity_m_s, head.celerity_m_s);
    summary.celerity.add(square_m2_s2);
    summary.fastest_m_s = std::max(summary.fastest_m_s, std::sqrt(square_m2_s2));
    summary.sigma.add(head.sigma_m_s * head.sigma_m_s);
    const double swing_rad =
        aberrationError_rad(head.celerity_m_s, head.celerityCovariance_m2_s2, lightSpeed_m_s);
    summary.swing_rad.add(swing_rad * swing_rad);
    summary.lag_s += head.lag_s;
    if (row.time_s >= windowBegin_s + kWindow_s) {
      summary.quietest_m_s = windowed ? std::min(summary.quietest_m_s, window.root()) : window.root();
      windowed = true;
      window = {};
      windowBegin_s = row.time_s;
    }
    window.add(square_m2_s2 / 3.0);
  }
  if (!windowed) summary.quietest_m_s = window.root();
  summary.trackerSigma_m = filter.trackerSigma_m();
  return summary;
}

/// The time steps between a trace's rows.
struct Spacing {
  double median_s = 0.0;  ///< 0 where there is only one row
  double longest_s = 0.0;
  long dropouts = 0;  ///< gaps of over one and a half times the median
};

Spacing spacingOf(const std::vector<TrackerSample>& rows) {
  constexpr double kGap = 1.5;
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < rows.size(); ++i) intervals_s.push_back(rows[i].time_s - rows[i - 1].time_s);
  if (intervals_s.empty()) return {};
  const auto middle = intervals_s.begin() + static_cast<std::ptrdiff_t>(intervals_s.size() / 2);
  std::nth_element(intervals_s.begin(), middle, intervals_s.end());
  Spacing spacing{*middle, *std::max_element(intervals_s.begin(), intervals_s.end()), 0};
  spacing.dropouts = std::count_if(intervals_s.begin(), intervals_s.end(),
                                   [&](double interval_s) { return interval_s > kGap * spacing.median_s; });
  return spacing;
}

std::string tableOf(const FilterOptions& options, const std::vector<TrackerSample>& rows,
                    const Summary& summary) {
  const Spacing spacing = spacingOf(rows);
  const double c_m_s = options.lightSpeed_m_s;
  const auto degrees = [](double rad) { return glm::degrees(rad); };
  std::string text;
  const auto line = [&text](const char* what, const std::string& value) {
    text += fmt::format("{:<24}{}\n", what, value);
  };
  line("rows", fmt::format("{} in {:.2f} s", rows.size(), rows.back().time_s - rows.front().time_s));
  if (spacing.median_s > 0.0) {
    line("rate", fmt::format("{:.1f} Hz (median), longest interval {:.1f} ms", 1.0 / spacing.median_s,
                             1e3 * spacing.longest_s));
  }
  line("dropouts", fmt::format("{}", spacing.dropouts));
  line("glitches", fmt::format("{} rows not used", summary.glitches));
  line("tracker noise",
       fmt::format("{:.3f} mm, standard deviation of a coordinate", 1e3 * summary.trackerSigma_m));
  line("celerity",
       fmt::format("{:.3f} m/s RMS, {:.3f} m/s at most", summary.celerity.root(), summary.fastest_m_s));
  line("its stated error", fmt::format("{:.2f} mm/s RMS of a component", 1e3 * summary.sigma.root()));
  line("its lag",
       fmt::format("{:.1f} ms in movement", 1e3 * summary.lag_s / static_cast<double>(rows.size())));
  line("rest noise",
       fmt::format("{:.2f} mm/s RMS of a component, in the quietest second", 1e3 * summary.quietest_m_s));
  text += fmt::format("\nwhat the sky swings by, light at {} m/s (RMS)\n", c_m_s);
  // For a landmark perpendicular to it, each component of celerity turns the direction about one of two axes.
  line("  quietest second", fmt::format("{:.3f}°", degrees(std::sqrt(2.0) * summary.quietest_m_s / c_m_s)));
  line("  on the whole", fmt::format("{:.3f}°, as stated by the filter", degrees(summary.swing_rad.root())));
  if (spacing.median_s > 0.0) {
    // A difference of two positions: √2 σ/T.
    const double raw_m_s = std::sqrt(2.0) * summary.trackerSigma_m / spacing.median_s;
    line("  unfiltered", fmt::format("{:.3f}°, at rest", degrees(std::sqrt(2.0) * raw_m_s / c_m_s)));
  }
  return text;
}

}  // namespace

int runFilter(const FilterOptions& options) {
  const std::vector<TrackerSample> rows = readTrace(options.trace);
  WholeFile out(options.csv.value_or("-"));
  std::string text;
  if (options.csv) {
    text = "time_s,x_m,y_m,z_m,celerity_x_m_s,celerity_y_m_s,celerity_z_m_s,sigma_m_s\n";
    filterTrace(rows, options.lightSpeed_m_s, [&](const HeadEstimate& head) { text += rowOf(head); });
  } else {
    text = tableOf(options, rows, filterTrace(rows, options.lightSpeed_m_s, [](const HeadEstimate&) {}));
  }
  out.commit(text);
  return 0;
}

void addFilter(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("filter", "Run a recorded tracker trace through the head filter of a session");
  auto options = std::make_shared<FilterOptions>();
  command
      ->add_option("TRACE", options->trace,
                   "Recorded trace with the columns time_s,x_m,y_m,z_m and optionally qx,qy,qz,qw")
      ->required()
      ->transform(shipped({"traces"}));
  command
      ->add_option("--light-speed", options->lightSpeed_m_s,
                   "Speed of light in m/s, for the error of the directions that the eye sees")
      ->capture_default_str()
      ->type_name("C")
      ->check(numberIn(kPositive, "a speed above 0 up to 1e9 m/s"));
  command
      ->add_option(
          "--csv", options->csv,
          "Write position, celerity and its standard deviation, one row for each row of the trace; - "
          "is standard output. By default, a summary is printed")
      ->type_name("FILE");
  command->footer(
      "Each row of the result depends only on the same row of the trace and earlier ones.\n"
      "Example:\n  carom filter walk --light-speed 1.42");
  command->callback([options, &status] { status = runFilter(*options); });
}

}  // namespace carom
