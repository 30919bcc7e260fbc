#pragma once
// Pictures on their way from the graphics card into memory, through pixel buffers: a frame asks for them and
// goes on; they are fetched when they have arrived.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/picture.h"

namespace carom {

/// Use with the drawing context current.
class PictureReader {
 public:
  PictureReader() = default;
  ~PictureReader();
  PictureReader(const PictureReader&) = delete;
  PictureReader& operator=(const PictureReader&) = delete;

  /// Asks for the picture as it is drawn so far. `view`: which of a frame's pictures it is; where its size
  /// changes, what was kept for the old one goes.
  void ask(const RenderTarget& picture, std::size_t view);

  /// RGBA, rows from the bottom up; valid during the call.
  using Fetch = std::function<void(const glm::ivec2& size_px, std::span<const std::uint8_t> rgba)>;

  /// Hands over those that have arrived, in the order in which they were asked for; of more than `most` it
  /// waits for the oldest. 0: all.
  void fetch(std::size_t most, const Fetch& fetched);

  std::size_t underWay() const { return asked_.size(); }

 private:
  struct Asked {
    std::size_t view = 0;
    unsigned buffer = 0;
    void* arrived = nullptr;  // GLsync
    glm::ivec2 size_px{0};
  };
  unsigned bufferFor(std::size_t view, const glm::ivec2& size_px);

  std::deque<Asked> asked_;
  std::vector<Asked> spare_;  // buffers that can be used again
};

}  // namespace carom
