#pragma once
// Looks through mesh files before VTK reads them: its readers trust counts and indices, and do not say where
// a fault is.

#include <string>
#include <string_view>

namespace carom {

/// The `content` of the file at `path`, whose ending is .obj, .stl, .ply or .vtk (others are passed): numbers
/// are numbers and finite, rows are whole, corners are among the points, counts fit the file's size. Throws
/// InputError (engine/base/input_error.h) at the first fault.
void checkMeshText(const std::string& path, std::string_view ending, std::string_view content);

}  // namespace carom
