#pragma once
// The content of a page as its script takes it: a description in JSON, and columns of numbers.

#include <string>

#include "app/page/visit.h"
#include "cave/scene/scene.h"

namespace carom {

/// Returns the bytes: the length of the JSON (four bytes, the lowest first), the JSON, the columns. They hold
/// the visit and nothing else of the session, of this machine or of its people. `scene` is the visit's, with
/// its light.
std::string pageContent(const Visit& visit, const Scene& scene);

}  // namespace carom
