#pragma once
// Smooth edges without multisampling, in a picture in memory: edges are sought in the finished picture, and
// each pixel at one is mixed with its neighbour as far as the edge covers it.
//
// Edges are sought in the tone of a pixel. In the session's pictures that is alpha: there the surfaces are as
// bright as if each were painted evenly (shaders/surface_frag.glsl), since the paint on a surface is smooth
// already.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

class EdgePixels {
 public:
  /// Where a picture has the tones between which edges are sought.
  enum class Tones { inAlpha, luminance };
  explicit EdgePixels(Tones tones) : tones_(tones) {}

  /// Returns where the pixels of a picture of this size go: alpha, red, green and blue from the highest byte
  /// down, rows from the bottom up. Their former content is an earlier picture.
  std::span<std::uint32_t> begin(const glm::ivec2& size_px);
  /// Smooths the picture in that place, and returns it.
  std::span<const std::uint32_t> smooth();

 private:
  struct Change {
    std::size_t at;
    std::uint32_t colour;
  };
  std::uint8_t* rowOfTones(int y);
  void takeTones();
  void findEdges(int y);
  void mix(int x, int y);

  Tones tones_;
  glm::ivec2 size_px_{0};
  std::vector<std::uint32_t> pixels_;
  std::ptrdiff_t stride_ = 0;         // from one row of tones to the next
  std::vector<std::uint8_t> tones8_;  // with a border, where the outermost pixels are repeated
  std::vector<std::uint64_t> edges_;  // bytes: which pixels of a row are at an edge
  std::vector<Change> changes_;
};

}  // namespace carom
