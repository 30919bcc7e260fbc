#pragma once
// Reads the names of the bodies that Qualisys Track Manager tracks.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Returns the names of the bodies in QTM's order, from its XML answer to "GetParameters 6D"; none if that is
/// no XML, or has a document type, more than 4096 bodies, or elements more than 64 deep. A body without a
/// name has an empty one. A name has at most 100 bytes; the rest is cut off.
std::optional<std::vector<std::string>> readQtmBodies(std::string_view xml);

}  // namespace carom
