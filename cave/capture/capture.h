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
#include "cave/pictures/image.h"
#include "cave/process/termination.h"
#include "cave/room/wall.h"

namespace carom {

/// Returns `directory`/WALL-EYE-FRAME.png, with the frame as six digits.
std::filesystem::path capturePath(const std::filesystem::path& directory, const std::string& wall, Eye eye,
                                  std::uint64_t frame);

/// The treatment of the next frame if the queue is full.
enum class WhenFull {
  wait,  ///< waits, in simulated time: no frame is left out
  drop,  ///< leaves the frame out and counts it, in real time
};

/// Captures pictures while a session goes on: they are read back a frame or two later, and other threads
/// encode and write them. Use it with the drawing context current.
class Capture {
 public:
  Capture(std::filesystem::path directory, WhenFull whenFull);
  ~Capture();  ///< without `finish`: writes the pictures that have been read back

  struct Taken {
    const RenderTarget* picture = nullptr;
    const std::string* wall = nullptr;
    Eye eye = Eye::middle;
  };
  /// Adds a picture to the next `take`; until then it must not be drawn into.
  void include(const Taken& picture) { frame_.push_back(picture); }
  /// Captures all pictures of a frame, or none. After a picture could not be written, throws
  /// std::runtime_error naming the file.
  void take(std::uint64_t frame, std::span<const Taken> pictures);

  /// Waits until every picture is a file. Throws as `take` does.
  void finish();

  std::uint64_t dropped() const { return dropped_; }  ///< number of frames

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
  std::vector<Taken> frame_;  // the pictures of the next frame
  PictureReader reader_;
  std::deque<std::filesystem::path> asked_;   // paths of the pictures that are being read back
  std::unique_ptr<WorkQueue<Job>> queue_;     // from the first frame on
  std::optional<ClosedOnLeaving> onLeaving_;  // last: it uses the queue
};

}  // namespace carom
