#pragma once
// Jobs for a few threads of their own, in a queue of bounded length.

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace carom {

/// One thread adds jobs. Finished jobs are kept so that their memory can be reused.
template <typename Job>
class WorkQueue {
 public:
  /// `work` runs on `threads` threads; with one thread, in the order of the jobs. At most `capacity` jobs are
  /// waiting or in progress.
  WorkQueue(std::size_t capacity, unsigned threads, std::function<void(Job&)> work)
      : capacity_(std::max<std::size_t>(capacity, 1)), work_(std::move(work)) {
    for (unsigned i = 0; i < std::max(threads, 1U); ++i) {
      threads_.emplace_back([this](const std::stop_token& stop) { run(stop); });
    }
  }
  /// Finishes the waiting jobs; failures at this stage are not reported.
  ~WorkQueue() {
    for (std::jthread& thread : threads_) thread.request_stop();
  }
  WorkQueue(const WorkQueue&) = delete;
  WorkQueue& operator=(const WorkQueue&) = delete;

  /// Returns how many jobs can be added without waiting.
  std::size_t room() const {
    const std::scoped_lock hold(mutex_);
    return capacity_ - std::min(capacity_, unfinished());
  }

  /// Returns a finished job, for its memory, or a new one if there is none.
  Job spare() {
    const std::scoped_lock hold(mutex_);
    if (spares_.empty()) return {};
    Job job = std::move(spares_.back());
    spares_.pop_back();
    return job;
  }

  /// Adds a job, waiting while the queue is full. Throws the exception of the first job that failed; later
  /// jobs are not done.
  void add(Job job) {
    std::unique_lock hold(mutex_);
    finished_.wait(hold, [this] { return unfinished() < capacity_ || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    waiting_.push_back(std::move(job));
    added_.notify_one();
  }

  /// Waits until all jobs are done. Throws as `add` does.
  void finish() {
    std::unique_lock hold(mutex_);
    finished_.wait(hold, [this] { return unfinished() == 0; });
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t unfinished() const { return waiting_.size() + underWay_; }

  void run(const std::stop_token& stop) {
    while (std::optional<Job> job = take(stop)) {
      std::exception_ptr failure;
      try {
        work_(*job);
      } catch (...) {
        failure = std::current_exception();
      }
      const std::scoped_lock hold(mutex_);
      if (failure && !failure_) failure_ = failure;
      if (failure_) waiting_.clear();
      if (spares_.size() < capacity_) spares_.push_back(std::move(*job));
      --underWay_;
      finished_.notify_all();
    }
  }

  /// Returns the next job, or none when a stop is requested and no job waits.
  std::optional<Job> take(const std::stop_token& stop) {
    std::unique_lock hold(mutex_);
    added_.wait(hold, stop, [this] { return !waiting_.empty(); });
    if (waiting_.empty()) return std::nullopt;
    std::optional<Job> job(std::move(waiting_.front()));
    waiting_.pop_front();
    ++underWay_;
    return job;
  }

  std::size_t capacity_;
  std::function<void(Job&)> work_;
  mutable std::mutex mutex_;
  std::condition_variable_any added_;
  std::condition_variable finished_;
  std::deque<Job> waiting_;
  std::vector<Job> spares_;
  std::size_t underWay_ = 0;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_;  // last: they use the rest
};

}  // namespace carom
