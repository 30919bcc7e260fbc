#pragma once
// Surfaces of triangles made ready to be lit: equal points made one, all faces turned alike, normals.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace carom {

/// Returns the triangles of a mesh with equal points merged; triangles that lose a corner by that are left
/// out, as are cells that are not triangles.
vtkSmartPointer<vtkPolyData> withPointsMerged(vtkPolyData& mesh);

/// Returns the triangles with normals at their points. In each piece that hangs together by edges of just two
/// triangles, all face the side that its first one faces. A normal is the mean of those of the triangles that
/// meet in the point; where neighbours turn by more than 40°, or an edge has not just two triangles, each
/// side has points of its own.
vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData& triangles);

}  // namespace carom
