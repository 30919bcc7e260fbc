#pragma once
// One moment of a visit as a drawing: what a page shows where it cannot compute.

#include <string>

#include "app/page/visit.h"

namespace carom {

/// Returns an SVG of the table and the pucks as the viewer saw them halfway through the visit, every place
/// where its light came from. `lines` are the world lines of all bodies, as far as they are known then.
std::string stillPicture(const Visit& visit, const std::vector<WorldLine>& lines);

}  // namespace carom
