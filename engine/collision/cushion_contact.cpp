#include "engine/collision/cushion_contact.h"

#include <algorithm>
#include <cmath>

#include "engine/base/bisection.h"

namespace carom {

namespace {

// Of the radius. A signal that has less than this to go is there already: where rounding decided, a game and
// its image by an exchange of x and y would differ by a kick's delay. Turns so close to each other are one
// turn elsewhere, too.
constexpr double kThere = 1e-9;

// Distance of the centre from the cushion at its own moment of the contact.
double distanceAtContact(const Vec21& u, double un, double radius, TurnConvention convention) {
  if (convention == TurnConvention::signalAtCentre) return radius * std::sqrt(1.0 + un * un);
  // R sqrt(1 − β_n²), with 1 − β_n² = (1 + u_t²)/γ².
  const double transverse2 = u.x * u.x + u.y * u.y - un * un;
  return radius * std::sqrt(1.0 + transverse2) / u.t;
}

// The centre's moment of contact, on a leg that friction slows: the one root of the strictly falling
// y(t) − distanceAtContact(t)  (R a < c²/2 keeps it so). None if the puck rests before.
std::optional<double> brakedContact(const Leg& leg, double radius, const CushionPlane& cushion,
                                    TurnConvention convention) {
  const auto clearance = [&](double t) {
    const LegState m = momentAt(leg, t);
    return cushion.inside(m.x) - distanceAtContact(m.u, cushion.towards(m.u), radius, convention);
  };
  const double low = leg.start.t, high = restsAt(leg);
  if (!(clearance(high) < 0.0)) return std::nullopt;
  if (clearance(low) <= 0.0) return low;
  constexpr int kHalvings = 2200;  // to the last bit, from the largest number to the least
  return bisect({low, high}, kHalvings, [&](double t) { return clearance(t) > 0.0; }).high;
}

Vec21 besideCentre(const Vec21& x, const CushionPlane& cushion) {
  Vec21 event = x;
  (cushion.axis == 0 ? event.x : event.y) = cushion.sign * cushion.distance;
  return event;
}

// C from the puck's moment of contact.
Vec21 contactInRestFrame(const LegState& m, double un, double radius, const CushionPlane& cushion) {
  const Vec21 normal = cushion.axis == 0 ? Vec21{0.0, cushion.sign, 0.0} : Vec21{0.0, 0.0, cushion.sign};
  return besideCentre(m.x + (normal + m.u * un) * (radius / std::sqrt(1.0 + un * un)), cushion);
}

Vec21 contactOnBoard(const LegState& m, double radius, const CushionPlane& cushion) {
  const double betaN = cushion.towards(m.u) / m.u.t;
  const double transverse2 = m.u.x * m.u.x + m.u.y * m.u.y - betaN * betaN * m.u.t * m.u.t;
  const double along = -radius * betaN / (std::sqrt(1.0 + transverse2));  // R β_n/(γ sqrt(1 − β_n²)), of u
  return besideCentre(m.x + Vec21{0.0, m.u.x * along, m.u.y * along}, cushion);
}

}  // namespace

std::optional<CushionContact> findContact(const Leg& leg, double radius, const CushionPlane& cushion,
                                          TurnConvention convention) {
  const double un = cushion.towards(leg.u);
  if (!(un > 0.0)) return std::nullopt;
  const double y = cushion.inside(leg.start);
  const double atContact = distanceAtContact(leg.u, un, radius, convention);
  const bool delayed = convention == TurnConvention::signalAtCentre;
  CushionContact contact;

  const double atTurn = delayed ? radius / (std::sqrt(1.0 + un * un) + un) : atContact;
  if (!(y > atTurn + kThere * radius)) {  // the signal is there already
    contact.withoutDelay = true;
    contact.ownTime = leg.start.t - (delayed ? leg.u.t * radius : 0.0);
    contact.turn = {leg.start, leg.u, leg.properTime};
    contact.event =
        delayed ? besideCentre(leg.start, cushion) : contactOnBoard(contact.turn, radius, cushion);
    return contact;
  }
  // Own proper time to the contact; below 0 when the rim was in contact before the leg began, and only the
  // signal is still on its way.
  double s = (y - atContact) / un;
  LegState atOwnContact = momentAfter(leg, s);
  if (leg.brake != 0.0 && s > 0.0) {
    const std::optional<double> t = brakedContact(leg, radius, cushion, convention);
    if (!t) return std::nullopt;
    atOwnContact = momentAt(leg, *t);
  }
  contact.ownTime = atOwnContact.x.t;
  if (!delayed) {
    contact.turn = atOwnContact;
    contact.event = contactOnBoard(atOwnContact, radius, cushion);
    return contact;
  }
  contact.event = contactInRestFrame(atOwnContact, cushion.towards(atOwnContact.u), radius, cushion);
  contact.turn = leg.brake == 0.0 ? momentAfter(leg, (y - atTurn) / un) : signalArrives(leg, contact.event);
  return contact;
}

}  // namespace carom
