#include "engine/collision/puck_contact.h"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

// The approach of two flights in their equal-speed frame.
struct Approach {
  Vec21 D, sum, difference, normal;  // X2−X1, u1+u2, u1−u2, u1×u2
  double q = 0.0;                    // 2(γrel − 1) = (2γ'β')²
  double s2 = 0.0;                   // γrel² − 1
  double triple = 0.0;               // b² = triple²/s2
};

Approach approachOf(const Disc& first, const Disc& second) {
  Approach p;
  p.D = second.start - first.start;
  p.sum = first.u + second.u;
  p.difference = first.u - second.u;
  // γ1 − γ2 = (u1+u2)·(u1−u2)/(γ1+γ2) keeps its digits when the speeds are nearly equal.
  p.difference.t = (p.sum.x * p.difference.x + p.sum.y * p.difference.y) / p.sum.t;
  p.q = p.difference.x * p.difference.x + p.difference.y * p.difference.y - p.difference.t * p.difference.t;
  p.s2 = p.q * (0.25 * p.q + 1.0);
  // u1×u2 = (u1−u2)×u2 likewise: pucks of nearly one velocity do not meet by rounding.
  p.normal = cross(p.difference, second.u);
  p.triple = dot(p.normal, p.D);
  return p;
}

// What follows from it once b < R1 + R2.
struct Touch {
  double gamma, beta;   // γ', β'
  double lead;          // a: by how much X2 is later than X1 in the equal-speed frame
  double atLaterStart;  // Dpar when the later of the two flights begins
  double dmin;
  double wait;  // Δt' from X1
};

Touch touchOf(const Approach& p, double reach) {
  Touch touch;
  const double twoGammaBeta = std::sqrt(p.q), twoGamma = std::sqrt(p.q + 4.0);
  touch.gamma = 0.5 * twoGamma;
  touch.beta = twoGammaBeta / twoGamma;
  touch.lead = dot(p.sum, p.D) / twoGamma;
  const double dpar = -dot(p.difference, p.D) / twoGammaBeta + touch.lead * touch.beta;
  touch.atLaterStart = dpar - 2.0 * touch.beta * std::max(0.0, touch.lead);
  touch.dmin = std::sqrt(reach * reach - p.triple * p.triple / p.s2) / touch.gamma;
  touch.wait = (dpar - touch.dmin) / (2.0 * touch.beta);
  return touch;
}

Meeting meetingWithoutDelay(const Disc& first, const Disc& second, const Touch& touch) {
  const double start = std::max(0.0, touch.lead);
  return {{first.start.t + first.u.t * (start / touch.gamma),
           second.start.t + second.u.t * ((start - touch.lead) / touch.gamma)},
          true};
}

}  // namespace

std::optional<Meeting> findMeeting(const Disc& first, const Disc& second, TurnConvention convention) {
  const Approach p = approachOf(first, second);
  const double reach = first.radius + second.radius;
  if (!(p.triple * p.triple < reach * reach * p.s2))
    return std::nullopt;  // they pass, or keep their distance
  // Dpar at the later start, times 2γ'β': negative when the closest approach lies before it.
  const double approaching = -dot(p.difference, p.D) - p.q / (p.q + 4.0) * std::abs(dot(p.sum, p.D));
  if (convention == TurnConvention::simultaneousWithContact) {
    if (!(approaching > 0.0)) return std::nullopt;
    const Touch touch = touchOf(p, reach);
    if (touch.atLaterStart <= touch.dmin) return meetingWithoutDelay(first, second, touch);
    return Meeting{{first.start.t + first.u.t * (touch.wait / touch.gamma),
                    second.start.t + second.u.t * ((touch.wait - touch.lead) / touch.gamma)},
                   false};
  }

  const Touch touch = touchOf(p, reach);
  // u_i·(C − X_i) = Δt'_i/γ' − R_i/(R1+R2) dmin γ'β'.
  const double share = touch.dmin * touch.gamma * touch.beta / reach;
  const double own1 = touch.wait / touch.gamma - first.radius * share;
  const double own2 = (touch.wait - touch.lead) / touch.gamma - second.radius * share;
  const bool heardAfterStart = own1 + first.radius > 0.0 && own2 + second.radius > 0.0;
  const bool bothFirst = first.start.t == 0.0 && second.start.t == 0.0;
  bool real = heardAfterStart;
  if (real && bothFirst) {
    real = contactOf(first, second, false).event.t > 0.0;
  } else if (real && !(approaching > 0.0)) {
    real = (own1 >= 0.0 || first.start.t == 0.0) && (own2 >= 0.0 || second.start.t == 0.0);
  }
  if (real) {
    return Meeting{{first.start.t + first.u.t * own1, second.start.t + second.u.t * own2}, false};
  }
  if (heardAfterStart || bothFirst || !(approaching > 0.0) || touch.atLaterStart > touch.dmin)
    return std::nullopt;
  Meeting meeting = meetingWithoutDelay(first, second, touch);
  meeting.ownTime[0] -= first.u.t * first.radius;
  meeting.ownTime[1] -= second.u.t * second.radius;
  return meeting;
}

PairContact contactOf(const Disc& first, const Disc& second, bool withoutDelay) {
  const Approach p = approachOf(first, second);
  const double reach = first.radius + second.radius;
  const Touch touch = touchOf(p, reach);
  const double apart = withoutDelay ? touch.atLaterStart : touch.dmin;
  const double wait = withoutDelay ? std::max(0.0, touch.lead) : touch.wait;
  const Vec21 e = p.difference * (0.5 / (touch.gamma * touch.beta));
  const Vec21 perp = p.normal * (-p.triple / p.s2);
  const double share = apart * touch.gamma * touch.beta / reach;

  PairContact contact;
  contact.U = p.sum * (0.5 / touch.gamma);
  contact.n = e * (touch.gamma * touch.gamma * apart) + perp;
  contact.simultaneous = {wait / touch.gamma, (wait - touch.lead) / touch.gamma};
  contact.event =
      first.start + first.u * contact.simultaneous[0] + (e * apart + perp) * (first.radius / reach);
  contact.signal = {contact.simultaneous[0] - first.radius * share + first.radius,
                    contact.simultaneous[1] - second.radius * share + second.radius};
  return contact;
}

}  // namespace carom
