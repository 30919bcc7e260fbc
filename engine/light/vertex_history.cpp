#include "engine/light/vertex_history.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "engine/base/portable_math.h"
#include "engine/base/root.h"
#include "engine/light/emission_kernel.h"
#include "engine/spacetime/catch_up.h"

namespace carom {
namespace {

// L(v) d = d + (1/γ − 1)(d·v̂)v̂ = d − (d·u) u/(γ(γ+1))
Vec3 contracted(const Vec3& d, const Vec3& u) {
  const double gamma = gammaFromU(u);
  return d - u * (glm::dot(d, u) / (gamma * (gamma + 1.0)));
}

bool glides(const VertexPiece& piece) { return piece.onLeg && piece.onLeg->knot.deceleration_m_s2 > 0.0; }
bool helical(const VertexPiece& piece) { return piece.onLeg && !glides(piece); }
bool glidesAndSpins(const VertexPiece& piece) { return glides(piece) && spins(piece.onLeg->knot); }

// A point of a spinning body in the rest frame of its leg, τ after the turn on the centre's clock.

Vec3 placeAboard(const VertexPiece::OnLeg& helix, double tau_s) {
  const auto [sine, cosine] = portableSinCos(angleAfter(helix.knot.spin, tau_s));
  const Vec3& d = helix.offset_m;
  return {cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, d.z};
}

/// w = ω ẑ × x, over c.
Vec3 betaAboard(const VertexPiece::OnLeg& helix, double tau_s, double c_m_s) {
  const Vec3 place_m = placeAboard(helix, tau_s);
  return omegaAfter(helix.knot.spin, tau_s) / c_m_s * Vec3(-place_m.y, place_m.x, 0.0);
}

Event eventAboard(const VertexPiece::OnLeg& helix, double tau_s, double c_m_s) {
  return helix.knot.turn +
         Lorentz::boost(helix.knot.u, c_m_s) * Displacement{tau_s, placeAboard(helix, tau_s)};
}

/// τ at which the point is at board time `t_s`: t − t_turn = γ τ + u·x(τ)/c rises, as no point is as fast
/// as light.
double tauAt(const VertexPiece::OnLeg& helix, double t_s, double c_m_s) {
  const Knot& knot = helix.knot;
  const double gamma = gammaFromU(knot.u), since_s = t_s - knot.turn.t_s;
  return rootOfIncreasing(
      [&](double tau_s) {
        return gamma * tau_s + glm::dot(knot.u, placeAboard(helix, tau_s)) / c_m_s - since_s;
      },
      since_s / gamma);
}

/// τ at which what left an event of the leg's frame at `speed`, over c, meets the point; `towards` −1: what
/// the point sends at c to that event.
double tauMeeting(const VertexPiece::OnLeg& helix, const Displacement& from, double speed, double towards,
                  double c_m_s) {
  return rootOfIncreasing(
      [&](double tau_s) {
        return speed * c_m_s * (tau_s - from.dt_s) -
               towards * glm::length(placeAboard(helix, tau_s) - from.dr_m);
      },
      from.dt_s);
}

// A point of a body that glides and spins. At the centre's board time σ it is simultaneous with the centre,
// in the centre's momentary rest frame, at board time t, turned as the centre's clock says and contracted as
// ever:
//     t = σ + u(σ)·d'/c      x = centre(t) + L(v(t)) d'      d' = Rot(φ(τ(σ))) d
// On a straight leg this is its helix, and without spin its glide. t rises with σ while (R a/c²)² + (β f)²
// < 1.
struct SpinningGlide {
  const VertexPiece::OnLeg& leg;
  double c_m_s;

  struct Moment {
    Event event;
    Displacement flow;  ///< a second of σ later
  };

