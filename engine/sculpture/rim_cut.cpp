#include "engine/sculpture/rim_cut.h"

namespace carom {

void cutRim(const Rim& rim, const WorldLine& line, const Event& observation, const Lorentz& headFromBoard,
            ViewTime moment, BodyView& view, std::vector<Event>& events) {
  events.clear();
  viewBody(line, observation, headFromBoard, view, {}, moment);
  const Lorentz boardFromSeen = ViewFrame(headFromBoard, {}, moment).seenFromBoard.inverse();
  const double c_m_s = headFromBoard.lightSpeed_m_s();
  for (const Vec3& point_m : rim) {
    // Light comes from the event (−|x|, x); at a moment, the event is (0, x).
    const Vec3 seen_m = seenFromEye(view, emissionIn(view, point_m));
    const double since_s = moment == ViewTime::seen ? -glm::length(seen_m) / c_m_s : 0.0;
    const Event event = observation + boardFromSeen * Displacement{since_s, seen_m};
    if (event.t_s < line.appears_s()) return events.clear();
    events.push_back(event);
  }
}

}  // namespace carom
