// How many faces mesh files have, without reading them whole.
#include "cave/mesh_input/mesh_size.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "app/temporary_folder.h"

namespace carom {
namespace {

using Faces = std::optional<std::uint64_t>;

TEST(MeshSize, TheFacesOfAFileAreCounted) {
  const test::TemporaryFolder folder;
  const auto faces = [&](const std::string& name, const std::string& content) {
    return facesIn(folder.file(name, content).string());
  };
  EXPECT_EQ(faces("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nelement face 1234567\nend_header\n"),
            Faces(1234567));
  EXPECT_EQ(faces("b.ply", "ply\nelement vertex 3\nend_header\nelement face 7\n"), Faces());
  EXPECT_EQ(faces("a.obj", "f 1 2 3\n  f 1 2 3\nfo 1\nv f 1\n# f 1\nf\t3 2 1\r\n\nff 1\nf\n f 1"), Faces(4));
  const std::string binary = std::string(80, ' ') + std::string("\3\0\0\0", 4) + std::string(150, '\0');
  EXPECT_EQ(faces("a.stl", binary), Faces(3));
  const std::string text =
      "solid of a text that is as long as a header has to be, which is eighty-four bytes at least\n";
  EXPECT_EQ(faces("b.stl", text + "facet normal 0 0 1\nendfacet\n facet normal 0 0 1\nendfacet\nendsolid\n"),
            Faces(2));
  EXPECT_EQ(faces("a.vtp", "<VTKFile/>"), Faces());
  EXPECT_EQ(facesIn((folder / "none.obj").string()), Faces());
}

// A line that is on both sides of a block's end counts once.
TEST(MeshSize, LinesAreCountedAcrossBlocks) {
  constexpr std::size_t kBlock = 1U << 20U;
  const test::TemporaryFolder folder;
  for (const std::size_t before : {kBlock - 2, kBlock - 1, kBlock, kBlock + 1}) {
    const std::string content = "f 1 2 3\n#" + std::string(before - 10, 'f') + "\nf 1 2 3\n";
    EXPECT_EQ(facesIn(folder.file("a.obj", content).string()), Faces(2)) << before;
  }
}

}  // namespace
}  // namespace carom
