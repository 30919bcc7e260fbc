#pragma once
// Checks mesh files before VTK reads them: VTK's readers trust counts and indices, and do not report where a
// fault is.

#include <string>
#include <string_view>

namespace carom {

/// Checks the `content` of the file at `path`, if its ending is .obj, .stl or .vtk (other files pass):
/// every number is valid and finite, rows are complete, corners are among the points, and counts fit the
/// file's size. Throws InputError (engine/text/input_error.h) at the first fault.
void checkMeshText(const std::string& path, std::string_view ending, std::string_view content);

}  // namespace carom
