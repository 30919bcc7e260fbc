#include "cave/mesh_files/vwf_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>

#include "cave/mesh_files/mesh_bytes.h"
#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/warp_grid.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr std::uint32_t kZipped = 0x1, kScreen = 0x40, kBlend16 = 0x100, kBlendFloat = 0x200;
constexpr std::size_t kHeader_bytes = 60, kPoint_bytes = 16;
constexpr std::uint32_t kMost_px = 16384;
constexpr float kFarthestOnScreen = 1e9F;

struct Header {
  std::size_t bytes = 0, data_bytes = 0;
  std::uint32_t flags = 0, columns = 0, rows = 0;
};

/// Returns where the only display of a file begins.
std::size_t displayAt(std::string_view content) {
  if (!content.starts_with("vwf1")) return 0;
  MeshBytes bytes(content, 4);
  const std::uint32_t displays = bytes.whole(), offset = bytes.whole();
  if (displays != 1)
    meshFault(1, 1,
              fmt::format("the file has {} displays, at byte 4, expected one: a file for each", displays));
  constexpr std::uint32_t kContainer_bytes = 16;
  return offset == 0 ? kContainer_bytes : offset;
}

Header headerAt(std::string_view content, std::size_t at) {
  if (at > content.size() || !content.substr(at).starts_with("vwf0"))
    meshFault(1, 1, fmt::format("there is no vwf0 at byte {}, expected a warp of VIOSO", at));
  MeshBytes bytes(content, at + 4);
  Header header;
  header.bytes = bytes.whole();
  header.flags = bytes.whole();
  bytes.whole();  // the monitor
  header.data_bytes = bytes.whole();
  header.columns = bytes.whole();
  header.rows = bytes.whole();
  if (header.bytes < kHeader_bytes || header.bytes > content.size() - at)
    meshFault(1, 1,
              fmt::format("the header has {} bytes, at byte {}, expected {} at least, in the file",
                          header.bytes, at + 4, kHeader_bytes));
  if (header.columns < 2 || header.rows < 2 || header.columns > kMost_px || header.rows > kMost_px)
    meshFault(1, 1,
              fmt::format("the grid has {} × {} points, at byte {}, expected 2 to {} each way",
                          header.columns, header.rows, at + 20, kMost_px));
  return header;
}

/// Returns the points' bytes, unpacked if they are packed. `packed` is what holds them.
std::string unpacked(std::string_view packed, std::size_t needed, std::size_t at) {
  constexpr std::size_t kMostRatio = 1032;  // of deflate (RFC 1951)
  const std::uintmax_t most = limitOf(InputKind::screenGrid).most_MiB << 20U;
  if (needed > most || needed / kMostRatio > packed.size())
    meshFault(1, 1,
              fmt::format("the points take {} bytes, which {} bytes at byte {} cannot hold, expected {} at "
                          "most",
                          needed, packed.size(), at, most));
  std::string points(needed, '\0');
  uLongf length = needed;
  if (uncompress(reinterpret_cast<Bytef*>(points.data()), &length,
                 reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
      length != needed)
    meshFault(1, 1,
              fmt::format("the packed points at byte {} are broken, expected {} bytes of them", at, needed));
  return points;
}

std::vector<glm::vec3> pointsIn(std::string_view raw, const Header& header) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const bool isScreen = (header.flags & kScreen) != 0;
  std::vector<glm::vec3> points;
  points.reserve(raw.size() / kPoint_bytes);
  MeshBytes bytes(raw);
  for (std::size_t i = 0; i < raw.size() / kPoint_bytes; ++i) {
    const float x = bytes.number(), y = bytes.number(), z = bytes.number(), w = bytes.number();
    const bool isThere =
        (isScreen ? w : z) > 0.0F && std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
    if (!isThere) {
      points.emplace_back(kNone);
      continue;
    }
    const float farthest = isScreen ? kFarthestOnScreen : static_cast<float>(kFarthestInWindow);
    if (std::max({std::abs(x), std::abs(y), isScreen ? std::abs(z) : 0.0F}) > farthest)
      meshFault(1, 1,
                fmt::format("point ({}, {}) is {:g}, {:g}, {:g}, expected numbers from {:g} to {:g}",
                            i % header.columns, i / header.columns, x, y, z, -farthest, farthest));
    points.emplace_back(x, y, isScreen ? z : 0.0F);
  }
  return points;
}

