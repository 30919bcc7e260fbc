// The further files that a glTF names.
#include "cave/mesh_input/mesh_buffers.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/temporary_folder.h"
#include "engine/text/input_error.h"

namespace carom {
namespace {

using Paths = std::vector<std::filesystem::path>;

const std::string kJson =
    R"({"asset":{"uri":"no.bin"},"buffers":[{"uri":"one.bin","extras":{"uri":"deep.bin"}},)"
    R"({"uri":"data:application/octet-stream;base64,AAAA"},{"byteLength":4}],"nodes":[{"uri":"node.bin"}],)"
    R"("images":[{"name":"a","uri":"pictures/two.png"}]})";

/// The content as the first chunk of a .glb, with a second one.
std::string glbOf(const std::string& json) {
  std::string bytes = "glTF";
  const auto put = [&](std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8U * i) & 0xffU);
  };
  put(2);
  put(static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + 4));
  put(static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  put(4);
  return bytes + std::string("BIN\0", 4) + R"({"b)";
}

TEST(MeshBuffers, BuffersAndPicturesAreNamedBesideTheMesh) {
  const Paths expected{"/rooms/one.bin", "/rooms/pictures/two.png"};
  EXPECT_EQ(meshParts("/rooms/a.gltf", kJson), expected);
  EXPECT_EQ(meshParts("/rooms/a.GLB", glbOf(kJson)), expected);
  EXPECT_EQ(meshParts("/rooms/a.obj", kJson), Paths());
  EXPECT_EQ(meshParts("/rooms/a.gltf", "glTF"), Paths());
}

std::string faultOfParts(const std::filesystem::path& mesh, const std::string& content) {
  try {
    checkMeshParts(mesh, content);
  } catch (const InputError& fault) {
    EXPECT_EQ(fault.file(), mesh.string());
    EXPECT_EQ(fault.line(), 1);
    return fault.message();
  }
  return "nothing is wrong";
}

TEST(MeshBuffers, PartsLieBelowTheFolderOfTheMesh) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "room/parts");
  folder.file("outside.bin", "x");
  folder.file("room/parts/inside.bin", "x");
  std::filesystem::create_symlink(folder / "outside.bin", folder / "room/link.bin");
  const auto said = [&](const std::string& uri) {
    return faultOfParts(folder / "room/a.gltf", R"({"buffers":[{"uri":")" + uri + R"("}]})");
  };
  EXPECT_EQ(said("parts/inside.bin"), "nothing is wrong");
  EXPECT_EQ(said("parts/../parts/inside.bin"), "nothing is wrong");
  for (const std::string uri : {"../outside.bin", "link.bin", "parts/../../outside.bin"}) {
    const std::string heard = said(uri);
    EXPECT_TRUE(heard.starts_with("it names '" + uri + "', which is ")) << heard;
    EXPECT_NE(heard.find("expected files below this folder"), std::string::npos) << heard;
  }
  EXPECT_TRUE(said("none.bin").starts_with("it names 'none.bin': ")) << said("none.bin");
  EXPECT_TRUE(said("parts").starts_with("it names 'parts': ")) << said("parts");
}

TEST(MeshBuffers, WhatIsNestedTooDeepIsRefused) {
  const auto nested = [](std::size_t depth) {
    return "{\"x\":" + std::string(depth - 1, '[') + std::string(depth - 1, ']') + "}";
  };
  EXPECT_EQ(faultOfParts("a.gltf", nested(64)), "nothing is wrong");
  EXPECT_EQ(faultOfParts("a.gltf", nested(65)), "values are nested too deep, expected at most 64");
  EXPECT_EQ(faultOfParts("a.gltf", nested(1000000)), "values are nested too deep, expected at most 64");
  EXPECT_EQ(faultOfParts("a.obj", nested(65)), "nothing is wrong");
}

}  // namespace
}  // namespace carom
