#pragma once
// A head whose eyes are all at one place.

#include "engine/light_speed.h"
#include "engine/spacetime/observer.h"

namespace carom::test {

inline ObserverView observerAt(const Event& head, const Lorentz& headFromBoard = Lorentz(kC_m_s)) {
  const EyeView eye{head, Vec3(0.0), Vec3(0.0)};
  return {headFromBoard, eye, eye, eye, 0.0};
}

}  // namespace carom::test
