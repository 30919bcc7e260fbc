#pragma once
// VTK's readers, filters and writers of meshes. All of it is in the library that is loaded when one is wanted
// (cave/mesh_input/mesh_library.h).

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTransform.h>

namespace carom {

/// Returns the triangles of a surface as bytes: the number of points (64 bits), the coordinates of each
/// (three floats), and the corners of each triangle (three numbers of 32 bits). Other polygons and strips are
/// cut into triangles. Throws std::runtime_error, without the file's name, if it has no polygons, a corner is
/// no point or a point is too far away.
std::string triangleBytes(vtkPolyData& surface);

/// Returns `triangleBytes` of the surface in a file of this ending (".obj"), read by VTK, which trusts its
/// files: to be called in a process of its own. What VTK says is in the error.
std::string readTriangleBytes(const std::string& path, const std::string& ending);

/// Returns the triangles of a mesh; other polygons are cut into triangles, lines and points are left out.
vtkSmartPointer<vtkPolyData> cutToTriangles(vtkPolyData& mesh);

/// Returns the mesh with its points and normals moved.
vtkSmartPointer<vtkPolyData> transformed(vtkPolyData& mesh, vtkTransform& transform);

/// Returns the mesh with each edge that is longer than this halved, so that the triangles on both sides of it
/// agree.
vtkSmartPointer<vtkPolyData> longEdgesHalved(vtkPolyData& mesh, double edge_m);

/// Returns the mesh as a text in VTK's XML (.vtp).
std::string vtpOf(vtkPolyData& mesh);

}  // namespace carom
