#include "engine/light/light_cone.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "engine/base/portable_math.h"
#include "engine/base/root.h"
#include "engine/light/spin_steps.h"
#include "engine/light/vertex_history.h"

namespace carom {
namespace {

glm::dvec4 metres(const Displacement& d, double c_m_s) { return {c_m_s * d.dt_s, d.dr_m}; }

/// What a view asks of a world line: which event of each point.
struct ViewQuery {
  Event observation;
  Lorentz headFromBoard;
  Switches switches;
  ViewTime moment;

  /// The head's time of an event, from the observation.
  double headTime_s(const Event& event) const { return (headFromBoard * (event - observation)).dt_s; }
};

/// At a moment there is no retardation; bodies at the head's moment are contracted.
ViewQuery viewQueryOf(const Event& observation, const Lorentz& headFromBoard, Switches switches,
                      ViewTime moment) {
  if (moment == ViewTime::seen && !switches.retardation) moment = ViewTime::boardNow;
  if (moment != ViewTime::seen) switches.retardation = 0;
  if (moment == ViewTime::myNow) switches.contraction = 1;
  return {observation, headFromBoard, switches, moment};
}

/// Can any point of the body be seen on the leg of `knot`: has its signal come, or without contraction its
/// turn?
bool mayBeSeenOn(const Knot& knot, const WorldLine& line, const ViewQuery& ask) {
  const Displacement d = ask.observation - (ask.switches.contraction ? knot.signal : knot.turn);
  if (ask.moment == ViewTime::myNow) return ask.headTime_s(knot.signal) <= 0.0;
  if (ask.moment == ViewTime::boardNow) return d.dt_s >= 0.0;
  const double reach_m = line.lightSpeed_m_s() * d.dt_s + (ask.switches.contraction ? 0.0 : line.radius_m());
  return reach_m >= glm::length(d.dr_m) && d.dt_s >= 0.0;
}

/// The latest leg that can be seen by the eye.
std::size_t lastLeg(const WorldLine& line, const ViewQuery& ask) {
  const auto knots = line.knots();
  std::size_t i = knots.size() - 1;
  while (i > 0 && !mayBeSeenOn(knots[i], line, ask)) --i;
  return i;
}

/// The centre at the head's time of the observation if it kept to the leg of `knot` always.
Motion centreAtHeadsMoment(const Knot& knot, const ViewQuery& ask, double c_m_s) {
  const Motion begin = motionOnLeg(knot, ask.observation.t_s, c_m_s);
  // The head's time grows by (γ_h γ − u_h·u)/γ in a second of the board's on a straight leg.
  const Displacement flow = ask.headFromBoard * Displacement{1.0, c_m_s * betaFromU(begin.u)};
  const double straight_s = ask.observation.t_s - ask.headTime_s(begin.event) / flow.dt_s;
  if (knot.deceleration_m_s2 == 0.0) return motionOnLeg(knot, straight_s, c_m_s);
  const auto headTime_s = [&](double t_s) { return ask.headTime_s(motionOnLeg(knot, t_s, c_m_s).event); };
  return motionOnLeg(knot, rootOfIncreasing(headTime_s, straight_s), c_m_s);
}

/// The centre's event on the eye's past cone, or at the moment asked for, if it kept to the leg of `knot`
/// always.
Motion centreEmission(const Knot& knot, const ViewQuery& ask, double c_m_s) {
  const Event& observation = ask.observation;
  if (ask.moment == ViewTime::myNow) return centreAtHeadsMoment(knot, ask, c_m_s);
  if (ask.moment == ViewTime::boardNow) return motionOnLeg(knot, observation.t_s, c_m_s);
  if (knot.deceleration_m_s2 > 0.0) {
    const double t_s = rootOfIncreasing(
        [&](double t) {
          return glm::length(observation.r_m - motionOnLeg(knot, t, c_m_s).event.r_m) -
                 c_m_s * (observation.t_s - t);
        },
        observation.t_s);
    return motionOnLeg(knot, t_s, c_m_s);
  }
  const Lorentz boardFromBody = Lorentz::boost(knot.u, c_m_s);
  const Displacement eye = boardFromBody.inverse() * (observation - knot.turn);
  const double distance_s = glm::length(eye.dr_m) / c_m_s;
  return {observation + boardFromBody * Displacement{-distance_s, -eye.dr_m}, knot.u,
          knot.properTime_s + eye.dt_s - distance_s, 0};
}

/// Had all points joined the leg before the events that are shown, and before later signal?
bool allJoined(const WorldLine& line, std::size_t leg, const Motion& centre, bool isLast,
               const ViewQuery& ask) {
  const Switches& switches = ask.switches;
  const Knot& knot = line.knots()[leg];
  const double radius_s = line.radius_m() / line.lightSpeed_m_s();
  if (!switches.contraction) {
    // Board times of points differ from the centre's by at most (R/c)/(1 − β) = (R/c) γ(γ + u).
    const double gamma = gammaFromU(knot.u);
    const double spread_s = switches.retardation ? radius_s * gamma * (gamma + glm::length(knot.u)) : 0.0;
    return centre.event.t_s - spread_s >= knot.turn.t_s;
  }
  // In the body's rest frame the earliest light that the eye receives left at most R/c before the centre's;
  // and events of it that are simultaneous in some frame are at most R/c apart there.
  const double earliest_s = centre.properTime_s - knot.properTime_s - radius_s;
  return earliest_s >= line.settled_s(leg) && (isLast || line.settlesBeforeNext(leg));
}

/// The latest leg, up to `last`, that all points had joined: earlier ones need not be looked at.
std::size_t firstLeg(const WorldLine& line, std::size_t last, const ViewQuery& ask) {
  for (std::size_t i = last; i > 0; --i) {
    const Motion centre = centreEmission(line.knots()[i], ask, line.lightSpeed_m_s());
    if (allJoined(line, i, centre, i == last, ask)) return i;
  }
  return 0;
}

/// Had friction stopped the body before any event of its points on the leg of `knots[leg]` that matters, if
/// it is the first that is looked at? Those that are shown differ from the centre's by at most R/c where the
/// body rests, and all that later signal has to do with comes after that.
bool restsForGood(Knots knots, std::size_t leg, const Motion& centre, double radius_s, double c_m_s) {
  const Knot& knot = knots[leg];
  const double rests_s = knot.turn.t_s + glm::length(knot.u) * c_m_s / knot.deceleration_m_s2;
  return centre.event.t_s - radius_s >= rests_s &&
         (leg + 1 == knots.size() || knots[leg + 1].signal.t_s >= rests_s);
}

/// Tells the kernel what it needs to know of a spin.
void setSpin(const Knot& knot, const Motion& centre, double radius_m, double c_m_s, LegView& leg) {
  if (!spins(knot)) return;
  const Spin& spin = knot.spin;
  const double own_s = centre.properTime_s - knot.properTime_s;
  const SinCos angle = portableSinCos(angleAfter(spin, own_s));
  const double turn_1_m = spin.omega_rad_s / c_m_s;
  leg.spin = {turn_1_m, angle.cos, angle.sin,
              std::abs(turn_1_m) * radius_m <= 0.99 ? kFewSpinSteps : kMostSpinSteps};
  if (spin.slowing_1_s == 0.0 || spin.rim_u == 0.0) return;
  leg.spin.x = turn_1_m * std::sqrt(1.0 + spin.rim_u * spin.rim_u) / spin.rim_u;  // 1/R
  leg.spinSlows = {rimUAfter(spin, own_s), std::copysign(spin.slowing_1_s / c_m_s, spin.rim_u),
                   -c_m_s * own_s, c_m_s * (std::abs(spin.rim_u) / spin.slowing_1_s - own_s)};
}

/// One leg as the eye sees it; `centre` is the centre's emission on it.
LegView viewLeg(const Knot& knot, const Motion& centre, const ViewQuery& ask, const Lorentz& seenFromBoard,
                bool glides, double radius_m) {
  const double c_m_s = seenFromBoard.lightSpeed_m_s();
  const Lorentz boardFromBody = Lorentz::boost(centre.u, c_m_s);
  const bool rigid = !ask.switches.retardation && !ask.switches.contraction;
  const Lorentz seenFromLeg = rigid ? seenFromBoard : seenFromBoard * boardFromBody;
  const glm::dmat4 rows = glm::transpose(seenFromLeg.matrix());
  const Displacement centreFromEye = centre.event - ask.observation;
  LegView leg{};
  leg.eye = (boardFromBody.inverse() * -centreFromEye).dr_m;
  leg.distance = glm::length(leg.eye);
  leg.seenCentre = (seenFromBoard * centreFromEye).dr_m;
  leg.boardTime = c_m_s * centreFromEye.dt_s;
  leg.toSeenX = rows[1];
  leg.toSeenY = rows[2];
  leg.toSeenZ = rows[3];
  leg.toBoardTime = glm::transpose(boardFromBody.matrix())[0];
  leg.toMoment = ask.moment == ViewTime::myNow
                     ? glm::transpose((ask.headFromBoard * boardFromBody).matrix())[0]
                     : leg.toBoardTime;
  const double turn_m = c_m_s * (knot.turn.t_s - centre.event.t_s);
  leg.glideTimes.z = turn_m;
  const double uTurn = glm::length(knot.u);
  if (glides) {
    const double a = knot.deceleration_m_s2 / (c_m_s * c_m_s);
    leg.glide = {knot.u / uTurn, a};
    leg.glideTimes = {uTurn, glm::length(centre.u), turn_m, turn_m + uTurn / a};
  }
  setSpin(knot, centre, radius_m, c_m_s, leg);
  return leg;
}

/// How the leg follows from the previous one: the signal between them, and the change of frame.
void joinLegs(const Knot& knot, const Motion& previousCentre, const Motion& centre, double c_m_s,
              LegView& leg) {
  const Lorentz boardFromPrevious = Lorentz::boost(previousCentre.u, c_m_s);
  const Lorentz thisFromBoard = Lorentz::boost(-centre.u, c_m_s);
  leg.signalInPrevious = metres(boardFromPrevious.inverse() * (knot.signal - previousCentre.event), c_m_s);
  leg.originInThis = metres(thisFromBoard * (previousCentre.event - centre.event), c_m_s);
  leg.fromPrevious = (thisFromBoard * boardFromPrevious).matrix();
}

}  // namespace

kernel_float::LegView toFloat(const LegView& leg) {
  return {glm::vec3(leg.eye),
          static_cast<float>(leg.distance),
          glm::vec3(leg.seenCentre),
          static_cast<float>(leg.boardTime),
          glm::vec4(leg.toSeenX),
          glm::vec4(leg.toSeenY),
          glm::vec4(leg.toSeenZ),
          glm::vec4(leg.toBoardTime),
          glm::vec4(leg.signalInPrevious),
          glm::vec4(leg.originInThis),
          glm::mat4(leg.fromPrevious),
          glm::vec4(leg.glide),
          glm::vec4(leg.glideTimes),
          glm::vec4(leg.toMoment),
          glm::vec4(leg.spin),
          glm::vec4(leg.spinSlows)};
}

ViewFrame::ViewFrame(const Lorentz& headFromBoard, const Switches& switches, ViewTime moment)
    : seenFromBoard(headFromBoard),
      drawnFromSeen(headFromBoard.lightSpeed_m_s()),
      drawnFromBoard(headFromBoard) {
  // A transform is a rotation, then a boost by the velocity that the board has in the head's frame.
  const Lorentz headFromTurned = Lorentz::boost(headFromBoard.u(), headFromBoard.lightSpeed_m_s());
  const Lorentz turnedFromBoard = headFromTurned.inverse() * headFromBoard;
  if (!switches.aberration) drawnFromBoard = turnedFromBoard;
  if (!switches.aberration) seenFromBoard = turnedFromBoard;
  const bool boardNow = moment == ViewTime::boardNow || (moment == ViewTime::seen && !switches.retardation);
  if (!switches.aberration || !boardNow) return;
  seenFromBoard = turnedFromBoard;
  drawnFromSeen = headFromTurned;
}

void viewBody(const WorldLine& line, const Event& observation, const Lorentz& headFromBoard, BodyView& view,
              const Switches& switches, ViewTime moment) {
  const double c_m_s = line.lightSpeed_m_s();
  const auto knots = line.knots();
  const ViewQuery ask = viewQueryOf(observation, headFromBoard, switches, moment);
  const Lorentz seenFromBoard = ViewFrame(headFromBoard, ask.switches, ask.moment).seenFromBoard;
  const std::size_t last = lastLeg(line, ask);
  view.retarded = ask.switches.retardation != 0;
  view.contracted = ask.switches.contraction != 0;
  view.firstLeg = firstLeg(line, last, ask);
  view.appears_m = c_m_s * (line.appears_s() - observation.t_s);
  view.legs.clear();
  Motion previous;
  for (std::size_t i = view.firstLeg; i <= last; ++i) {
    const Motion centre = centreEmission(knots[i], ask, c_m_s);
    const bool first = i == view.firstLeg;
    const bool glides = knots[i].deceleration_m_s2 > 0.0 && knots[i].u != Vec3(0.0) &&
                        !(first && restsForGood(knots, i, centre, line.radius_m() / c_m_s, c_m_s));
    view.legs.push_back(viewLeg(knots[i], centre, ask, seenFromBoard, glides, line.radius_m()));
    if (first && !glides) view.legs.back().glideTimes.z = 0.0;  // of no use: it reaches back without end
    if (!first) joinLegs(knots[i], previous, centre, c_m_s, view.legs.back());
    previous = centre;
  }
}

kernel::VertexEmission emissionIn(const BodyView& view, const Vec3& offset_m) {
  return kernel::solveEmission(view.legs.data(), static_cast<int>(view.legs.size()), offset_m, view.retarded,
                               view.contracted);
}

Motion centreSeen(const WorldLine& line, const Event& observation, const Switches& switches) {
  const double c_m_s = line.lightSpeed_m_s();
  const ViewQuery ask = viewQueryOf(observation, Lorentz(c_m_s), switches, ViewTime::seen);
  const auto knots = line.knots();
  for (std::size_t i = knots.size() - 1; i > 0; --i) {
    Motion centre = centreEmission(knots[i], ask, c_m_s);
    centre.leg = i;
    if (centre.event.t_s >= knots[i].turn.t_s) return centre;
  }
  return centreEmission(knots.front(), ask, c_m_s);
}

}  // namespace carom
