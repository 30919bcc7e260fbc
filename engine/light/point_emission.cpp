#include "engine/light/point_emission.h"

namespace carom {

double dopplerFactor(const Displacement& emissionFromEye, const Vec3& uSource, const Vec3& uObserver) {
  const double distance_m = glm::length(emissionFromEye.dr_m);
  const Vec3 k = distance_m > 0.0 ? -emissionFromEye.dr_m / distance_m : Vec3(0.0);
  return (gammaFromU(uObserver) - glm::dot(uObserver, k)) / (gammaFromU(uSource) - glm::dot(uSource, k));
}

PointEmission::PointEmission(const WorldLine& line, const Vec3& offset_m)
    : c_m_s_(line.lightSpeed_m_s()), appears_s_(line.appears_s()), history_(vertexHistory(line, offset_m)) {}

std::optional<Emission> PointEmission::seenAt(const Event& observation, const Lorentz& headFromBoard) const {
  Emission result;
  result.event = eventOnPastCone(history_, observation, c_m_s_);
  if (result.event.t_s < appears_s_) return std::nullopt;
  const VertexPiece& piece = pieceAt(history_, result.event.t_s);
  result.seen = headFromBoard * (result.event - observation);
  result.u = uAt(piece, result.event.t_s, c_m_s_);
  result.properTime_s = properTimeAt(piece, result.event.t_s, c_m_s_);
  result.doppler = dopplerFactor(result.event - observation, result.u, headFromBoard.inverse().u());
  return result;
}

// Declared in light_cone.h.
std::optional<Emission> emission(const WorldLine& line, const Vec3& offset_m, const Event& observation,
                                 const Lorentz& headFromBoard) {
  return PointEmission(line, offset_m).seenAt(observation, headFromBoard);
}

}  // namespace carom
