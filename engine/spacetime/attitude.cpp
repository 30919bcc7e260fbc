#include "engine/spacetime/attitude.h"

namespace carom {

glm::dquat attitudeOf(const Lorentz& boardFromRoom) {
  const glm::dmat4 rest =
      (Lorentz::boost(boardFromRoom.u(), boardFromRoom.lightSpeed_m_s()).inverse() * boardFromRoom).matrix();
  return glm::normalize(
      glm::quat_cast(glm::dmat3(Vec3(rest[1].y, rest[1].z, rest[1].w), Vec3(rest[2].y, rest[2].z, rest[2].w),
                                Vec3(rest[3].y, rest[3].z, rest[3].w))));
}

}  // namespace carom
