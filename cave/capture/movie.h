#pragma once
// A session as a movie: the walls of one node side by side in one picture, encoded by the program ffmpeg
// while the session goes on.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/capture/capture.h"
#include "cave/capture/work_queue.h"
#include "cave/gl/picture.h"
#include "cave/gl/picture_reader.h"
#include "cave/projection/stereo.h"
#include "cave/room/wall.h"

namespace carom {

/// The endings of a movie's name: each is a kind of file that ffmpeg writes.
inline constexpr std::string_view kMovieEndings = ".mp4, .webm or .ogv";
bool isMovieName(const std::filesystem::path& file);

/// With several nodes each has its own: cave.mp4 is cave-node1.mp4 on rank 1.
std::filesystem::path movieOfNode(const std::filesystem::path& file, int rank, int ranks);

/// Where each wall is in the movie's picture, from its top left.
struct MovieLayout {
  glm::ivec2 size_px{0};  ///< even, as encoders want it
  std::vector<Viewport> places;
};

/// One eye's picture of each wall, at its own pixels where the movie is then at most 3840 × 2160, else
/// smaller: in a row; with `inOneWindow`, where a wall's `window` is its place among the others, as they lie
/// there.
MovieLayout movieLayout(std::span<const Wall> walls, bool inOneWindow);

/// Use with the drawing context current.
class Movie {
 public:
  /// Starts ffmpeg. Throws std::runtime_error, in words for the person, if it is not installed or the file
  /// cannot be written. The file appears at `finish`, whole; until then it has another name.
  Movie(std::filesystem::path file, MovieLayout layout, double frames_hz, WhenFull whenFull);
  ~Movie();  ///< without `finish` no file appears
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// The next frame: a picture of each wall, in the layout's order. The movie keeps the display's time: a
  /// frame that stays for several ticks is there as often, a frame that is dropped gives its ticks to the one
  /// before. A jump by over a second either way, as through a recording, is one frame. Throws
  /// std::runtime_error once ffmpeg has failed.
  void add(double display_s, std::span<const RenderTarget* const> pictures);

  /// Returns when the movie is a file. Throws as `add` does; where it only cannot have its name, it stays
  /// under the other, which is said.
  void finish();

  std::uint64_t dropped() const { return dropped_; }  ///< frames
  const std::filesystem::path& file() const { return file_; }

 private:
  class Encoder;
  struct Job {
    std::uint64_t tick = 0;  // of the movie
    std::vector<std::uint8_t> rgba;
  };
  void fetch(std::size_t most);
  void conclude();

  std::filesystem::path file_;
  MovieLayout layout_;
  double frames_hz_;
  WhenFull whenFull_;
  std::uint64_t dropped_ = 0;
  std::uint64_t tick_ = 0;
  std::optional<double> previous_s_;  // display time
  RenderTarget picture_;
  StereoPacker packer_;
  PictureReader reader_;
  std::deque<std::uint64_t> asked_;  // the ticks of the pictures that are being read back
  std::unique_ptr<Encoder> encoder_;
  std::unique_ptr<WorkQueue<Job>> queue_;
  std::mutex finishing_;
  bool finished_ = false;
  ClosedOnLeaving onLeaving_{[this] { conclude(); }};  // last: it uses the rest
};

}  // namespace carom