std::uint16_t codeOf(double share) {
  constexpr double kMost = 65535.0;
  return static_cast<std::uint16_t>(
      std::lround(kMost * std::clamp(std::isnan(share) ? 0.0 : share, 0.0, 1.0)));
}

/// Reads the blend of a pixel of the window each: RGBA from its top.
void readBlend(MeshBytes& bytes, bool isFloat, VwfFile& file) {
  const auto columns = static_cast<std::size_t>(file.columns), rows = static_cast<std::size_t>(file.rows);
  MeshBytes values(bytes.take(columns * rows * (isFloat ? 16 : 8)));
  file.blend_px = {file.columns, file.rows};
  file.blend.resize(3 * columns * rows);
  for (std::size_t row = rows; row-- > 0;) {
    for (std::size_t column = 0; column < columns; ++column) {
      std::uint16_t* rgb = &file.blend[3 * (row * columns + column)];
      if (isFloat) {
        for (int i = 0; i < 3; ++i) rgb[i] = codeOf(values.number());
        values.number();
      } else {
        const std::uint32_t redGreen = values.whole(), blue = values.whole();
        rgb[0] = static_cast<std::uint16_t>(redGreen);
        rgb[1] = static_cast<std::uint16_t>(redGreen >> 16U);
        rgb[2] = static_cast<std::uint16_t>(blue);
      }
    }
  }
}

/// Reads the picture that follows the points, if there is one: a BMP of 24 or 32 bits.
void readBitmap(MeshBytes bytes, VwfFile& file) {
  constexpr std::size_t kToData = 10, kToSize = 4;
  const std::size_t begin = bytes.at();
  if (bytes.left() < 2 || bytes.take(2) != "BM") return;
  bytes.take(kToData - 2);
  const std::uint32_t data = bytes.whole();
  bytes.take(kToSize);
  const std::uint32_t width = bytes.whole();
  const auto signedHeight = static_cast<std::int32_t>(bytes.whole());
  const std::uint32_t depth = bytes.whole() >> 16U, packing = bytes.whole();
  const bool isFromTop = signedHeight < 0;
  const std::uint32_t height = static_cast<std::uint32_t>(std::abs(static_cast<std::int64_t>(signedHeight)));
  const std::uint32_t pixel = depth / 8;
  if (width < 1 || height < 1 || width > kMost_px || height > kMost_px || (depth != 24 && depth != 32) ||
      (packing != 0 && packing != 3))
    meshFault(1, 1,
              fmt::format("the blend at byte {} has {} × {} pixels of {} bits, packed by {}, expected a BMP "
                          "of 24 or 32 bits, not packed, of at most {} pixels each way",
                          begin, width, height, depth, packing, kMost_px));
  const std::size_t row_bytes = (static_cast<std::size_t>(width) * pixel + 3) / 4 * 4;
  const std::size_t read = bytes.at() - begin;
  if (data < read)
    meshFault(1, 1, fmt::format("the blend's pixels begin at its byte {}, expected {} or more", data, read));
  bytes.take(data - read);
  const std::string_view pixels = bytes.take(row_bytes * height);
  file.blend_px = {static_cast<int>(width), static_cast<int>(height)};
  file.blend.resize(3 * static_cast<std::size_t>(width) * height);
  for (std::size_t row = 0; row < height; ++row) {
    const std::size_t from = (isFromTop ? height - 1 - row : row) * row_bytes;
    for (std::size_t column = 0; column < width; ++column) {
      for (std::size_t part = 0; part < 3; ++part)  // blue comes first
        file.blend[3 * (row * width + column) + part] = static_cast<std::uint16_t>(
            257U * static_cast<std::uint8_t>(pixels[from + column * pixel + 2 - part]));
    }
  }
}

}  // namespace

