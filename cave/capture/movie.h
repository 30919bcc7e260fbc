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
#include "cave/capture/spherical_movie.h"
#include "cave/capture/work_queue.h"
#include "cave/gl/picture.h"
#include "cave/gl/picture_reader.h"
#include "cave/projection/stereo.h"
#include "cave/room/wall.h"

namespace carom {

/// The file endings of a movie; each selects a file format of ffmpeg.
inline constexpr std::string_view kMovieEndings = ".mp4, .webm or .ogv";
bool isMovieName(const std::filesystem::path& file);

/// Returns the file of one node: each of several nodes has its own, such as cave-node1.mp4 of rank 1 for
/// cave.mp4.
std::filesystem::path movieOfNode(const std::filesystem::path& file, int rank, int ranks);

/// The place of each wall in the movie's picture, from its top left.
struct MovieLayout {
  glm::ivec2 size_px{0};  ///< even numbers, as encoders require
  std::vector<Viewport> places;
  Spherical spherical = Spherical::none;  ///< players look for it in a file that ends in .mp4
};

/// Returns the layout for one eye's picture of each wall, in full size if the movie is then at most 3840 ×
/// 2160, of pictures by direction 8192 × 8192, otherwise reduced. The walls stand in a row; with
/// `inOneWindow`, where a wall's `window` is its place among the others, they lie as in that window.
MovieLayout movieLayout(std::span<const Wall> walls, bool inOneWindow);

/// Use it with the drawing context current.
class Movie {
 public:
  /// Starts ffmpeg. Throws std::runtime_error, with a message for the person, if it is not installed or the
  /// file cannot be written. Until `finish` the file has another name; then it appears whole.
  Movie(std::filesystem::path file, MovieLayout layout, double frames_hz, WhenFull whenFull);
  ~Movie();  ///< without `finish` no file appears
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// Adds the next frame: a picture of each wall, in the layout's order. The movie keeps the display's time:
  /// a frame that is displayed for several ticks is repeated as often, and the ticks of a dropped frame go to
  /// the frame before. A jump by over a second in either direction, as when seeking in a recording, counts as
  /// one frame. Throws std::runtime_error once ffmpeg has failed.
  void add(double display_s, std::span<const RenderTarget* const> pictures);

  /// Waits until the movie is a file. Throws as `add` does. If only its final name cannot be given, the movie
  /// keeps the other name, and a message says so.
  void finish();

  std::uint64_t dropped() const { return pace_.dropped; }  ///< number of frames
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
  struct Pace {
    std::uint64_t tick = 0;
    std::optional<double> previous_s;  // display time of the previous frame
    std::uint64_t dropped = 0;         // frames
  };
  Pace pace_;
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
