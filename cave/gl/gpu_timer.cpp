#include "cave/gl/gpu_timer.h"

#include <vtk_glew.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace carom {

GpuTimer::~GpuTimer() {
  if (!queries_.empty()) glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

GpuTimer::GpuTimer(GpuTimer&& other) noexcept
    : queries_(std::exchange(other.queries_, {})),
      begun_(other.begun_),
      answered_(other.answered_),
      runs_(other.runs_),
      durations_s_(other.durations_s_),
      measured_(other.measured_) {}

/// Takes the answers that have come. An answer that is too late is lost.
void GpuTimer::take() {
  if (begun_ - answered_ >= kOnTheWay) answered_ = begun_ - kOnTheWay + 1;
  for (; answered_ < begun_; ++answered_) {
    const GLuint query = queries_[answered_ % kOnTheWay];
    GLuint isThere = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &isThere);
    if (isThere == 0) return;
    GLuint64 duration_ns = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &duration_ns);
    durations_s_[measured_++ % kKept] = 1e-9F * static_cast<float>(duration_ns);
  }
}

void GpuTimer::begin() {
  if (!GLEW_ARB_timer_query) return;
  if (queries_.empty()) {
    queries_.resize(kOnTheWay);
    glGenQueries(static_cast<GLsizei>(kOnTheWay), queries_.data());
  }
  take();
  glBeginQuery(GL_TIME_ELAPSED, queries_[begun_ % kOnTheWay]);
  runs_ = true;
}

void GpuTimer::end() {
  if (!std::exchange(runs_, false)) return;
  glEndQuery(GL_TIME_ELAPSED);
  ++begun_;
}

float GpuTimer::median_s() const {
  const std::size_t known = std::min(measured_, kKept);
  if (known == 0) return std::numeric_limits<float>::quiet_NaN();
  std::array<float, kKept> sorted_s = durations_s_;
  const auto middle = sorted_s.begin() + static_cast<std::ptrdiff_t>(known / 2);
  std::nth_element(sorted_s.begin(), middle, sorted_s.begin() + static_cast<std::ptrdiff_t>(known));
  return *middle;
}

}  // namespace carom
