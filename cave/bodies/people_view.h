#pragma once
// The people of another room as one eye sees them: which way their bodies are drawn.

#include <array>
#include <cstddef>
#include <span>

#include "cave/scene/scene.h"
#include "engine/base/limits.h"
#include "engine/light/light_cone.h"
#include "engine/linked/told_path.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// Those whose light the eye receives.
struct SeenPeople {
  std::array<ToldView, kMostViewers> people;
  std::size_t count = 0;
  std::span<const ToldView> all() const { return std::span(people).first(count); }
};

/// Fills the views of all bodies of people in `bodies`, which are those of the scene, for one eye; a body
/// without legs is not seen. Each is viewed as if it had always moved as it does where its middle is seen:
/// people are not rigid, and how the rest of them moved was not told. Without retardation they stand where
/// they were last told of. The result is valid until the paths change.
SeenPeople viewPeople(const Scene& scene, std::span<const ToldPath> paths, const Switches& switches,
                      const ObserverView& observer, const EyeView& eye, std::span<BodyView> bodies);

}  // namespace carom
