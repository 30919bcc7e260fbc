#pragma once
// The bodies at one moment, drawn beside their seen pictures.

#include <span>

#include "engine/light/light_cone.h"

namespace carom {

/// The bodies at one moment, drawn as ghosts beside the seen picture. Each span has as many views as the
/// scene has bodies, or none; they are viewed with ViewTime::boardNow and ViewTime::myNow. A body whose view
/// has no legs has no ghost.
struct Ghosts {
  std::span<const BodyView> boardNow, myNow;
  /// How bright pucks and other bodies are as they are seen, as a share: the ghosts stand out where it is
  /// less than 1.
  float seenShare = 1.0F;
};

}  // namespace carom
