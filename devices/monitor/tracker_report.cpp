#include "devices/monitor/tracker_report.h"

#include <fmt/format.h>

namespace carom {
namespace {

constexpr double kOld_s = 0.1;  // of a sample: so far a head is predicted (devices/filter/head_filter.h)

bool isKnown(const TrackerReport& report) {
  return report.known == Known::measured || report.known == Known::predicted;
}

}  // namespace

TrackerLamp lampOf(const TrackerReport& report) {
  switch (report.health.state) {
    case TrackerHealth::State::failed:
      return TrackerLamp::bad;
    case TrackerHealth::State::silent:
    case TrackerHealth::State::connecting:
      return TrackerLamp::doubtful;
    case TrackerHealth::State::untouched:
    case TrackerHealth::State::delivering:
      break;
  }
  const bool doubtful = report.age_s > kOld_s || report.health.overflowed > 0 ||
                        !report.health.message.empty() || (report.known && !isKnown(report));
  return doubtful ? TrackerLamp::doubtful : TrackerLamp::well;
}

std::string headWords(const TrackerReport& report) {
  if (!report.known) return {};
  const std::string speed =
      fmt::format("speed {:.2f} m/s ± {:.3f} m/s", report.celerity_m_s, report.sigma_m_s);
  if (isKnown(report)) return fmt::format("{},  {}", toString(*report.known), speed);
  if (!(report.age_s <= kOld_s)) {
    if (report.known == Known::held) return fmt::format("held: samples are overdue,  {}", speed);
    return "lost: no sample has come for long; it is shown at rest, where it was";
  }
  // The tracker delivers, and yet the picture is too late for what it told.
  if (report.known == Known::held) {
    return fmt::format("held: drawing is slow, and light leaves {:.2f} s after the newest sample,  {}",
                       report.shownAfter_s, speed);
  }
  return fmt::format(
      "held: drawing is slow, and light leaves {:.2f} s after the newest sample; it is shown at rest",
      report.shownAfter_s);
}

}  // namespace carom