VwfFile parseVwf(std::string_view content) {
  const std::size_t at = displayAt(content);
  const Header header = headerAt(content, at);
  MeshBytes bytes(content, at + header.bytes);
  const std::size_t needed = kPoint_bytes * header.columns * header.rows;
  const std::size_t told = (header.flags & kZipped) != 0 ? header.data_bytes : needed;
  if (told > bytes.left() ||
      ((header.flags & kZipped) == 0 && header.data_bytes != 0 && header.data_bytes < needed))
    meshFault(
        1, 1,
        fmt::format("{} × {} points take {} bytes at byte {}, but {} are told and {} follow, expected them "
                    "whole",
                    header.columns, header.rows, told, bytes.at(), header.data_bytes, bytes.left()));
  const std::size_t pointsAt = bytes.at();
  const std::string_view stored = bytes.take(told);
  VwfFile file;
  file.columns = static_cast<int>(header.columns);
  file.rows = static_cast<int>(header.rows);
  file.isScreen = (header.flags & kScreen) != 0;
  if ((header.flags & kZipped) != 0)
    file.points = pointsIn(unpacked(stored, needed, pointsAt), header);
  else
    file.points = pointsIn(stored, header);
  if ((header.flags & (kBlend16 | kBlendFloat)) != 0)
    readBlend(bytes, (header.flags & kBlendFloat) != 0, file);
  else
    readBitmap(bytes, file);
  return file;
}

Warp warpOf(const VwfFile& file) {
  if (file.isScreen)
    meshFault(
        1, 1,
        "the file has a screen (flag 0x40), expected a warp: screen = { shape = \"grid\", file = … } takes "
        "it");
  WarpMesh mesh;
  mesh.points.reserve(file.points.size());
  for (int row = 0; row < file.rows; ++row) {
    for (int column = 0; column < file.columns; ++column) {
      const glm::vec3& point =
          file.points[static_cast<std::size_t>(row) * static_cast<std::size_t>(file.columns) +
                      static_cast<std::size_t>(column)];
      const bool isThere = !std::isnan(point.x);
      const glm::vec2 inWindow((static_cast<float>(column) + 0.5F) / static_cast<float>(file.columns),
                               1.0F - (static_cast<float>(row) + 0.5F) / static_cast<float>(file.rows));
      mesh.points.push_back({.inWindow = inWindow,
                             .inPicture = isThere ? glm::vec2(point.x, 1.0F - point.y) : glm::vec2(0.0F),
                             .light = isThere ? 1.0F : -1.0F});
    }
  }
  addGridTriangles(static_cast<std::size_t>(file.columns), static_cast<std::size_t>(file.rows), mesh);
  if (mesh.triangles.empty()) meshFault(1, 1, "no point has a place in the picture, expected some");
  return {mesh, mesh};
}

ScreenGrid screenGridOf(VwfFile file) {
  for (int row = 0; row < file.rows / 2; ++row) {  // its rows are from the top
    const auto from = file.points.begin() + static_cast<std::ptrdiff_t>(row) * file.columns;
    std::swap_ranges(from, from + file.columns,
                     file.points.end() - static_cast<std::ptrdiff_t>(row + 1) * file.columns);
  }
  return {file.columns, file.rows, std::move(file.points)};
}

std::string vwfOf(const glm::ivec2& size, const std::vector<glm::vec2>& inPicture) {
  constexpr std::size_t kHeader = 380;
  std::string bytes = "vwf0";
  const auto put = [&](std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8U * static_cast<unsigned>(i)) & 0xffU);
  };
  for (const std::size_t value : {kHeader, std::size_t{0}, std::size_t{0}, kPoint_bytes * inPicture.size(),
                                  static_cast<std::size_t>(size.x), static_cast<std::size_t>(size.y)})
    put(static_cast<std::uint32_t>(value));
  for (int i = 0; i < 4; ++i) put(std::bit_cast<std::uint32_t>(1.0F));  // white
  bytes.resize(kHeader, '\0');
  for (const glm::vec2& place : inPicture) {
    const bool isThere = !std::isnan(place.x) && !std::isnan(place.y);
    for (const float value :
         {isThere ? place.x : 0.0F, isThere ? place.y : 0.0F, isThere ? 1.0F : 0.0F, 0.0F})
      put(std::bit_cast<std::uint32_t>(value));
  }
  return bytes;
}

}  // namespace carom
