#include "engine/light/row_eye.h"

#include "engine/light/emission_kernel.h"

namespace carom {

RowEye::RowEye(const Event& observation, const Lorentz& headFromBoard, const Switches& switches,
               ViewTime moment)
    : observation_(observation),
      kind_(moment == ViewTime::myNow                               ? Kind::myNow
            : moment == ViewTime::boardNow || !switches.retardation ? Kind::boardNow
                                                                    : Kind::seen),
      isContracted_(switches.contraction || moment == ViewTime::myNow),
      isAberrated_(switches.aberration != 0),
      frame_(headFromBoard, switches, moment),
      headBeta_(betaFromU(headFromBoard.inverse().u())) {}

bool RowEye::isAtOrAfter(double time_m, const Vec3& fromEye_m) const {
  if (kind_ == Kind::seen) return time_m <= 0.0 && time_m * time_m >= glm::dot(fromEye_m, fromEye_m);
  if (kind_ == Kind::boardNow) return time_m <= 0.0;
  return time_m <= glm::dot(headBeta_, fromEye_m);
}

double RowEye::shareOf(double time_m, const Vec3& from_m, double step_m, const Vec3& way_m) const {
  if (kind_ == Kind::boardNow) return -time_m / step_m;
  if (kind_ == Kind::myNow)
    return (glm::dot(headBeta_, from_m) - time_m) / (step_m - glm::dot(headBeta_, way_m));
  const double distance = glm::length(from_m);
  const double A = step_m * step_m - glm::dot(way_m, way_m);
  const double B = glm::dot(from_m, way_m) - time_m * step_m;
  const double C = (distance + time_m) * (time_m - distance);
  return C / (B + std::sqrt(std::max(0.0, B * B - A * C)));
}

Vec3 RowEye::drawn(double boardTime_m, const Vec3& fromEye_m) const {
  const double c = frame_.seenFromBoard.lightSpeed_m_s();
  return drawnAtSeen((frame_.seenFromBoard * Displacement{boardTime_m / c, fromEye_m}).dr_m);
}

Vec3 RowEye::drawnAtSeen(const Vec3& seen) const {
  if (kind_ != Kind::boardNow || !isAberrated_) return seen;
  return kernel::rayThrough(frame_.drawnFromSeen.matrix(), seen);
}

}  // namespace carom
