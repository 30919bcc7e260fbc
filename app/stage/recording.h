#pragma once
// What a session leaves behind of its pictures: files of every wall and eye, a movie.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace carom {

class Capture;
class Cluster;
class Graphics;
class Movie;
class SpectatorView;
class DisplayWalls;
struct FrameRecord;
struct Rig;

struct RecordingOptions {
  std::optional<std::filesystem::path> capture;  ///< folder for every picture of every frame; made if needed
  std::optional<std::filesystem::path> movie;
};

/// How the recording goes, for people. Empty names: nothing is made of it, or no more.
struct RecordingReport {
  std::filesystem::path capture, movie;
  std::uint64_t captured = 0, filmed = 0;        ///< frames
  std::uint64_t notCaptured = 0, notFilmed = 0;  ///< frames that came too fast
};

/// Of one node.
class Recording {
 public:
  /// Throws std::runtime_error, in words for the person, where a folder or file cannot be written.
  /// `realTime`: what cannot be written in time is left out, and counted; once something cannot be written at
  /// all, that is said and the session goes on without more of it.
  Recording(Graphics& graphics, const RecordingOptions& options, const Cluster& cluster, const Rig& rig,
            bool realTime);
  ~Recording();  ///< without `finish` there is no movie
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// The frame that was drawn last; the view from outside, where there is one, among the pictures. A frame
  /// that stays is captured once. In simulated time throws std::runtime_error where something could not be
  /// written.
  void take(const DisplayWalls& walls, const SpectatorView* outside, const FrameRecord& record);

  RecordingReport report() const;

  /// On every node: returns when all is written, and says on standard error where the movie is and what was
  /// left out. Throws RankFailed on all of them where something could not be written, which has been said.
  void finish();

 private:
  template <typename Part, typename Work>
  void attempt(std::unique_ptr<Part>& part, const char* outcome, const Work& work);
  void finishCapture();
  void finishMovie();

  Graphics& graphics_;
  const Cluster& cluster_;
  bool realTime_;
  bool failed_ = false;
  std::optional<std::uint64_t> captured_;  // the last frame
  std::filesystem::path folder_;
  std::uint64_t captures_ = 0, filmed_ = 0;  // frames
  std::string node_;                         // for messages; empty where there is only one
  std::unique_ptr<Capture> capture_;
  std::unique_ptr<Movie> movie_;
};

}  // namespace carom
