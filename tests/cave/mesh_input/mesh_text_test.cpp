// Meshes as text are checked before VTK reads them.
#include "cave/mesh_input/mesh_text.h"

#include <gtest/gtest.h>

#include <string>

#include "engine/text/input_error.h"

namespace carom {
namespace {

/// What is wrong with the content of a file of this ending, behind its name.
std::string faultOf(const std::string& ending, const std::string& content) {
  try {
    checkMeshText("mesh" + ending, ending, content);
  } catch (const InputError& fault) {
    EXPECT_EQ(fault.file(), "mesh" + ending);
    return std::string(fault.what()).substr(fault.file().size());
  }
  return "nothing is wrong";
}

#define EXPECT_FAULT(ending, content, said) \
  EXPECT_TRUE(faultOf(ending, content).starts_with(said)) << faultOf(ending, content) << "\nof " << (content)

TEST(MeshText, CornersOfAnObjNameWhatIsThere) {
  const std::string points = "v 0 0 0\nv 1 0 0 1.0\nvt 0.5\nvn 0 0 1\nv 0 1 0\n";
  // From 1, back from the latest, with places of pictures and normals; a face may come before its points.
  for (const char* const face : {"f 1 2 3", "f -3 -2 -1", "f 1/1/1 2//1 3/1", "l 1 2", "p 3", "# f 9 9 9"})
    EXPECT_EQ(faultOf(".obj", points + face + "\n"), "nothing is wrong") << face;
  EXPECT_EQ(faultOf(".obj", "f 1 2 3\n" + points), "nothing is wrong");
  EXPECT_FAULT(".obj", points + "f 1 2 4\n", ":6:7: '4' names one of 3 that there are");
  EXPECT_FAULT(".obj", points + "f 1/1 2/2 3/1\n", ":6:9: '2' names one of 1 that there are");
  EXPECT_FAULT(".obj", points + "f 1 2 -4\n", ":6:7: '-4' is wrong, expected an index from -3");
  EXPECT_FAULT(".obj", points + "f 0 1 2\n", ":6:3: index 0 is wrong, expected one from 1");
  EXPECT_FAULT(".obj", points + "f 1/1/1/1 2 3\n", ":6:3: '1/1/1/1' is no corner");
  EXPECT_FAULT(".obj", points + "l 1\n", ":6:4: something is missing here");
}

TEST(MeshText, AnStlHasFacetsOfThreeVertices) {
  const std::string facet =
      "facet normal x y z\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  EXPECT_EQ(faultOf(".stl", "solid\n" + facet + facet + "endsolid\n"), "nothing is wrong");
  EXPECT_FAULT(".stl", "solid name\n" + facet, ":9:1: this STL ends before its endsolid");
  EXPECT_FAULT(".stl", "solid\n" + facet + "vortex 1 2 3\n", ":9:1: 'vortex' is wrong, expected facet");
  EXPECT_FAULT(".stl", "solid\nfacet\nvertex 0 0 0\nendfacet\n",
               ":4:1: this facet has 1 vertices, expected 3");
  // As bytes: a header, a count and 50 bytes for each triangle.
  const std::string two = std::string(80, 's') + std::string("\2\0\0\0", 4) + std::string(100, '\0');
  EXPECT_EQ(faultOf(".stl", two), "nothing is wrong");
  EXPECT_FAULT(".stl", two + "x", ":1:1: this STL says it has 2 triangles, 184 bytes, and is 185 bytes long");
}

TEST(MeshText, AVtkFileHasTheCornersThatItCounts) {
  const std::string head =
      "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0\n0 1 0\n";
  EXPECT_EQ(faultOf(".vtk", head + "POLYGONS 1 4\n3 0 1 2\n"), "nothing is wrong");
  EXPECT_FAULT(".vtk", head + "POLYGONS 1 4\n3 0 1 3\n",
               ":9:7: '3' is wrong, expected the index of a point from 0 to 2");
  EXPECT_FAULT(".vtk", head + "POLYGONS 1 5\n3 0 1 2\n", ":8:1: 1 rows hold 4 numbers, expected 5");
  EXPECT_FAULT(".vtk", head + "POLYGONS 2 8\n3 0 1 2\n", ":10:1: something is missing here");
  // Version 5 counts in two lists.
  const std::string lists = "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 ";
  EXPECT_EQ(faultOf(".vtk", head + lists + "2\n"), "nothing is wrong");
  EXPECT_FAULT(".vtk", head + lists + "3\n",
               ":12:5: '3' is wrong, expected the index of a point from 0 to 2");
  EXPECT_FAULT(".vtk", "# vtk DataFile Version 3.0\ntitle\nTEXT\n", ":3:1: 'TEXT' is wrong, expected ASCII");
}

}  // namespace
}  // namespace carom
