#pragma once
// Reads pictures back from the graphics card into memory without stopping the frame, through pixel buffers: a
// frame asks for its pictures, and later frames fetch those that have arrived.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"

namespace carom {

/// Use with the drawing context current.
class PictureReader {
 public:
  /// Asks for the picture as drawn so far. `view`: which of a frame's pictures it is; when its size changes,
  /// the buffers of the old size are dropped.
  void ask(const RenderTarget& picture, std::size_t view);

  /// Takes RGBA pixels, rows from the bottom up, which are valid during the call.
  using Fetch = std::function<void(const glm::ivec2& size_px, std::span<const std::uint8_t> rgba)>;

  /// Hands over the pictures that have arrived, in the order in which they were asked for. If more than
  /// `most` are under way, waits for the oldest; 0 waits for all.
  void fetch(std::size_t most, const Fetch& fetched);

  std::size_t underWay() const { return asked_.size(); }

 private:
  struct Asked {
    std::size_t view = 0;
    GlBuffer buffer;
    GlFence arrived;
    glm::ivec2 size_px{0};
  };
  GlBuffer bufferFor(std::size_t view, const glm::ivec2& size_px);

  std::deque<Asked> asked_;
  std::vector<Asked> spare_;  // buffers that can be used again
};

}  // namespace carom
