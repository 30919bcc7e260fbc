// large_mesh RINGS FILE: writes a mesh of 4 RINGS² triangles as .ply or, if FILE ends so, as .glb; 1120 make
// five million.
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cave/bumpy_sphere.h"

namespace {

void append(std::string& to, std::uint32_t word) {
  to.append(reinterpret_cast<const char*>(&word), sizeof word);
}

/// Returns the same mesh as binary glTF (glTF 2.0, section 4.4): corners and vertices in one buffer.
std::string glbOf(const std::string& ply, std::size_t vertices, std::size_t triangles) {
  constexpr std::size_t kVertex = 12,
                        kFace = 13;  // bytes; a face of a PLY begins with how many corners it has
  constexpr std::string_view kHeaderEnd = "end_header\n";
  const std::size_t places = ply.find(kHeaderEnd) + kHeaderEnd.size(), faces = places + kVertex * vertices;
  std::string data = ply.substr(places, kVertex * vertices);
  for (std::size_t i = 0; i < triangles; ++i) data += ply.substr(faces + kFace * i + 1, kFace - 1);
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
      R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{0},"type":"VEC3",)"
      R"("min":[-0.51,-0.51,-0.51],"max":[0.51,0.51,0.51]}},)"
      R"({{"bufferView":1,"componentType":5125,"count":{1},"type":"SCALAR"}}],)"
      R"("bufferViews":[{{"buffer":0,"byteLength":{2}}},{{"buffer":0,"byteOffset":{2},"byteLength":{3}}}],)"
      R"("buffers":[{{"byteLength":{4}}}]}})",
      vertices, 3 * triangles, kVertex * vertices, 12 * triangles, data.size());
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string glb = "glTF";
  append(glb, 2);
  append(glb, static_cast<std::uint32_t>(28 + json.size() + data.size()));
  append(glb, static_cast<std::uint32_t>(json.size()));
  glb += "JSON" + json;
  append(glb, static_cast<std::uint32_t>(data.size()));
  return glb + std::string("BIN\0", 4) + data;
}

}  // namespace

int main(int argc, char** argv) {
  const int rings = argc == 3 ? std::atoi(argv[1]) : 0;
  if (rings < 1 || rings > 2000) {
    std::cerr << "usage: large_mesh RINGS FILE, with 1 to 2000 rings and a file .ply or .glb\n";
    return 2;
  }
  const std::string_view name = argv[2];
  const auto count = static_cast<std::size_t>(rings);
  std::string mesh = carom::test::bumpySphere(rings);
  if (name.ends_with(".glb")) mesh = glbOf(mesh, 2 * count * (count + 1), 4 * count * count);
  std::ofstream file(argv[2], std::ios::binary);
  file << mesh << std::flush;
  return file ? 0 : 1;
}
