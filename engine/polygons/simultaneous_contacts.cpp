// Sides that lie on each other as bodies touch.

#include <cmath>

#include <glm/geometric.hpp>

#include "engine/base/never.h"
#include "engine/polygons/corner_search.h"
#include "engine/polygons/rest_axes.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

/// Whether two contacts at one time are on sides that lie on each other.
bool sameSide(const FoundContact& one, const FoundContact& other, const Vec21& U) {
  const auto inFrame = [&](const Vec21& n) {
    const Vec21 flat = n - U * dot(n, U);
    return flat * (1.0 / std::sqrt(-dot(flat, flat)));
  };
  const Vec21 apart = inFrame(one.normal) - inFrame(other.normal);
  return -dot(apart, apart) < kSameNormal * kSameNormal;
}

/// The ends of what touches where sides lie on each other.
struct SimultaneousContacts {
  Vec21 U, along;
  double low = kNever, high = -kNever;
  Vec21 ends[2];

  void add(const Vec21& event) {
    const double at = -dot(event, along);
    if (at < low) {
      low = at;
      ends[0] = event;
    }
    if (at > high) {
      high = at;
      ends[1] = event;
    }
  }
};

}  // namespace

void settleSimultaneous(const MovingShape& first, const MovingShape& second, const Vec21& U,
                        FoundContact& best) {
  const double tolerance = kSimultaneous * (first.radius + second.radius);
  SimultaneousContacts contacts;
  contacts.U = U;
  contacts.along = cross(best.normal, U);
  const auto collect = [&](const MovingShape& a, const MovingShape& b, bool aIsFirst) {
    const RestAxes axesOfA(a.u), axesOfB(b.u);
    const SinCos ofA = portableSinCos(a.angle), ofB = portableSinCos(b.angle);
    for (const Vec2& corner : a.outline->corners()) {
      const Vec21 from = a.start + axesOfA(turned(corner, ofA));
      const double s = (best.time - dot(U, from - first.start)) / dot(U, a.u);
      const Vec21 event = from + a.u * s;
      const Vec2 z = turnedBack(axesOfB.place(event - b.start), ofB);
      for (const Outline::Side& side : b.outline->sides()) {
        const double along = glm::dot(side.along, z - side.from);
        if (std::abs(glm::dot(side.normal, z) - side.offset) > tolerance || along < -tolerance ||
            along > side.length + tolerance)
          continue;
        FoundContact here = best;
        here.normal = axesOfB(turned(side.normal, ofB)) * (aIsFirst ? -1.0 : 1.0);
        if (sameSide(best, here, U)) contacts.add(event);
      }
    }
  };
  collect(first, second, true);
  collect(second, first, false);
  if (!(contacts.high - contacts.low > tolerance)) return;
  best.event = (contacts.ends[0] + contacts.ends[1]) * 0.5;
  best.sideOnSide = true;
}

}  // namespace carom
