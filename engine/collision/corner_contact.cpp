#include "engine/collision/corner_contact.h"

#include <algorithm>
#include <cmath>

#include "engine/collision/corner_search.h"

namespace carom {

namespace {

constexpr double kResumed = 1e-9;  // of the radii: what comes so soon after a contact is that contact

ContactWindow windowOf(const ShapedFlight& first, const ShapedFlight& second, const Vec21& order) {
  const bool bothFirst = first.start.t == 0.0 && second.start.t == 0.0;
  ContactWindow window;
  window.strictly = bothFirst;
  window.frame = bothFirst ? Vec21{1.0, 0.0, 0.0} : order;
  window.origin = first.start;
  window.from = bothFirst ? 0.0 : std::max(0.0, dot(order, second.start - first.start));
  return window;
}

std::optional<CornerContact> findContact(const ShapedFlight& first, const ShapedFlight& second,
                                         const Vec21& order, const ContactWindow& window) {
  const std::optional<FoundContact> found = first.outline != nullptr && second.outline != nullptr
                                                ? findPiercing(first, second, order, window)
                                                : findRimContact(first, second, order, window);
  if (!found) return std::nullopt;

  CornerContact contact;
  contact.withoutDelay = found->withoutDelay;
  contact.sideOnSide = found->sideOnSide;
  contact.time = found->time;
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

}  // namespace

std::optional<CornerContact> findCornerContact(const ShapedFlight& first, const ShapedFlight& second,
                                               double after) {
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  if (after == -std::numeric_limits<double>::infinity()) return findCornerContact(first, second, U);
  ContactWindow window;
  window.frame = U;
  window.origin = first.start;
  window.from = after + kResumed * (first.radius + second.radius);
  window.resumed = true;
  return findContact(first, second, U, window);
}

std::optional<CornerContact> findCornerContact(const ShapedFlight& first, const ShapedFlight& second,
                                               const Vec21& order) {
  return findContact(first, second, order, windowOf(first, second, order));
}

std::vector<TouchedPlace> touchedPlaces(const ShapedFlight& first, const ShapedFlight& second,
                                        double within) {
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  ContactWindow window;
  window.frame = U;
  window.origin = first.start;
  window.from = std::max(0.0, dot(U, second.start - first.start));
  std::vector<FoundContact> found;
  if (first.outline != nullptr && second.outline != nullptr)
    addPiercedPlaces(first, second, U, window, within, found);
  else
    addRimPlaces(first, second, U, window, within, found);
  std::vector<TouchedPlace> places;
  for (const FoundContact& one : found) places.push_back({one.event, one.normal});
  return places;
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
