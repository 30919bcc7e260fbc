#include "app/calibration/live_points.h"

#include <fmt/format.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <thread>

#include "cave/process/termination.h"
#include "devices/setup/tracker_factory.h"

namespace carom {
namespace {

constexpr std::chrono::milliseconds kPoll{5};

}  // namespace

/// Standard input, key by key: a terminal gives keys without Enter while this lives.
class LivePoints::Terminal {
 public:
  Terminal() {
    if (::tcgetattr(STDIN_FILENO, &before_) != 0) return;
    onLeaving_.emplace([this] { ::tcsetattr(STDIN_FILENO, TCSANOW, &before_); });
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    if (onLeaving_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }

  /// Returns the wish of the next key, if one has been pressed.
  std::optional<Wish> key() const {
    pollfd waiting{STDIN_FILENO, POLLIN, 0};
    if (::poll(&waiting, 1, 0) <= 0) return {};
    char pressed = 0;
    if (::read(STDIN_FILENO, &pressed, 1) != 1) return Wish::end;
    constexpr char kControlC = 3, kControlD = 4;
    switch (pressed) {
      case '\n':
      case '\r':
      case ' ':
        return Wish::take;
      case 's':
        return Wish::skip;
      case 'b':
        return Wish::back;
      case 'q':
      case kControlC:
      case kControlD:
        return Wish::end;
      default:
        return {};
    }
  }

 private:
  termios before_{};
  std::optional<ClosedOnLeaving> onLeaving_;  // none: it is no terminal
};

LivePoints::LivePoints(const Rig& rig) : rig_(rig), newest_(rig.trackers.size()) {
  for (const TrackerSetup& setup : rig.trackers) trackers_.push_back(createTracker(setup, rig.axes, start_));
  noticeTermination();
  terminal_ = std::make_unique<Terminal>();
}

LivePoints::~LivePoints() = default;

double LivePoints::now_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool LivePoints::isHandButton(std::size_t tracker, const Reading& input) const {
  if (!rig_.viewers.front().hand || input.kind != Reading::Kind::button) return false;
  if (rig_.viewers.front().hand->buttons) return tracker == *rig_.viewers.front().hand->buttons;
  return tracker == rig_.viewers.front().hand->tracker && input.sensor == rig_.viewers.front().hand->sensor;
}

std::optional<Wish> LivePoints::poll() {
  std::optional<Wish> wish;
  std::vector<Reading> inputs;
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    newest_[i].clear();
    inputs.clear();
    trackers_[i]->poll(now_s(), newest_[i]);
    trackers_[i]->takeInputs(inputs);
    for (const Reading& input : inputs) {
      if (!isHandButton(i, input)) continue;
      bool& pressed = pressed_[input.index];
      if (!pressed && input.value > 0.5) wish = input.index == 1 ? Wish::back : Wish::take;
      pressed = input.value > 0.5;
    }
  }
  return wish;
}

Wish LivePoints::wait() {
  for (;;) {
    std::this_thread::sleep_for(kPoll);
    if (terminationAsked()) return Wish::end;
    const std::optional<Wish> button = poll();
    if (button) return *button;
    if (const std::optional<Wish> key = terminal_->key()) return *key;
  }
}

std::vector<TrackerSample> LivePoints::record(const SensorChoice& sensor, double seconds) {
  std::vector<TrackerSample> taken;
  poll();  // what came before does not count
  for (const double end_s = now_s() + seconds; now_s() < end_s && !terminationAsked();) {
    std::this_thread::sleep_for(kPoll);
    poll();
    for (const TrackerSample& sample : newest_[sensor.tracker]) {
      if (sample.sensor == sensor.sensor) taken.push_back(sample);
    }
  }
  return taken;
}

std::string LivePoints::health(const SensorChoice& sensor) const {
  const TrackerHealth health = trackers_[sensor.tracker]->health(now_s());
  return fmt::format("tracker {} is {}{}{}", rig_.trackers[sensor.tracker].name, toString(health.state),
                     health.message.empty() ? "" : ": ", health.message);
}

}  // namespace carom
