#pragma once
// The page itself: one file of HTML that holds all it needs and calls no address.

#include <string>

#include "app/page/visit.h"
#include "cave/scene/scene.h"

namespace carom {

/// Whether the program was built with the engine for browsers.
bool canMakePages();

/// Returns the page of a visit. Throws std::runtime_error that says what to install if the program was built
/// without the engine for browsers.
std::string pageOf(const Visit& visit, const Scene& scene);

}  // namespace carom
