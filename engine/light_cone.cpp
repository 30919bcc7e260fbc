#include "engine/light_cone.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "engine/root.h"
#include "engine/vertex_history.h"

namespace carom {
namespace {

glm::dvec4 metres(const Displacement& d, double c_m_s) { return {c_m_s * d.dt_s, d.dr_m}; }

/// Can news of `knot` have been seen by the eye at all: is the observation in its causal future?
bool seenFrom(const Knot& knot, const Event& observation, double c_m_s) {
  const Displacement d = observation - knot.news;
  return d.dt_s >= 0.0 && interval_m2(d, c_m_s) >= 0.0;
}

/// The latest leg whose beginning can be seen by the eye.
std::size_t lastLeg(const WorldLine& line, const Event& observation) {
  const auto knots = line.knots();
  std::size_t i = knots.size() - 1;
  while (i > 0 && !seenFrom(knots[i], observation, line.lightSpeed_m_s())) --i;
  return i;
}

/// The centre's event on the eye's past cone if it kept to the leg of `knot` always.
Motion centreEmission(const Knot& knot, const Event& observation, double c_m_s) {
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

/// The latest leg, up to `last`, that all points had joined before they emitted the light that the eye
/// receives and before any later news: earlier legs need not be looked at.
std::size_t firstLeg(const WorldLine& line, const Event& observation, std::size_t last) {
  const double c_m_s = line.lightSpeed_m_s();
  for (std::size_t i = last; i > 0; --i) {
    const Knot& knot = line.knots()[i];
    // In the body's rest frame the earliest light that the eye receives left at most R/c before the centre's.
    const double earliest_s =
        centreEmission(knot, observation, c_m_s).properTime_s - knot.properTime_s - line.radius_m() / c_m_s;
    const bool settled = earliest_s >= line.settled_s(i);
    if (settled && (i == last || line.settlesBeforeNext(i))) return i;
  }
  return 0;
}

/// One leg as the eye sees it; `centre` is the centre's emission on it.
LegView viewLeg(const Knot& knot, const Motion& centre, const Event& observation,
                const Lorentz& headFromBoard) {
  const double c_m_s = headFromBoard.lightSpeed_m_s();
  const Lorentz boardFromBody = Lorentz::boost(centre.u, c_m_s);
  const glm::dmat4 headFromBody = glm::transpose((headFromBoard * boardFromBody).matrix());  // rows
  const Displacement centreFromEye = centre.event - observation;
  LegView leg{};
  leg.eye = (boardFromBody.inverse() * -centreFromEye).dr_m;
  leg.distance = glm::length(leg.eye);
  leg.seenCentre = (headFromBoard * centreFromEye).dr_m;
  leg.boardTime = c_m_s * centreFromEye.dt_s;
  leg.toSeenX = headFromBody[1];
  leg.toSeenY = headFromBody[2];
  leg.toSeenZ = headFromBody[3];
  leg.toBoardTime = glm::transpose(boardFromBody.matrix())[0];
  const double uTurn = glm::length(knot.u);
  if (knot.deceleration_m_s2 > 0.0 && uTurn > 0.0) {
    const double a = knot.deceleration_m_s2 / (c_m_s * c_m_s);
    const double turn_m = c_m_s * (knot.turn.t_s - centre.event.t_s);
    leg.glide = {knot.u / uTurn, a};
    leg.glideTimes = {uTurn, glm::length(centre.u), turn_m, turn_m + uTurn / a};
  }
  return leg;
}

/// How the leg follows from the previous one: the news between them, and the change of frame.
void joinLegs(const Knot& knot, const Motion& previousCentre, const Motion& centre, double c_m_s,
              LegView& leg) {
  const Lorentz boardFromPrevious = Lorentz::boost(previousCentre.u, c_m_s);
  const Lorentz thisFromBoard = Lorentz::boost(-centre.u, c_m_s);
  leg.newsInPrevious = metres(boardFromPrevious.inverse() * (knot.news - previousCentre.event), c_m_s);
  leg.originInThis = metres(thisFromBoard * (previousCentre.event - centre.event), c_m_s);
  leg.fromPrevious = (thisFromBoard * boardFromPrevious).matrix();
}

/// ν_seen/ν_emitted = (k·u_observer)/(k·u_source), with k along the light from source to observer.
double dopplerFactor(const Displacement& emissionFromEye, const Vec3& uSource, const Vec3& uObserver) {
  const double distance_m = glm::length(emissionFromEye.dr_m);
  const Vec3 k = distance_m > 0.0 ? -emissionFromEye.dr_m / distance_m : Vec3(0.0);
  return (gammaFromU(uObserver) - glm::dot(uObserver, k)) / (gammaFromU(uSource) - glm::dot(uSource, k));
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
          glm::vec4(leg.newsInPrevious),
          glm::vec4(leg.originInThis),
          glm::mat4(leg.fromPrevious),
          glm::vec4(leg.glide),
          glm::vec4(leg.glideTimes)};
}

void viewBody(const WorldLine& line, const Event& observation, const Lorentz& headFromBoard, BodyView& view) {
  const double c_m_s = line.lightSpeed_m_s();
  const auto knots = line.knots();
  const std::size_t last = lastLeg(line, observation);
  view.firstLeg = firstLeg(line, observation, last);
  view.appears_m = c_m_s * (line.appears_s() - observation.t_s);
  view.legs.clear();
  Motion previous;
  for (std::size_t i = view.firstLeg; i <= last; ++i) {
    const Motion centre = centreEmission(knots[i], observation, c_m_s);
    view.legs.push_back(viewLeg(knots[i], centre, observation, headFromBoard));
    if (i > view.firstLeg) joinLegs(knots[i], previous, centre, c_m_s, view.legs.back());
    previous = centre;
  }
}

std::optional<Emission> emission(const WorldLine& line, const Vec3& offset_m, const Event& observation,
                                 const Lorentz& headFromBoard) {
  const double c_m_s = line.lightSpeed_m_s();
  const std::vector<VertexPiece> history = vertexHistory(line, offset_m);
  Emission result;
  result.event = eventOnPastCone(history, observation, c_m_s);
  if (result.event.t_s < line.appears_s()) return std::nullopt;
  const VertexPiece& piece = pieceAt(history, result.event.t_s);
  result.seen = headFromBoard * (result.event - observation);
  result.u = uAt(piece, result.event.t_s, c_m_s);
  result.properTime_s = properTimeAt(piece, result.event.t_s, c_m_s);
  result.doppler = dopplerFactor(result.event - observation, result.u, headFromBoard.inverse().u());
  return result;
}

}  // namespace carom
