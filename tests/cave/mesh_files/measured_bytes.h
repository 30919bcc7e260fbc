#pragma once
// Measured screens as the bytes of files, written from the tables of their formats.

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The place of a screen that a place of the window shows; NaN: none.
using PlaceOf = std::function<glm::dvec3(const glm::dvec2& inWindow)>;

inline void put(std::string& bytes, std::uint32_t value) {
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8U * i) & 0xffU);
}
inline void put(std::string& bytes, float value) { put(bytes, std::bit_cast<std::uint32_t>(value)); }

/// A PFM whose first row is the window's lowest, little-endian.
inline std::string pfmBytes(int columns, int rows, const PlaceOf& place) {
  std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", columns, rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const glm::dvec3 at = place({(column + 0.5) / columns, (row + 0.5) / rows});
      for (int i = 0; i < 3; ++i) put(bytes, static_cast<float>(at[i]));
    }
  }
  return bytes;
}

/// A .vwf with a screen: a header of 380 bytes, then x y z w of each pixel from the window's upper left.
/// Lengths are `perMetre` of the file's to a metre. `flags` beside 0x40, `after`: what follows the points.
inline std::string vwfBytes(int columns, int rows, const PlaceOf& place, double perMetre = 1000.0,
                            std::uint32_t flags = 0, const std::string& after = "") {
  constexpr std::uint32_t kHeader = 380, kScreen = 0x40;
  std::string bytes = "vwf0";
  for (const std::uint32_t value :
       {kHeader, kScreen | flags, 0U, static_cast<std::uint32_t>(16 * columns * rows),
        static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows)})
    put(bytes, value);
  bytes.resize(kHeader, '\0');
  for (int row = rows; row-- > 0;) {
    for (int column = 0; column < columns; ++column) {
      const glm::dvec3 at = perMetre * place({(column + 0.5) / columns, (row + 0.5) / rows});
      const bool isThere = !std::isnan(at.x);
      for (int i = 0; i < 3; ++i) put(bytes, isThere ? static_cast<float>(at[i]) : 0.0F);
      put(bytes, isThere ? 1.0F : 0.0F);
    }
  }
  return bytes + after;
}

/// An OBJ of quadrangles, with places at the corners of a grid's cells.
inline std::string objText(int columns, int rows, const PlaceOf& place) {
  std::string text = "# a screen\no screen\n";
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const glm::dvec2 inWindow(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
      const glm::dvec3 at = place(inWindow);
      text +=
          fmt::format("v {:.9f} {:.9f} {:.9f}\nvt {:.9f} {:.9f}\n", at.x, at.y, at.z, inWindow.x, inWindow.y);
    }
  }
  const auto corner = [&](int column, int row) { return row * (columns + 1) + column + 1; };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = corner(column, row), b = corner(column + 1, row), c = corner(column + 1, row + 1),
                d = corner(column, row + 1);
      text += fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", a, b, c, d);
    }
  }
  return text;
}

}  // namespace carom::test
