#include "app/recording.h"

#include <fmt/format.h>

#include "app/stage.h"
#include "cave/capture.h"
#include "cave/movie.h"
#include "cave/room_view.h"

namespace carom {

Recording::Recording(Graphics& graphics, const RecordingOptions& options, const Cluster& cluster,
                     const Rig& rig, bool realTime)
    : graphics_(graphics) {
  const WhenFull whenFull = realTime ? WhenFull::drop : WhenFull::wait;
  const std::vector<Wall> walls = wallsOf(rig, cluster);
  if (cluster.size() > 1) node_ = " of " + cluster.nameOf(cluster.rank());
  graphics_.makeCurrent();
  if (options.capture) {
    makeFolder(*options.capture);
    capture_ = std::make_unique<Capture>(*options.capture, whenFull);
  }
  if (options.movie && !walls.empty()) {
    movie_ = std::make_unique<Movie>(movieOfNode(*options.movie, cluster.rank(), cluster.size()),
                                     movieLayout(walls, rig.oneWindow.has_value()), rig.display_hz, whenFull);
  }
}

Recording::~Recording() {
  graphics_.makeCurrent();
  movie_.reset();
  capture_.reset();
}

void Recording::take(const WallSet& walls, const RoomView* outside, const FrameRecord& record) {
  if (capture_) walls.capture(*capture_, record.number);
  if (capture_ && outside) outside->capture(*capture_, record.number);
  if (movie_) walls.film(*movie_, record.display_s);
}

void Recording::finish() {
  graphics_.makeCurrent();
  if (capture_) capture_->finish();
  if (capture_ && capture_->dropped() > 0) {
    fmt::print(stderr,
               "warning: pictures{} of {} frames were left out: they came faster than they are written.\n",
               node_, capture_->dropped());
  }
  if (!movie_) return;
  movie_->finish();
  fmt::print(stderr, "The movie{} is in {}.\n", node_, movie_->file().string());
  if (movie_->dropped() > 0) {
    fmt::print(stderr,
               "warning: in the movie{}, {} frames were left out: they came faster than they are encoded.\n",
               node_, movie_->dropped());
  }
}

}  // namespace carom
