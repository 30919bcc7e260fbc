#include "devices/force/force_thread.h"

#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "devices/force/force_loop.h"
#include "devices/force/force_mailbox.h"
#include "devices/tracker/realtime_thread.h"
#include "devices/tracker/retry.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLookAgain{1000};

}  // namespace

struct ForceThread::Shared {
  std::string name;
  OpenForce open;
  ForceLimits limits;
  Clock::time_point start;
  ForceMailbox<ForceLaw> laws;
  ForceMailbox<ForceReport> reports;
  std::mutex mutex;  // of the news, which come when a device comes or goes
  std::vector<std::string> news;
  std::string said;  // the last of them
  std::jthread thread;

  double now_s() const { return std::chrono::duration<double>(Clock::now() - start).count(); }

  void say(const std::string& line) {
    const std::lock_guard lock(mutex);
    if (said == line) return;
    said = line;
    news.push_back(line);
  }

  void run(const std::stop_token& stop);
  void serve(const std::stop_token& stop, ForceLoop& loop);
};

/// Ticks at even times until the device is gone or a stop is requested. A tick that comes late does not make
/// the next ones hurry.
void ForceThread::Shared::serve(const std::stop_token& stop, ForceLoop& loop) {
  const std::unique_ptr<ForceDevice> device = open(stop);
  say(name + " is there");
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.period_s));
  for (Clock::time_point next = Clock::now(); !stop.stop_requested();) {
    const double time_s = now_s();
    const ForceLaw& law = laws.look();
    device->wish(law.wish_m);
    device->write(loop.tick(time_s, device->read(time_s), law));
    reports.post(loop.report());
    next = std::max(next + period, Clock::now() - period);
    std::this_thread::sleep_until(next);
  }
  device->zero();
}

void ForceThread::Shared::run(const std::stop_token& stop) {
  askForPromptness();
  ForceLoop loop(limits);
  while (!stop.stop_requested()) {
    try {
      serve(stop, loop);
      loop.end(ForceFall::ended, now_s());
    } catch (const std::exception& error) {
      loop.end(ForceFall::unplugged, now_s());
      say(name + ": " + error.what() + "; there is no force in the hand");
    }
    reports.post(loop.report());
    if (!stop.stop_requested()) waitUnlessStopped(stop, kLookAgain);
  }
}

ForceThread::ForceThread(std::string name, OpenForce open, const ForceLimits& limits,
                         Clock::time_point sessionStart)
    : shared_(std::make_unique<Shared>()) {
  shared_->name = std::move(name);
  shared_->open = std::move(open);
  shared_->limits = limits;
  shared_->start = sessionStart;
  shared_->thread =
      std::jthread([shared = shared_.get()](const std::stop_token& stop) { shared->run(stop); });
}

ForceThread::~ForceThread() = default;

void ForceThread::post(const ForceLaw& law) { shared_->laws.post(law); }

const ForceReport& ForceThread::report() { return shared_->reports.look(); }

double ForceThread::now_s(double /*given_s*/) const { return shared_->now_s(); }

std::vector<std::string> ForceThread::takeNews() {
  const std::lock_guard lock(shared_->mutex);
  return std::exchange(shared_->news, {});
}

void ForceThread::end() noexcept {
  shared_->thread.request_stop();
  if (shared_->thread.joinable()) shared_->thread.join();
}

}  // namespace carom
