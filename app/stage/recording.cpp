#include "app/stage/recording.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/rig/rig.h"
#include "app/stage/all_ranks.h"
#include "cave/capture/capture.h"
#include "cave/capture/movie.h"
#include "cave/spectator/spectator_view.h"
#include "engine/text/log.h"

namespace carom {

namespace {

/// Throws std::runtime_error, which names the folder and --capture.
void makeFolder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw std::runtime_error(fmt::format("--capture {}: {}, expected a folder or a name for one",
                                         folder.string(), failed.message()));
  }
}

}  // namespace

Recording::Recording(Graphics& graphics, const RecordingOptions& options, const Cluster& cluster,
                     const Rig& rig, bool realTime)
    : graphics_(graphics),
      cluster_(cluster),
      layout_(movieLayout(cluster.wallsOf(rig.walls), rig.oneWindow.has_value())),
      display_hz_(rig.display_hz),
      realTime_(realTime) {
  if (cluster.size() > 1) node_ = " of " + cluster.nameOf(cluster.rank());
  graphics_.makeCurrent();
  if (options.capture) {
    makeFolder(*options.capture);
    capture_ = std::make_unique<Capture>(*options.capture, whenFull());
    folder_ = *options.capture;
  }
  if (options.movie && !layout_.places.empty()) {
    movie_ = std::make_unique<Movie>(movieOfNode(*options.movie, cluster.rank(), cluster.size()), layout_,
                                     display_hz_, whenFull());
  }
}

/// Returns a name with today's date and the time, beside the session file or in the present folder.
std::filesystem::path Recording::dated(std::string_view what, std::string_view ending) const {
  const std::string name = fmt::format("{}-{:%F-%H%M%S}{}", what, fmt::localtime(std::time(nullptr)), ending);
  return session_ ? session_->parent_path() / name : std::filesystem::path(name);
}

void Recording::startMovie() try {
  if (movie_ || layout_.places.empty()) return;
  graphics_.makeCurrent();
  movie_ = std::make_unique<Movie>(dated("carom", ".mp4"), layout_, display_hz_, whenFull());
  asked_.movie = true;
  filmed_ = 0;
} catch (const std::exception& error) {
  log::error(fmt::format("no movie: {}", error.what()));
}

void Recording::endMovie() {
  graphics_.makeCurrent();
  attempt(movie_, asked_.movie, "the session goes on, without the movie", [this] { finishMovie(); });
  movie_.reset();
  asked_.movie = false;
}

void Recording::takePictures(std::string_view what) try {
  if (capture_) return;
  const std::filesystem::path folder = dated(what, "");
  graphics_.makeCurrent();
  makeFolder(folder);
  capture_ = std::make_unique<Capture>(folder, WhenFull::wait);
  folder_ = folder;
  captured_.reset();
  asked_.picture = true;
  log::note(fmt::format("The pictures are in {}.", folder.string()));
} catch (const std::exception& error) {
  log::error(fmt::format("no pictures: {}", error.what()));
}

Recording::~Recording() {
  graphics_.makeCurrent();
  movie_.reset();
  capture_.reset();
}

/// Runs `work`. If it fails, logs the error and discards that output; the session has then failed, unless it
/// was the operator who asked for the output during it.
template <typename Part, typename Work>
void Recording::attempt(std::unique_ptr<Part>& part, bool isForOperator, const char* outcome,
                        const Work& work) {
  if (!part) return;
  try {
    work();
  } catch (const std::exception& error) {
    log::error(fmt::format("{}{}: {}", outcome, node_, error.what()));
    failed_ = failed_ || !isForOperator;
    graphics_.makeCurrent();
    part.reset();
  }
}

void Recording::take(const DisplayWalls& walls, const SpectatorView* outside, const FrameRecord& record) {
  const auto capture = [&] {
    if (captured_ == record.number) return;
    captured_ = record.number;
    if (outside) capture_->include(outside->taken());
    walls.capture(*capture_, record.number);
    ++captures_;
  };
  const auto film = [&] {
    walls.film(*movie_, record.display_s);
    ++filmed_;
  };
  if (realTime_ || asked_.picture) {
    attempt(capture_, asked_.picture, "the session goes on, without more pictures", capture);
  } else if (capture_) {
    capture();
  }
  if (realTime_ || asked_.movie) {
    attempt(movie_, asked_.movie, "the session goes on, without the movie", film);
  } else if (movie_) {
    film();
  }
  if (!std::exchange(asked_.picture, false) || !capture_) return;
  attempt(capture_, true, "the session goes on, without the pictures", [this] { finishCapture(); });
  if (capture_) log::note(fmt::format("The pictures are in {}.", folder_.string()));
  capture_.reset();
}

RecordingReport Recording::report() const {
  RecordingReport report;
  if (capture_) {
    report.capture = folder_;
    report.notCaptured = capture_->dropped();
  }
  if (movie_) {
    report.movie = movie_->file();
    report.notFilmed = movie_->dropped();
  }
  report.captured = captures_ - report.notCaptured;
  report.filmed = filmed_ - report.notFilmed;
  return report;
}

void Recording::finish() {
  graphics_.makeCurrent();
  attempt(capture_, false, "the session ends, without all pictures", [this] { finishCapture(); });
  attempt(movie_, asked_.movie, "the session ends, without the movie", [this] { finishMovie(); });
  if (cluster_.firstFailed(failed_) >= 0) throw RankFailed{};
}

void Recording::finishCapture() {
  capture_->finish();
  if (capture_->dropped() == 0) return;
  log::warn(fmt::format("pictures{} of {} frames were left out: they came faster than they are written.",
                        node_, capture_->dropped()));
}

void Recording::finishMovie() {
  movie_->finish();
  log::note(fmt::format("The movie{} is in {}.", node_, movie_->file().string()));
  if (movie_->dropped() == 0) return;
  log::warn(fmt::format("in the movie{}, {} frames were left out: they came faster than they are encoded.",
                        node_, movie_->dropped()));
}

}  // namespace carom
