#pragma once
// The built-in puck with corners.

#include <span>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <glm/vec2.hpp>

namespace carom {

/// Returns a prism of that height over an outline, a simple polygon that runs anticlockwise around its
/// centre; its middle height is at the centre.
vtkSmartPointer<vtkPolyData> prismOver(std::span<const glm::dvec2> corners_m, double height_m);

}  // namespace carom