  Motion centreAt(double sigma_s) const { return motionOnLeg(leg.knot, sigma_s, c_m_s); }
  double timeAt(double sigma_s) const {
    const Motion centre = centreAt(sigma_s);
    return sigma_s + glm::dot(centre.u, placeAboard(leg, ownTime_s(centre))) / c_m_s;
  }
  double ownTime_s(const Motion& centre) const { return centre.properTime_s - leg.knot.properTime_s; }
  double sigmaAt(double t_s) const {
    return rootOfIncreasing([&](double sigma_s) { return timeAt(sigma_s) - t_s; }, t_s);
  }
  /// γβ's change in a second, and 0 before the turn and at rest.
  Vec3 brakingAt(const Motion& centre) const {
    const double size = glm::length(centre.u);
    if (size == 0.0 || centre.event.t_s <= leg.knot.turn.t_s) return Vec3(0.0);
    return centre.u * (-leg.knot.deceleration_m_s2 / (c_m_s * size));
  }
  Moment at(double sigma_s) const {
    const Motion centre = centreAt(sigma_s);
    const double own_s = ownTime_s(centre);
    const Vec3 place_m = placeAboard(leg, own_s);
    const Vec3 turned_m_s = betaAboard(leg, own_s, c_m_s) * (c_m_s / gammaFromU(centre.u));
    const double t_s = sigma_s + glm::dot(centre.u, place_m) / c_m_s;
    const double dt = 1.0 + (glm::dot(brakingAt(centre), place_m) + glm::dot(centre.u, turned_m_s)) / c_m_s;
    const Motion then = centreAt(t_s);
    const double gamma = gammaFromU(then.u), size = glm::length(then.u);
    // The centre's motion with the change of the contraction, as in uAt, and the turning.
    const Vec3 carried_m_s =
        size == 0.0 ? Vec3(0.0)
                    : then.u * (c_m_s / gamma) -
                          brakingAt(then) * (glm::dot(place_m, then.u) / (gamma * gamma * gamma));
    return {{t_s, then.event.r_m + contracted(place_m, then.u)},
            {dt, carried_m_s * dt + contracted(turned_m_s, then.u)}};
  }
  /// Where a function of events that rises along the point's world line changes its sign.
  template <typename Function>
  Event crossing(const Function& f, double guess_s) const {
    return at(rootOfIncreasing([&](double sigma_s) { return f(at(sigma_s).event); }, guess_s)).event;
  }
};

/// An event in the leg's frame, from the turn.
Displacement aboard(const Knot& knot, const Event& event, double c_m_s) {
  return Lorentz::boost(-knot.u, c_m_s) * (event - knot.turn);
}

/// Where a function of events that rises along a glide changes its sign.
template <typename Function>
Event crossingOnGlide(const VertexPiece& piece, const Function& f, double guess_s, double c_m_s) {
  if (glidesAndSpins(piece)) return SpinningGlide{*piece.onLeg, c_m_s}.crossing(f, guess_s);
  const auto eventAt = [&](double t_s) { return Event{t_s, placeAt(piece, t_s, c_m_s)}; };
  return eventAt(rootOfIncreasing([&](double t_s) { return f(eventAt(t_s)); }, guess_s));
}

/// Where a piece crosses the future light cone of `signal`, in board time.
Event crossing(const VertexPiece& piece, const Event& signal, double c_m_s) {
  if (helical(piece)) {
    const Displacement from = aboard(piece.onLeg->knot, signal, c_m_s);
    return eventAboard(*piece.onLeg, tauMeeting(*piece.onLeg, from, 1.0, 1.0, c_m_s), c_m_s);
  }
  if (glides(piece)) {
    const auto since = [&](const Event& event) {
      return c_m_s * (event.t_s - signal.t_s) - glm::length(event.r_m - signal.r_m);
    };
    return crossingOnGlide(piece, since, signal.t_s, c_m_s);
  }
  const Displacement from = piece.start - signal;
  const kernel::Piece line{{c_m_s * from.dt_s, from.dr_m}, betaFromU(piece.u)};
  const glm::dvec4 at = kernel::crossingOf(line, glm::dvec4(0.0));
  return signal + Displacement{at.x / c_m_s, {at.y, at.z, at.w}};
}

/// Where a piece crosses the past light cone of the eye: c (T − s) = |X − v s|.
Event retardedEvent(const VertexPiece& piece, const Event& observation, double c_m_s) {
  if (helical(piece)) {
    const Displacement eye = aboard(piece.onLeg->knot, observation, c_m_s);
    return eventAboard(*piece.onLeg, tauMeeting(*piece.onLeg, eye, 1.0, -1.0, c_m_s), c_m_s);
  }
  if (glides(piece)) {
    const auto until = [&](const Event& event) {
      return glm::length(observation.r_m - event.r_m) - c_m_s * (observation.t_s - event.t_s);
    };
    return crossingOnGlide(piece, until, observation.t_s, c_m_s);
  }
  const Displacement eye = observation - piece.start;
  const Vec3 beta = betaFromU(piece.u);
  const double gamma = gammaFromU(piece.u);
  const double T = c_m_s * eye.dt_s;
  const double distance = glm::length(eye.dr_m);
  const double b = T - glm::dot(beta, eye.dr_m);
  const double product = (T - distance) * (T + distance);
  const double root = std::sqrt(std::max(b * b - product / (gamma * gamma), 0.0));
  const double s = b > 0.0 ? product / (b + root) : (b - root) * gamma * gamma;
  return piece.start + Displacement{s / c_m_s, beta * s};
}

/// The piece on which the point follows the leg of `knot`; its clock is not set.
VertexPiece pieceOnLeg(const Knot& knot, const Vec3& offset_m, const Event& start) {
  VertexPiece piece{start, knot.u, 0.0, std::nullopt};
  if (knot.deceleration_m_s2 > 0.0 || spins(knot)) piece.onLeg = {knot, offset_m};
  return piece;
}

/// The piece of the first leg, from the board time of its turn.
VertexPiece firstPiece(const Knot& knot, const Vec3& offset_m, double c_m_s) {
  const Event start{knot.turn.t_s, knot.turn.r_m + contracted(offset_m, knot.u)};
  VertexPiece piece = pieceOnLeg(knot, offset_m, start);
  if (piece.onLeg && spins(knot)) piece.start.r_m = placeAt(piece, start.t_s, c_m_s);
  return piece;
}

/// The speed, over c, at which a point catches up with the leg of the knot. In the rest frame of the turn its
/// place goes round with the spin, and is left behind by friction, by the body's whole speed in the end: both
/// together are at most (w + β)/(1 + w β).
double catchUpSpeedOf(const Knot& knot, const Vec3& offset_m, double c_m_s) {
  const double round = spins(knot) ? glm::length(betaAboard({knot, offset_m}, 0.0, c_m_s)) : 0.0;
  const double back = knot.deceleration_m_s2 > 0.0 ? glm::length(betaFromU(knot.u)) : 0.0;
  return std::max(kCatchUpSpeed, 0.5 + 0.5 * (round + back) / (1.0 + round * back));
}

/// Where a point that leaves `left` at catchUpSpeed, in the rest frame of the knot's turn, meets its place on
/// the leg that begins there.
Event joining(const Knot& knot, const Vec3& offset_m, const Event& left, double c_m_s) {
  const Lorentz boardFromBody = Lorentz::boost(knot.u, c_m_s);
  const Lorentz bodyFromBoard = boardFromBody.inverse();
  const double speed = catchUpSpeedOf(knot, offset_m, c_m_s);
  if (knot.deceleration_m_s2 > 0.0) {
    const auto ahead = [&](const Event& event) {
      const Displacement way = bodyFromBoard * (event - left);
      return speed * c_m_s * way.dt_s - glm::length(way.dr_m);
    };
    return crossingOnGlide(pieceOnLeg(knot, offset_m, left), ahead, left.t_s, c_m_s);
  }
  const Displacement leftInBody = bodyFromBoard * (left - knot.turn);
  if (spins(knot)) {
    const VertexPiece::OnLeg helix{knot, offset_m};
    return eventAboard(helix, tauMeeting(helix, leftInBody, speed, 1.0, c_m_s), c_m_s);
  }
  const double gap_m = glm::length(offset_m - leftInBody.dr_m);
  return knot.turn +
         boardFromBody * Displacement{leftInBody.dt_s + gap_m / (kCatchUpSpeed * c_m_s), offset_m};
}

/// γβ of the straight way from one event to a later one; of something at rest in the knot's frame if they are
/// one.
Vec3 uBetween(const Event& from, const Event& to, const Knot& knot, double c_m_s) {
  const Displacement way = to - from;
  const double properTime_m2 = interval_m2(way, c_m_s);
  return properTime_m2 > 0.0 ? way.dr_m / std::sqrt(properTime_m2) : knot.u;
}

/// Cuts the history where the signal of `knot` arrives and leads it to the leg that begins there. The clocks
/// of its pieces are not set.
void turn(std::vector<VertexPiece>& history, const Knot& knot, const Vec3& offset_m, double c_m_s) {
  Event left = crossing(history.back(), knot.signal, c_m_s);
  while (history.size() > 1 && left.t_s < history.back().start.t_s) {
    history.pop_back();
    left = crossing(history.back(), knot.signal, c_m_s);
  }
  const Event joined = joining(knot, offset_m, left, c_m_s);
  history.push_back({left, uBetween(left, joined, knot, c_m_s), 0.0, std::nullopt});
  history.push_back(pieceOnLeg(knot, offset_m, joined));
}

/// ∫ f from a to b by Simpson's rule, halved until it no longer changes.
template <typename Function>
double integral(const Function& f, double a, double b) {
  double previous = NAN;
  for (int intervals = 8; intervals <= 1 << 16; intervals *= 2) {
    const double h = (b - a) / intervals;
    double sum = f(a) + f(b);
    for (int i = 1; i < intervals; ++i) sum += (i % 2 == 0 ? 2.0 : 4.0) * f(a + i * h);
    const double value = sum * h / 3.0;
    if (std::abs(value - previous) <= 1e-13 * std::abs(value)) return value;
    previous = value;
  }
  return previous;
}

}  // namespace

Vec3 placeAt(const VertexPiece& piece, double t_s, double c_m_s) {
  if (helical(piece)) return eventAboard(*piece.onLeg, tauAt(*piece.onLeg, t_s, c_m_s), c_m_s).r_m;
  if (glidesAndSpins(piece)) {
    const SpinningGlide glide{*piece.onLeg, c_m_s};
    return glide.at(glide.sigmaAt(t_s)).event.r_m;
  }
  if (!glides(piece)) return piece.start.r_m + betaFromU(piece.u) * (c_m_s * (t_s - piece.start.t_s));
  const Motion centre = motionOnLeg(piece.onLeg->knot, t_s, c_m_s);
  return centre.event.r_m + contracted(piece.onLeg->offset_m, centre.u);
}

// On a glide with d∥ along the motion: β = (u/γ)(1 + a d∥/(c²γ²)), from d(1/γ)/dt = a u/(c γ³).
Vec3 uAt(const VertexPiece& piece, double t_s, double c_m_s) {
  if (helical(piece)) {
    const Vec3 w = uFromBeta(betaAboard(*piece.onLeg, tauAt(*piece.onLeg, t_s, c_m_s), c_m_s));
    return (Lorentz::boost(piece.onLeg->knot.u, c_m_s) * Displacement{gammaFromU(w) / c_m_s, w}).dr_m;
  }
  if (!glides(piece)) return piece.u;
  if (glidesAndSpins(piece)) {
    const SpinningGlide glide{*piece.onLeg, c_m_s};
    const Displacement flow = glide.at(glide.sigmaAt(t_s)).flow;
    return uFromBeta(flow.dr_m / (c_m_s * flow.dt_s));
  }
  const Knot& knot = piece.onLeg->knot;
  const Vec3 u = motionOnLeg(knot, t_s, c_m_s).u;
  const double size = glm::length(u);
  if (size == 0.0 || t_s <= knot.turn.t_s) return u;
  const double gamma = gammaFromU(u);
  const double along_m = glm::dot(piece.onLeg->offset_m, u) / size;
  return uFromBeta(u / gamma * (1.0 + knot.deceleration_m_s2 * along_m / (c_m_s * c_m_s * gamma * gamma)));
}

namespace {

/// ∫ of a rate that has kinks at those moments, in their order.
template <typename Rate>
double integralOver(const Rate& rate, double from_s, double to_s, std::initializer_list<double> kinks_s) {
  double sum_s = 0.0;
  const auto until = [&](double end_s) {
    // Just inside the interval: at a kink itself the rate is the earlier one's.
    sum_s +=
        integral([&](double t) { return rate(std::max(t, std::nextafter(from_s, end_s))); }, from_s, end_s);
    from_s = end_s;
  };
  for (const double kink_s : kinks_s) {
    if (kink_s > from_s && kink_s < to_s) until(kink_s);
  }
  until(to_s);
  return sum_s;
}

/// How long the clock of a point that goes round counts between two board times. It goes at the rate
/// sqrt(1 − w²).
double countedOnHelix_s(const VertexPiece& piece, double t_s, double c_m_s) {
  const VertexPiece::OnLeg& helix = *piece.onLeg;
  const Spin& spin = helix.knot.spin;
  const double from_s = tauAt(helix, piece.start.t_s, c_m_s), to_s = tauAt(helix, t_s, c_m_s);
  const auto rate = [&](double tau_s) {
    const double w = glm::length(betaAboard(helix, tau_s, c_m_s));
    return std::sqrt((1.0 - w) * (1.0 + w));
  };
  if (spin.slowing_1_s == 0.0) return (to_s - from_s) * rate(0.0);
  return integralOver(rate, from_s, to_s, {0.0, std::abs(spin.rim_u) / spin.slowing_1_s});
}

/// The same of a point of a body that glides, with the moments where the body turns and comes to rest.
double countedOnGlide_s(const VertexPiece& piece, double t_s, double c_m_s) {
  const Knot& knot = piece.onLeg->knot;
  const double rest_s = knot.turn.t_s + glm::length(knot.u) * c_m_s / knot.deceleration_m_s2;
  if (!glidesAndSpins(piece)) {
    const auto rate = [&](double t) { return 1.0 / gammaFromU(uAt(piece, t, c_m_s)); };
    return integralOver(rate, piece.start.t_s, t_s, {knot.turn.t_s, rest_s});
  }
  const SpinningGlide glide{*piece.onLeg, c_m_s};
  const auto rate = [&](double sigma_s) {
    const Displacement flow = glide.at(sigma_s).flow;
    return std::sqrt(std::max(interval_m2(flow, c_m_s), 0.0)) / c_m_s;
  };
  return integralOver(rate, glide.sigmaAt(piece.start.t_s), glide.sigmaAt(t_s), {knot.turn.t_s, rest_s});
}

}  // namespace

double properTimeAt(const VertexPiece& piece, double t_s, double c_m_s) {
  if (helical(piece)) return piece.properTime_s + countedOnHelix_s(piece, t_s, c_m_s);
  if (glides(piece)) return piece.properTime_s + countedOnGlide_s(piece, t_s, c_m_s);
  return piece.properTime_s + (t_s - piece.start.t_s) / gammaFromU(piece.u);
}

std::vector<VertexPiece> vertexHistory(const WorldLine& line, const Vec3& offset_m) {
  const double c_m_s = line.lightSpeed_m_s();
  const Knot& first = line.knots().front();
  std::vector<VertexPiece> history{firstPiece(first, offset_m, c_m_s)};
  for (const Knot& knot : line.knots().subspan(1)) turn(history, knot, offset_m, c_m_s);
  for (std::size_t i = 1; i < history.size(); ++i)
    history[i].properTime_s = properTimeAt(history[i - 1], history[i].start.t_s, c_m_s);

  const double zero_s = std::isfinite(line.appears_s()) ? line.appears_s() : 0.0;
  const double atZero_s = properTimeAt(pieceAt(history, zero_s), zero_s, c_m_s);
  for (VertexPiece& piece : history) piece.properTime_s -= atZero_s;
  return history;
}

namespace {

/// A leg's rest frame (where friction slows it, when it ends), its centre at the origin. Metres of light.
struct LegFrame {
  Lorentz fromBoard;
  Vec3 u{0.0};  // on the board
  Event centre;
  Event signal;  // that began the leg
};

std::vector<LegFrame> framesFrom(const WorldLine& line, std::size_t from) {
  const Knots knots = line.knots();
  std::vector<LegFrame> frames;
  for (std::size_t i = from; i < knots.size(); ++i) {
    const double end_s = (i + 1 < knots.size() ? knots[i + 1] : knots[i]).turn.t_s;
    const Motion motion = motionOnLeg(knots[i], end_s, line.lightSpeed_m_s());
    frames.push_back(
        {Lorentz::boost(-motion.u, line.lightSpeed_m_s()), motion.u, motion.event, knots[i].signal});
  }
  return frames;
}

/// The largest γ|d − x| − u·(d − x) of all |d| ≤ R, u = γβ: how far light from x has come, in the frame that
/// moves with u, when it reaches d. It is on the rim and in the plane of x and u. Between directions there Δ
/// apart it is above its chord by at most R (γ + |u|) Δ²/8, as |d − x|'' ≥ −R.
double furthestReach(const Vec3& x, const Vec3& u, double radius_m) {
  constexpr int kAround = 24;
  const double gamma = gammaFromU(u), size = glm::length(u);
  const Vec3 along = size > 0.0 ? u / size : Vec3(1.0, 0.0, 0.0);
  const double xAlong = glm::dot(x, along), xAside = glm::length(x - xAlong * along);
  double largest_m = 0.0;
  for (int k = 0; k < kAround; ++k) {
    const double around = 2.0 * std::numbers::pi * k / kAround;
    const double dAlong = radius_m * std::cos(around) - xAlong, dAside = radius_m * std::sin(around) - xAside;
    largest_m = std::max(largest_m, gamma * std::sqrt(dAlong * dAlong + dAside * dAside) - size * dAlong);
  }
  const double apart = 2.0 * std::numbers::pi / kAround;
  return largest_m + radius_m * (gamma + size) * apart * apart / 8.0;
}

// c = 1. N_m is the signal that begins leg m, A_m the event at which it reaches a point, U_q the
// four-velocity of leg q: U_q·(A_m − N_m) ≥ 0 is how far the light of N_m has come by then, in the frame of
// q. Bounds b_m(q) of that follow from each other. A point found by N_m on leg j < m, or on its way there,
// has not heard of N_i, i = j + 1, before. If it
//   rests on leg j, A_m is not later than where N_i would have found it: U_q·(A_m − N_m) ≤ the furthest that
//   N_i
//     reaches in the body + U_q·(N_i − N_m);
//   or is on its way from A_j to its place d there, at w = catchUpSpeed: in the frame of j its distance from
//   x_i
//     is at most the larger of those at both ends of its way, |x_A − x_i| and |d − x_i| ≤ R + |x_i|. Is it
//     the second, N_i finds it within that: ≤ (γ + u)(R + |x_i|) + U_q·(N_i − N_m). Else N_i finds it at most
//     τ = t_i − t_j + |x_i − x_j| after A_j, as |x_A − x_j| = t_A − t_j: ≤ b_j(q) + U_q·(N_j − N_m) + τ (γ +
//     w u).
// The last leg is caught up with from at most |x_N| + b + R away.
double boundOfJoining_s(const WorldLine& line, std::size_t from) {
  const double c_m_s = line.lightSpeed_m_s(), radius_m = line.radius_m();
  const Knots knots = line.knots();
  const Knot& knot = knots.back();
  const std::vector<LegFrame> legs = framesFrom(line, from);
  const std::size_t count = legs.size();
  // Row j: b_j(q), and what it and the bodies' rims give for all later signal, U_q·(A − N_{j+1}).
  std::vector<double> bounds(count * count, 0.0);
  const auto time_m = [&](std::size_t q, const Displacement& d) {
    return c_m_s * (legs[q].fromBoard * d).dt_s;
  };
  // In the frame of q, the latest of what the rows so far give, from the first signal on.
  std::vector<double> latest_m(count, -std::numeric_limits<double>::infinity());
  for (std::size_t m = 0; m < count; ++m) {
    for (std::size_t q = m; m > 0 && q < count; ++q)
      bounds[m * count + q] = std::max(0.0, latest_m[q] - time_m(q, legs[m].signal - legs[0].signal));
    if (m + 1 == count) break;
    const Vec3 x = (legs[m].fromBoard * (legs[m + 1].signal - legs[m].centre)).dr_m;
    const Displacement since = legs[m].fromBoard * (legs[m + 1].signal - legs[m].signal);
    const double tau_m = std::max(0.0, c_m_s * since.dt_s + glm::length(since.dr_m));
    for (std::size_t q = m + 1; q < count; ++q) {
      const Vec3 u = (legs[m].fromBoard * Displacement{gammaFromU(legs[q].u) / c_m_s, legs[q].u}).dr_m;
      const double gamma = gammaFromU(u), size = glm::length(u);
      double onLeg_m = furthestReach(x, u, radius_m);
      if (m > 0) {  // all had joined the first
        const bool isEven = !spins(knots[from + m]) && knots[from + m].deceleration_m_s2 == 0.0;
        const double w = isEven ? kCatchUpSpeed : 1.0;
        onLeg_m = std::max(onLeg_m, (gamma + size) * (radius_m + glm::length(x)));
        onLeg_m = std::max(onLeg_m, bounds[m * count + q] + time_m(q, legs[m].signal - legs[m + 1].signal) +
                                        tau_m * (gamma + w * size));
      }
      latest_m[q] = std::max(latest_m[q], onLeg_m + time_m(q, legs[m + 1].signal - legs[0].signal));
    }
  }
  const Displacement signal = legs.back().fromBoard * (knot.signal - knot.turn);
  const double found_m = bounds.back();
  const double gap_m = glm::length(signal.dr_m) + found_m + radius_m;
  return signal.dt_s + found_m / c_m_s + catchUpAtMost_s(knot, gap_m, radius_m, c_m_s);
}

/// The longest of points all around the body, `around` on the equator and a third as many half way up,
/// followed from the leg that all had joined.
double followedJoining_s(const WorldLine& line, std::size_t from, int around) {
  const int halfWay = around / 3;
  const double c_m_s = line.lightSpeed_m_s();
  const Knots knots = line.knots();
  const Knot& last = knots.back();
  const Lorentz bodyFromBoard = Lorentz::boost(-last.u, c_m_s);
  double longest_s = 0.0;
  std::vector<VertexPiece> history;
  for (int k = 0; k < around + halfWay; ++k) {
    // On the equator and half way up; motion is in the plane, so below is as above.
    const double angle_rad = 2.0 * std::numbers::pi * k / (k < around ? around : halfWay);
    const double level = k < around ? 1.0 : std::numbers::sqrt2 / 2.0;
    const Vec3 offset_m = line.radius_m() * Vec3(level * std::cos(angle_rad), level * std::sin(angle_rad),
                                                 std::sqrt(1.0 - level * level));
    history.assign(1, firstPiece(knots[from], offset_m, c_m_s));
    for (const Knot& knot : knots.subspan(from + 1)) turn(history, knot, offset_m, c_m_s);
    longest_s = std::max(longest_s, (bodyFromBoard * (history.back().start - last.turn)).dt_s);
  }
  return longest_s;
}

}  // namespace

double joinedAfter_s(const WorldLine& line) {
  // The bound costs the square of the number of legs: in a pile of pucks that press on one another hundreds
  // can come before any is joined by all points.
  constexpr std::size_t kManyLegs = 32;
  // Of faster bodies a few points can lag behind all others, for so much longer that no number of samples
  // shows it.
  constexpr double kFollowed_beta = 0.95;
  const Knots knots = line.knots();
  std::size_t from = knots.size() - 1;
  while (from > 0 && !(from + 1 < knots.size() && line.settlesBeforeNext(from))) --from;
  if (knots.size() - from > kManyLegs) return 3.0 * followedJoining_s(line, from, 12);
  const double bound_s = boundOfJoining_s(line, from);
  const bool followed =
      std::all_of(knots.begin() + static_cast<std::ptrdiff_t>(from), knots.end(), [](const Knot& knot) {
        return knot.deceleration_m_s2 == 0.0 && glm::length(betaFromU(knot.u)) <= kFollowed_beta;
      });
  return followed ? std::min(bound_s, 2.0 * followedJoining_s(line, from, 48)) : bound_s;
}

const VertexPiece& pieceAt(const std::vector<VertexPiece>& history, double t_s) {
  const auto after = std::upper_bound(history.begin() + 1, history.end(), t_s,
                                      [](double t, const VertexPiece& piece) { return t < piece.start.t_s; });
  return *(after - 1);
}

Event eventOnPastCone(const std::vector<VertexPiece>& history, const Event& observation, double c_m_s) {
  // The latest piece that begins inside the past cone.
  const auto inside = [&](const VertexPiece& piece) {
    const Displacement d = observation - piece.start;
    return d.dt_s >= 0.0 && c_m_s * d.dt_s >= glm::length(d.dr_m);
  };
  const auto firstOutside = std::partition_point(history.begin() + 1, history.end(), inside);
  return retardedEvent(*(firstOutside - 1), observation, c_m_s);
}

}  // namespace carom
