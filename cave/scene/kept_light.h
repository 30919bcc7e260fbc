#pragma once
// Baked light that is kept from one session to the next and handed from node to node: where many nodes share
// a machine, and on every machine with a fine scene, baking is most of what a session needs to begin.

#include <filesystem>
#include <string>
#include <string_view>

#include "cave/scene/scene.h"

namespace carom {

/// Gives the scene its light as bakeLight does: from a file of `folder` if this program has baked the same
/// scene before; otherwise it bakes the light and keeps it there. Of the kept files, the sixteen that were
/// used last stay. A folder that cannot be used and a file that is not whole cost time only.
void lightScene(Scene& scene, const std::filesystem::path& folder);

/// Returns the light of a lit scene and what it is the light of.
std::string lightOf(const Scene& scene);

/// Gives the scene a light that lightOf has returned. Returns false if it is the light of another scene.
bool setLight(Scene& scene, std::string_view light);

/// Returns the user's folder for kept light, as the XDG Base Directory Specification has it; without a home,
/// an empty path, where nothing is kept.
std::filesystem::path folderOfLight();

}  // namespace carom
