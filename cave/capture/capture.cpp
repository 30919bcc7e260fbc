#include "cave/capture/capture.h"

#include <algorithm>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "cave/room/wall_eyes.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

constexpr std::size_t kMostWaiting_bytes = std::size_t{256} << 20;  // of pictures that wait to be encoded
constexpr std::size_t kMostWaiting = 8;                             // frames with such pictures

/// Returns half the number of processors, so that the others can draw.
unsigned encoders() { return std::clamp(std::thread::hardware_concurrency() / 2, 1U, 8U); }

}  // namespace

std::filesystem::path capturePath(const std::filesystem::path& directory, const std::string& wall, Eye eye,
                                  std::uint64_t frame) {
  return directory / fmt::format("{}-{}-{:06}.png", wall, nameOf(eye), frame);
}

Capture::Capture(std::filesystem::path directory, WhenFull whenFull)
    : directory_(std::move(directory)), whenFull_(whenFull) {}

Capture::~Capture() = default;

void Capture::write(Job& job) {
  job.image.size_px = job.size_px;
  job.image.rgb.resize(job.rgba.size() / 4 * 3);
  for (std::size_t from = 0, to = 0; from < job.rgba.size(); from += 4, to += 3) {
    std::copy_n(&job.rgba[from], 3, &job.image.rgb[to]);
  }
  writePng(job.image, job.path);
}

void Capture::take(std::uint64_t frame, std::span<const Taken> pictures) {
  frame_.insert(frame_.end(), pictures.begin(), pictures.end());
  if (frame_.empty()) return;
  if (!queue_) {
    std::size_t bytes = 0;
    for (const Taken& taken : frame_) {
      bytes = std::max(bytes, 4 * static_cast<std::size_t>(taken.picture->size_px().x) *
                                  static_cast<std::size_t>(taken.picture->size_px().y));
    }
    const std::size_t capacity =
        std::clamp(kMostWaiting_bytes / bytes, 3 * frame_.size(), kMostWaiting * frame_.size());
    queue_ = std::make_unique<WorkQueue<Job>>(capacity, encoders(), write);
    onLeaving_.emplace([this] { queue_->finish(); });
  }
  fetch(frame_.size());  // of the last frame; older ones are waited for
  if (whenFull_ == WhenFull::drop && queue_->room() < frame_.size() + reader_.underWay()) {
    ++dropped_;
    frame_.clear();
    return;
  }
  for (std::size_t i = 0; i < frame_.size(); ++i) {
    reader_.ask(*frame_[i].picture, i);
    asked_.push_back(capturePath(directory_, *frame_[i].wall, frame_[i].eye, frame));
  }
  frame_.clear();
}

void Capture::fetch(std::size_t most) {
  reader_.fetch(most, [this](const glm::ivec2& size_px, std::span<const std::uint8_t> rgba) {
    Job job = queue_->spare();
    job.path = std::move(asked_.front());
    asked_.pop_front();
    job.size_px = size_px;
    job.rgba.assign(rgba.begin(), rgba.end());
    queue_->add(std::move(job));
  });
}

void Capture::finish() {
  if (!queue_) return;
  fetch(0);
  queue_->finish();
}

}  // namespace carom
