#include "cave/frame/lesson_readings.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/spacetime/lorentz.h"

namespace carom {

double elapsed_s(const Event& from, const Event& to, const Vec3& beta, double c_m_s) {
  return (Lorentz::boost(uFromBeta(beta), c_m_s).inverse() * (to - from)).dt_s;
}

double simultaneousAt_s(const Event& with, const Vec3& place_m, const Vec3& beta, double c_m_s) {
  return with.t_s + glm::dot(beta, place_m - with.r_m) / c_m_s;
}

double reading_s(const Stopwatch& stopwatch, const LessonSight& sight) {
  const Event& now = sight.observer.middle.observation;
  const double c_m_s = sight.boardFromRoom.lightSpeed_m_s();
  if (stopwatch.clock == StopwatchClock::mine) return sight.observer.properTime_s;
  if (stopwatch.clock == StopwatchClock::seen)
    return now.t_s - glm::distance(now.r_m, stopwatch.seen_m) / c_m_s - stopwatch.starts.t_s;
  const bool inRoom = stopwatch.clock == StopwatchClock::room;
  const Vec3 beta = inRoom ? betaFromU(sight.boardFromRoom.u()) : stopwatch.beta;
  const auto sinceStart_s = [&](const Event& event) {
    return elapsed_s(stopwatch.starts, event, beta, c_m_s);
  };
  std::optional<double> last_s;
  if (stopwatch.stops) last_s = sinceStart_s(*stopwatch.stops);
  if (stopwatch.stopsWhenSeen) {
    const Event& starts = stopwatch.starts;
    last_s = sinceStart_s({starts.t_s + glm::distance(now.r_m, starts.r_m) / c_m_s, now.r_m});
  }
  if (!last_s) return sinceStart_s(now);
  if (sight.phase == LessonPhase::explains) return *last_s;
  const double now_s = sinceStart_s(now);
  return now_s < 0.0 ? 0.0 : std::min(now_s, *last_s);
}

double gauged(GaugeQuantity quantity, const Motion& seen, const LessonSight& sight) {
  const Lorentz roomFromBoard = sight.boardFromRoom.inverse();
  const Vec3 u = (roomFromBoard * Lorentz::boost(seen.u, roomFromBoard.lightSpeed_m_s())).u();
  if (quantity == GaugeQuantity::gamma) return gammaFromU(u);
  const Vec3 beta = betaFromU(u);
  if (quantity == GaugeQuantity::speed) return glm::length(beta);
  const Displacement way = roomFromBoard * (seen.event - sight.observer.middle.observation);
  const double receding = sight.switches.retardation != 0 ? glm::dot(glm::normalize(way.dr_m), beta) : 0.0;
  const double length = sight.switches.contraction != 0 ? 1.0 / gammaFromU(u) : 1.0;
  return (quantity == GaugeQuantity::seenLength ? length : glm::length(beta)) / (1.0 + receding);
}

std::optional<std::size_t> observerOf(const LessonPlan& plan, const Lorentz& boardFromRoom) {
  constexpr double kSame = 1e-6;
  const Vec3 beta = betaFromU(boardFromRoom.u());
  const auto found = std::find_if(plan.observers.begin(), plan.observers.end(), [&](const auto& observer) {
    return glm::distance(observer.beta, beta) < kSame;
  });
  if (found == plan.observers.end()) return {};
  return static_cast<std::size_t>(found - plan.observers.begin());
}

}  // namespace carom
