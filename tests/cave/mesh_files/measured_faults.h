#pragma once
// Where measured files lie, and what readers of them say is wrong.

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/mesh_files/measured_bytes.h"
#include "places.h"

namespace carom::test {

/// The folder of meshes that other programs wrote.
inline const std::string kMeshes = CAROM_TESTS_DIR "/data/rooms/meshes/";

/// A flat screen two metres before the room's origin.
inline glm::dvec3 onPlane(const glm::dvec2& inWindow) { return {2.0 * inWindow.x - 1.0, inWindow.y, -2.0}; }

template <class Reader>
std::string complaint(const Reader& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing is wrong";
}

inline void expectSaid(const std::string& heard, const std::string& said) {
  EXPECT_NE(heard.find(said), std::string::npos) << said << "\n" << heard;
}

/// Puts a number into bytes, little-endian.
inline std::string with(std::string bytes, std::size_t at, std::uint32_t value) {
  std::string raw;
  put(raw, value);
  return bytes.replace(at, 4, raw);
}

}  // namespace carom::test
