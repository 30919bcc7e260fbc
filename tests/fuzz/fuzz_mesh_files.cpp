// Files of calibration programs of anything: the first byte chooses the format. What can be read can be
// drawn.

#include <cmath>
#include <stdexcept>
#include <string>

#include "cave/mesh_files/measured.h"
#include "cave/mesh_files/screen_file.h"
#include "cave/mesh_files/vwf_file.h"
#include "cave/warps/warp_formats.h"
#include "fuzz/expect.h"

namespace carom {
namespace {

void expectSound(const Warp& warp) {
  for (const WarpMesh* mesh : {&warp.left, &warp.right}) {
    for (const auto& corners : mesh->triangles) {
      for (const std::uint32_t corner : corners)
        test::expect(corner < mesh->points.size(), "corners are points");
    }
    for (const WarpPoint& point : mesh->points)
      test::expect(std::isfinite(point.inWindow.x + point.inWindow.y + point.inPicture.x + point.inPicture.y),
                   "points are somewhere");
  }
}

/// Makes the screen as a rig does, which may refuse it.
void make(const std::string& ending, const std::string& content) {
  MeasuredScreen screen;
  screen.file = "given" + ending;
  screen.bytes = std::make_shared<const std::string>(content);
  const CurvedScreen made = screenOf(screen, {.window_px = {320, 200}});
  for (const ScreenTriangle& triangle : made.mesh) {
    for (const ScreenPoint& point : triangle) {
      test::expect(std::isfinite(point.inRoom_m.x + point.inRoom_m.y + point.inRoom_m.z),
                   "screens are somewhere");
      test::expect(point.inWindow.x >= -1e-5 && point.inWindow.x <= 1.0 + 1e-5, "screens are in the window");
    }
  }
}

void read(char kind, const std::string& content) {
  if (kind == 'o') expectSound(parseObjWarp(content));
  if (kind == 'p') expectSound(parsePfmWarp(content));
  if (kind == 'c') expectSound(parseCsvWarp(content));
  if (kind == 's') expectSound(parseSimcadWarp(content));
  if (kind == 'g') expectSound(parseSgcWarp(content));
  if (kind == 'b') expectSound(parseBourkeWarp(content, {4, 3}));
  if (kind == 'v') expectSound(warpOf(parseVwf(content)));
  if (kind == 'O') make(".obj", content);
  if (kind == 'P') make(".pfm", content);
  if (kind == 'V') make(".vwf", content);
}

}  // namespace
}  // namespace carom

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  try {
    carom::read(static_cast<char>(bytes[0]), {reinterpret_cast<const char*>(bytes) + 1, size - 1});
  } catch (const std::runtime_error&) {
  }
  return 0;
}
