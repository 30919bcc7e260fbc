#pragma once
// Reads Stanford PLY: a header that says which elements follow and how many, then their rows, as text or
// binary.

#include <string>
#include <string_view>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace carom {

/// Returns the points and faces in the `content` of the file at `path`. Throws InputError
/// (engine/text/input_error.h) at the first fault: a number that is none or not finite, a row that is cut
/// off, a corner that is no point, a count that the file has no room for.
vtkSmartPointer<vtkPolyData> readPly(const std::string& path, std::string_view content);

}  // namespace carom
