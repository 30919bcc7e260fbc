#pragma once
// Wall pictures as PNG files.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/capture/work_queue.h"
#include "cave/gl/picture.h"
#include "cave/gl/picture_reader.h"
#include "cave/process/termination.h"
#include "cave/room/wall.h"

namespace carom {

/// Pixels in memory, RGB, rows from the bottom up.
struct Image {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> rgb;
};

/// Reads a picture back; waits for its drawing. The drawing context must be current.
Image readBack(const RenderTarget& picture);

/// `directory`/WALL-EYE-FRAME.png, the frame as six digits.
std::filesystem::path capturePath(const std::filesystem::path& directory, const std::string& wall, Eye eye,
                                  std::uint64_t frame);

/// Writes a PNG that appears whole or not at all. Throws std::runtime_error naming the file.
void writePng(const Image& image, const std::filesystem::path& path);

/// What a full queue means for the next frame.
enum class WhenFull {
  wait,  ///< in simulated time: nothing is left out
  drop,  ///< in real time: the frame is left out, and counted
};

/// Captures pictures while a session goes on: they are read back a frame or two later, encoded and written by
/// other threads. Use with the drawing context current.
class Capture {
 public:
  Capture(std::filesystem::path directory, WhenFull whenFull);
  ~Capture();  ///< without `finish`: writes what has been read back

  struct Taken {
    const RenderTarget* picture = nullptr;
    const std::string* wall = nullptr;
    Eye eye = Eye::mono;
  };
  /// One more picture for the next `take`, which may not be drawn into until then.
  void include(const Taken& picture) { frame_.push_back(picture); }
  /// Takes all pictures of a frame, or none. Throws std::runtime_error, naming the file, once one could not
  /// be written.
  void take(std::uint64_t frame, std::span<const Taken> pictures);

  /// Returns when every picture is a file. Throws as `take` does.
  void finish();

  std::uint64_t dropped() const { return dropped_; }  ///< frames

 private:
  struct Job {
    std::filesystem::path path;
    glm::ivec2 size_px{0};
    std::vector<std::uint8_t> rgba;
    Image image;
  };
  void fetch(std::size_t most);
  static void write(Job& job);

  std::filesystem::path directory_;
  WhenFull whenFull_;
  std::uint64_t dropped_ = 0;
  std::vector<Taken> frame_;  // the pictures of the next one
  PictureReader reader_;
  std::deque<std::filesystem::path> asked_;   // where the pictures go that are being read back
  std::unique_ptr<WorkQueue<Job>> queue_;     // from the first frame on
  std::optional<ClosedOnLeaving> onLeaving_;  // last: it uses the queue
};

}  // namespace carom
