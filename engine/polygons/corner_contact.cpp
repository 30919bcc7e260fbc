#include "engine/polygons/corner_contact.h"

#include <algorithm>
#include <cmath>

#include "engine/base/never.h"
#include "engine/polygons/board_passage.h"
#include "engine/polygons/corner_search.h"

namespace carom {

namespace {

constexpr double kResumed = 1e-9;   // of the radii: what comes so soon after a contact is that contact
constexpr double kSideways = 0.02;  // of light speed: bodies that approach slower along n leave sideways
constexpr double kBeside = 0.7;     // nearer to the normal, by this cosine, no body leaves another sideways

bool haveCorners(const MovingShape& first, const MovingShape& second) {
  return first.outline != nullptr && second.outline != nullptr;
}

// From when both flights have begun.
ContactWindow windowFromBoth(const MovingShape& first, const MovingShape& second, const Vec21& U) {
  ContactWindow window;
  window.frame = U;
  window.origin = first.start;
  window.from = std::max(0.0, dot(U, second.start - first.start));
  return window;
}

ContactWindow windowOf(const MovingShape& first, const MovingShape& second, const Vec21& order) {
  const bool bothFirst = first.start.t == 0.0 && second.start.t == 0.0;
  if (!bothFirst) return windowFromBoth(first, second, order);
  ContactWindow window;
  window.strictly = true;
  window.frame = {1.0, 0.0, 0.0};
  window.origin = first.start;
  return window;
}

// What bodies know of an earlier contact ends where they have parted.
std::optional<FoundContact> findFirst(const MovingShape& first, const MovingShape& second, const Vec21& order,
                                      const ContactWindow& window, const PersistentContact* earlier) {
  if (!haveCorners(first, second)) return findRimContact(first, second, order, window, earlier);
  const std::optional<FoundContact> found = findPiercing(first, second, order, window, earlier);
  if (earlier == nullptr || (found && (found->withoutDelay || found->unfinished))) return found;
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  const double parted = partingOfCorners(first, second, U, window, *earlier, found ? found->time : kNever);
  if (parted == kNever || (found && found->time <= parted)) return found;
  ContactWindow after = window;
  after.from = parted;
  after.strictly = false;
  return findPiercing(first, second, order, after, nullptr);
}

std::optional<CornerContact> findContact(const MovingShape& first, const MovingShape& second,
                                         const Vec21& order, const ContactWindow& window,
                                         const PersistentContact* earlier) {
  const std::optional<FoundContact> found = findFirst(first, second, order, window, earlier);
  if (!found) return std::nullopt;

  CornerContact contact;
  contact.withoutDelay = found->withoutDelay;
  contact.sideOnSide = found->sideOnSide;
  contact.unfinished = found->unfinished;
  contact.time = found->time;
  contact.contact.event = found->event;
  contact.contact.U = order;
  contact.contact.n = found->normal;
  const MovingShape* const flights[]{&first, &second};
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

std::optional<CornerContact> findCornerContact(const MovingShape& first, const MovingShape& second,
                                               double after, const PersistentContact* earlier, bool onlyNew) {
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  const bool begins = after == -std::numeric_limits<double>::infinity();
  if (begins && !(onlyNew && earlier != nullptr)) return findCornerContact(first, second, U, earlier);
  ContactWindow window = windowFromBoth(first, second, U);
  if (!begins) window.from = after + kResumed * (first.radius + second.radius);
  window.resumed = true;
  window.onlyNew = onlyNew;
  return findContact(first, second, U, window, earlier);
}

std::optional<CornerContact> findCornerContact(const MovingShape& first, const MovingShape& second,
                                               const Vec21& order, const PersistentContact* earlier) {
  return findContact(first, second, order, windowOf(first, second, order), earlier);
}

namespace {

// When the circles around both leave each other, in the window's frame: |d + w t| = R1 + R2 for the last
// time.
double circlesPart(const MovingShape& first, const MovingShape& second, const ContactWindow& since) {
  const Vec21& U = since.frame;
  const double from = std::max(since.timeOf(first.start), since.timeOf(second.start));
  const auto placeAt = [&](const MovingShape& flight) {
    return flight.start + flight.u * ((from - since.timeOf(flight.start)) / dot(U, flight.u));
  };
  const Vec21 d = placeAt(second) - placeAt(first);
  const Vec21 w = second.u * (1.0 / dot(U, second.u)) - first.u * (1.0 / dot(U, first.u));
  const double reach = first.radius + second.radius;
  const double ww = -dot(w, w), dw = -dot(d, w), dd = -dot(d, d) - reach * reach;
  const double root2 = dw * dw - ww * dd;
  return ww > 0.0 && root2 > 0.0 ? from + (-dw + std::sqrt(root2)) / ww : from;
}

// How fast two bodies approach along n in their frame of equal speeds, over c; below 0 if they recede.
double approachAlong(const Vec21& n, const MovingShape& first, const MovingShape& second) {
  const Vec21 U = equalSpeedFrame(first.u, second.u), along = n - U * dot(U, n);
  return dot(along, second.u - first.u) / (std::sqrt(-dot(along, along)) * dot(U, first.u));
}

// Their relative speed, likewise.
double relativeSpeed(const MovingShape& first, const MovingShape& second) {
  const Vec21 apart = second.u - first.u;
  return std::sqrt(std::max(0.0, -dot(apart, apart))) / dot(equalSpeedFrame(first.u, second.u), first.u);
}

}  // namespace

bool partElsewhere(const std::array<std::vector<MovingShape>, 2>& flights, const PersistentContact& earlier) {
  if (!flights[0].front().outline->isConvex() || !flights[1].front().outline->isConvex()) return false;
  const ContactWindow window = windowAt(earlier);
  std::array<std::size_t, 2> at{0, 0};
  const auto turn = [&](int k) {
    return at[k] + 1 < flights[k].size() ? window.timeOf(flights[k][at[k] + 1].start) : kNever;
  };
  Passage passage;
  while (turn(0) < kNever || turn(1) < kNever) {
    const int next = turn(1) < turn(0) ? 1 : 0;
    followPassage(flights[0][at[0]], flights[1][at[1]], earlier, turn(next), passage);
    ++at[next];
  }
  const MovingShape &first = flights[0].back(), &second = flights[1].back();
  followPassage(first, second, earlier, circlesPart(first, second, window), passage);
  if (passage.elsewhere) return true;
  return approachAlong(earlier.n, first, second) > kSideways &&
         passage.leastAlong < std::min(relativeSpeed(first, second), kBeside);
}

bool goPast(const MovingShape& first, const MovingShape& second, const PersistentContact& touched,
            const PersistentContact* noted) {
  return approachAlong(touched.n, first, second) > kSideways &&
         !findCornerContact(first, second, -kNever, noted) && passEachOther(first, second, touched);
}

PenetrationState penetrationSince(const PersistentContact& earlier, const MovingShape& first,
                                  const MovingShape& second) {
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  const auto penetration = haveCorners(first, second) ? penetrationOfCorners : penetrationOfDisc;
  return penetration(first, second, U, windowFromBoth(first, second, U), earlier);
}

PenetrationState penetrationSince(const PersistentContact& earlier, const MovingShape& first,
                                  const MovingShape& second, double time) {
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  ContactWindow window;
  window.frame = U;
  window.origin = first.start;
  window.from = time;
  const auto penetration = haveCorners(first, second) ? penetrationOfCorners : penetrationOfDisc;
  return penetration(first, second, U, window, earlier);
}

std::vector<TouchedPlace> placesKeptOut(const MovingShape& first, const MovingShape& second, double time,
                                        const PersistentContact& earlier) {
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  ContactWindow window;
  window.frame = U;
  window.origin = first.start;
  window.from = time;
  std::vector<FoundContact> found;
  addPiercedPlaces(first, second, U, window, 0.0, &earlier, found);
  std::vector<TouchedPlace> places;
  for (const FoundContact& one : found) places.push_back({one.event, one.normal});
  return places;
}

std::vector<TouchedPlace> touchedPlaces(const MovingShape& first, const MovingShape& second, double within,
                                        const PersistentContact* earlier) {
  const Vec21 U = equalSpeedFrame(first.u, second.u);
  std::vector<FoundContact> found;
  const auto add = haveCorners(first, second) ? addPiercedPlaces : addRimPlaces;
  add(first, second, U, windowFromBoth(first, second, U), within, earlier, found);
  std::vector<TouchedPlace> places;
  for (const FoundContact& one : found) places.push_back({one.event, one.normal});
  return places;
}

Meeting meetingOf(const MovingShape& first, const MovingShape& second, const CornerContact& found,
                  TurnConvention convention) {
  const bool delayed = convention == TurnConvention::signalAtCentre;
  const auto moment = [&](const MovingShape& flight, int i) {
    const double turn =
        delayed && !found.withoutDelay ? found.contact.signal[i] : found.contact.simultaneous[i];
    return flight.start.t + flight.u.t * (delayed ? turn - flight.radius : turn);
  };
  return {{moment(first, 0), moment(second, 1)}, found.withoutDelay};
}

}  // namespace carom
