#include "engine/collision/corner_contact.h"

#include <algorithm>
#include <cmath>

#include "engine/collision/corner_search.h"

namespace carom {

std::optional<CornerContact> findCornerContact(const ShapedFlight& first, const ShapedFlight& second) {
  return findCornerContact(first, second, equalSpeedFrame(first.u, second.u));
}

std::optional<CornerContact> findCornerContact(const ShapedFlight& first, const ShapedFlight& second,
                                               const Vec21& order) {
  const bool bothFirst = first.start.t == 0.0 && second.start.t == 0.0;
  ContactWindow window;
  window.strictly = bothFirst;
  window.frame = bothFirst ? Vec21{1.0, 0.0, 0.0} : order;
  window.origin = first.start;
  window.from = bothFirst ? 0.0 : std::max(0.0, dot(order, second.start - first.start));
  const std::optional<FoundContact> found = first.outline != nullptr && second.outline != nullptr
                                                ? findPiercing(first, second, order, window)
                                                : findRimContact(first, second, order, window);
  if (!found) return std::nullopt;

  CornerContact contact;
  contact.withoutDelay = found->withoutDelay;
  contact.sideOnSide = found->sideOnSide;
  contact.contact.event = found->event;
  contact.contact.U = order;
  contact.contact.n = found->normal;
  const ShapedFlight* const flights[]{&first, &second};
  for (int i = 0; i < 2; ++i) {
    const Vec21 way = found->event - flights[i]->start;
    const Vec21& u = flights[i]->u;
    const double own = dot(u, way);
    const Vec21 lever = way - u * own;
    contact.contact.simultaneous[i] = dot(order, way) / dot(order, u);
    contact.contact.signal[i] = own + std::sqrt(std::max(0.0, -dot(lever, lever)));
  }
  return contact;
}

Meeting meetingOf(const ShapedFlight& first, const ShapedFlight& second, const CornerContact& found,
                  TurnConvention convention) {
  const bool delayed = convention == TurnConvention::signalAtCentre;
  const auto moment = [&](const ShapedFlight& flight, int i) {
    const double turn =
        delayed && !found.withoutDelay ? found.contact.signal[i] : found.contact.simultaneous[i];
    return flight.start.t + flight.u.t * (delayed ? turn - flight.radius : turn);
  };
  return {{moment(first, 0), moment(second, 1)}, found.withoutDelay};
}

}  // namespace carom
