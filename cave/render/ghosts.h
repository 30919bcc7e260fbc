#pragma once
// The bodies at a moment, beside what is seen of them.

#include <span>

#include "engine/light/light_cone.h"

namespace carom {

/// The bodies at a moment, drawn as ghosts beside what is seen: each as many as the scene has, or none.
/// Viewed with ViewTime::boardNow and ViewTime::myNow; a view without legs: that body has no ghost.
struct Ghosts {
  std::span<const BodyView> boardNow, myNow;
};

}  // namespace carom
