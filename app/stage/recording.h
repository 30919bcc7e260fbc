#pragma once
// The image recording of a session: files of every wall and eye, and a movie.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cave/capture/capture.h"
#include "cave/capture/movie.h"

namespace carom {

class Cluster;
class Graphics;
class SpectatorView;
class DisplayWalls;
struct FrameRecord;
struct Rig;

struct RecordingOptions {
  std::optional<std::filesystem::path> capture;  ///< folder for every image of every frame; created if needed
  std::optional<std::filesystem::path> movie;
};

/// The progress of the recording, for display. An empty path means that nothing is recorded there, or no
/// more.
struct RecordingReport {
  std::filesystem::path capture, movie;
  std::uint64_t captured = 0, filmed = 0;        ///< frames
  std::uint64_t notCaptured = 0, notFilmed = 0;  ///< frames dropped because they came too fast
};

/// The recording of one node.
class Recording {
 public:
  /// Opens the outputs. Throws std::runtime_error with a message for the user if a folder or file cannot be
  /// written. With `realTime`, frames that cannot be written in time are dropped and counted; if an output
  /// fails completely, this is logged and the session continues without it.
  Recording(Graphics& graphics, const RecordingOptions& options, const Cluster& cluster, const Rig& rig,
            bool realTime);
  ~Recording();  ///< without `finish` there is no movie
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Records the last drawn frame, with the spectator view if there is one. A frame that stays on screen is
  /// captured once. In simulated time, throws std::runtime_error if something cannot be written.
  void take(const DisplayWalls& walls, const SpectatorView* outside, const FrameRecord& record);

  /// Sets the session file beside which the following are made, with the date and the time in their names;
  /// none: in the folder in which the program was started.
  void writeBeside(const std::optional<std::filesystem::path>& session) { session_ = session; }
  /// Starts a movie of this node's walls while the session runs, or pictures of all its walls and eyes in one
  /// frame, in a folder whose name begins with `what`, and ends the movie; that takes a moment. A movie that
  /// is being made goes on. Logs a fault: the session goes on.
  void startMovie();
  void endMovie();
  void takePictures(std::string_view what);

  RecordingReport report() const;

  /// Waits on every node until everything is written, and prints to standard error where the movie is and how
  /// many frames were dropped. Throws RankFailed on all nodes if something could not be written, after
  /// logging it.
  void finish();

 private:
  template <typename Part, typename Work>
  void attempt(std::unique_ptr<Part>& part, bool isForOperator, const char* outcome, const Work& work);
  WhenFull whenFull() const { return realTime_ ? WhenFull::drop : WhenFull::wait; }
  std::filesystem::path dated(std::string_view what, std::string_view ending) const;
  void finishCapture();
  void finishMovie();

  Graphics& graphics_;
  const Cluster& cluster_;
  MovieLayout layout_;  ///< of the walls of this node
  double display_hz_;
  bool realTime_;
  // What the operator has asked for in the session.
  struct Asked {
    bool picture = false;  ///< pictures of one frame
    bool movie = false;
  };
  Asked asked_;
  bool failed_ = false;
  std::optional<std::filesystem::path> session_;
  std::optional<std::uint64_t> captured_;  // number of the last frame captured
  std::filesystem::path folder_;
  std::uint64_t captures_ = 0, filmed_ = 0;  // frames
  std::string node_;                         // for messages; empty if there is only one node
  std::unique_ptr<Capture> capture_;
  std::unique_ptr<Movie> movie_;
};

}  // namespace carom
