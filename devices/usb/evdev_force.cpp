#include "devices/usb/evdev_force.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "devices/tracker/retry.h"

namespace carom {
namespace {

constexpr const char* kFolder = "/dev/input";
constexpr const char* kRights =
    " may not be opened by this user: add the user to the group 'input', or copy config/udev/70-carom.rules "
    "to "
    "/etc/udev/rules.d and plug it in again";
constexpr int kMostLevel = 32767;

/// A node that is open.
class Node {
 public:
  explicit Node(const std::string& path)
      : descriptor_(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC)) {}
  Node(Node&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Node& operator=(Node&&) = delete;
  ~Node() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  bool isOpen() const { return descriptor_ >= 0; }
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Bits of a device, as EVIOCGBIT gives them.
template <std::size_t Count>
struct Bits {
  std::array<std::uint8_t, Count / 8 + 1> bytes{};
  bool has(int bit) const { return (bytes[static_cast<std::size_t>(bit) / 8] >> (bit % 8) & 1) != 0; }
};

template <std::size_t Count>
Bits<Count> bitsOf(int descriptor, int type) {
  Bits<Count> bits;
  if (::ioctl(descriptor, EVIOCGBIT(static_cast<unsigned>(type), bits.bytes.size()), bits.bytes.data()) < 0)
    bits = {};
  return bits;
}

EvdevForceFacts factsOf(const std::string& path, const Node& node) {
  EvdevForceFacts facts;
  facts.node = path;
  std::array<char, 128> name{};
  if (::ioctl(node.get(), EVIOCGNAME(name.size() - 1), name.data()) >= 0) {
    for (const char c : std::string(name.data())) facts.name += c >= ' ' && c < 127 ? c : '?';
  }
  const auto types = bitsOf<EV_MAX>(node.get(), 0);
  if (types.has(EV_FF)) {
    const auto effects = bitsOf<FF_MAX>(node.get(), EV_FF);
    facts.constant = effects.has(FF_CONSTANT);
    facts.rumble = effects.has(FF_RUMBLE);
    facts.gain = effects.has(FF_GAIN);
  }
  if (types.has(EV_ABS)) {
    const auto axes = bitsOf<ABS_MAX>(node.get(), EV_ABS);
    facts.axes = (axes.has(ABS_X) ? 1 : 0) + (axes.has(ABS_X) && axes.has(ABS_Y) ? 1 : 0);
  }
  if (::ioctl(node.get(), EVIOCGEFFECTS, &facts.effects) < 0) facts.effects = 0;
  return facts;
}

/// One axis of a stick.
struct Axis {
  int code = ABS_X;
  double middle = 0.0, half = 1.0, deflection = 0.0;

  void read(int descriptor) {
    input_absinfo info{};
    if (::ioctl(descriptor, EVIOCGABS(static_cast<unsigned>(code)), &info) < 0 ||
        info.maximum <= info.minimum)
      return;
    middle = 0.5 * (static_cast<double>(info.minimum) + info.maximum);
    half = 0.5 * (static_cast<double>(info.maximum) - info.minimum);
    take(info.value);
  }
  void take(double value) { deflection = std::clamp((value - middle) / half, -1.0, 1.0); }
};

class EvdevForce : public ForceDevice {
 public:
  EvdevForce(Node node, EvdevForceFacts facts, double forceMax_n, const RoomAxes& axes)
      : node_(std::move(node)), facts_(std::move(facts)), forceMax_n_(forceMax_n), axes_(axes) {
    stick_[1].code = ABS_Y;
    for (Axis& axis : stick_) axis.read(node_.get());
    readKeys();
    if (facts_.gain) send(EV_FF, FF_GAIN, 0xFFFF);
  }
  ~EvdevForce() override {
    zero();
    if (id_ >= 0) ::ioctl(node_.get(), EVIOCRMFF, static_cast<int>(id_));
  }

  ForceDeviceState read(double now_s) override {
    takeEvents();
    ForceDeviceState state;
    state.position_m = kStick_m * (stick_[0].deflection * axes_.right - stick_[1].deflection * axes_.forward);
    state.time_s = now_s;
    state.pressed = pressed_.any();
    state.held_n = held_n_;
    return state;
  }

  void write(const ForceCommand& command) override {
    held_n_ = facts_.constant ? command.force_n : glm::dvec3(0.0);
    upload(facts_.constant ? constantFor(command.force_n) : rumbleFor(command.rumble));
  }

  void zero() noexcept override {
    if (id_ >= 0) send(EV_FF, static_cast<std::uint16_t>(id_), 0, false);
    isPlaying_ = false;
    last_ = {};
  }

 private:
  /// The direction is the one that the force comes from, in steps of 0x4000 for 90°: 0 is from below (from
  /// the user), 0x4000 from the left. A device of one axis has a sign in its place.
  ff_effect constantFor(const glm::dvec3& force_n) const {
    const double right = glm::dot(force_n, axes_.right) / forceMax_n_,
                 back = -glm::dot(force_n, axes_.forward) / forceMax_n_;
    ff_effect effect{};
    effect.type = FF_CONSTANT;
    effect.direction = 0x4000;
    double level = right;
    if (facts_.axes != 1) {
      level = std::hypot(right, back);
      const double turns = std::atan2(right, -back) / (2.0 * std::numbers::pi);
      effect.direction = static_cast<std::uint16_t>(std::lround(65536.0 * turns) & 0xFFFF);
    }
    effect.u.constant.level =
        static_cast<std::int16_t>(std::lround(kMostLevel * std::clamp(level, -1.0, 1.0)));
    return effect;
  }
  static ff_effect rumbleFor(double strength) {
    ff_effect effect{};
    effect.type = FF_RUMBLE;
    effect.u.rumble.strong_magnitude =
        static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(strength, 0.0, 1.0)));
    effect.u.rumble.weak_magnitude = effect.u.rumble.strong_magnitude;
    return effect;
  }
  static bool isSilent(const ff_effect& effect) {
    return effect.type == FF_RUMBLE ? effect.u.rumble.strong_magnitude == 0 : effect.u.constant.level == 0;
  }
  static bool isSame(const ff_effect& a, const ff_effect& b) {
    if (a.type != b.type) return false;
    if (a.type == FF_RUMBLE) return a.u.rumble.strong_magnitude == b.u.rumble.strong_magnitude;
    return a.direction == b.direction && a.u.constant.level == b.u.constant.level;
  }

  /// Uploads an effect, once it is another one: with its number it is changed while it plays. Its length is
  /// endless; the kernel removes it when the file is closed.
  void upload(ff_effect effect) {
    if (isSilent(effect)) {
      if (isPlaying_) zero();
      return;
    }
    effect.id = static_cast<std::int16_t>(id_);
    if (isPlaying_ && isSame(effect, last_)) return;
    if (::ioctl(node_.get(), EVIOCSFF, &effect) < 0) fail("the effect was refused");
    last_ = effect;
    id_ = effect.id;
    if (!std::exchange(isPlaying_, true)) send(EV_FF, static_cast<std::uint16_t>(id_), 1);
  }

  void send(std::uint16_t type, std::uint16_t code, std::int32_t value, bool mustSucceed = true) {
    input_event event{};
    event.type = type;
    event.code = code;
    event.value = value;
    const bool isSent = ::write(node_.get(), &event, sizeof event) == static_cast<ssize_t>(sizeof event);
    if (!isSent && mustSucceed) fail("it takes no events");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(errno == ENODEV || errno == EIO ? "it was pulled out"
                                                             : what + " (" + std::strerror(errno) + ")");
  }

  struct Keys : Bits<KEY_MAX> {
    bool any() const {
      for (int key = BTN_MISC; key < KEY_OK; ++key) {
        if (has(key)) return true;
      }
      return false;
    }
    void set(int key, bool isDown) {
      const auto bit = static_cast<std::uint8_t>(1U << (key % 8));
      std::uint8_t& byte = bytes[static_cast<std::size_t>(key) / 8];
      byte = static_cast<std::uint8_t>(isDown ? byte | bit : byte & ~bit);
    }
  };

  void readKeys() {
    if (::ioctl(node_.get(), EVIOCGKEY(pressed_.bytes.size()), pressed_.bytes.data()) < 0) pressed_ = {};
  }

  void takeEvents() {
    std::array<input_event, 64> events;
    for (int portions = 0; portions < 4; ++portions) {
      const ssize_t got = ::read(node_.get(), events.data(), sizeof events);
      if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
      if (got <= 0) fail("it cannot be read");
      const auto count = static_cast<std::size_t>(got) / sizeof(input_event);
      for (std::size_t i = 0; i < count; ++i) take(events[i]);
      if (count < events.size()) return;
    }
  }

  void take(const input_event& event) {
    if (event.type == EV_KEY && event.code <= KEY_MAX) pressed_.set(event.code, event.value != 0);
    if (event.type == EV_ABS && event.code <= ABS_Y) stick_[event.code == ABS_X ? 0 : 1].take(event.value);
    if (event.type != EV_SYN || event.code != SYN_DROPPED) return;
    for (Axis& axis : stick_) axis.read(node_.get());
    readKeys();
  }

  Node node_;
  EvdevForceFacts facts_;
  double forceMax_n_;
  RoomAxes axes_;
  std::array<Axis, 2> stick_{};
  Keys pressed_{};
  glm::dvec3 held_n_{0.0};
  ff_effect last_{};
  int id_ = -1;
  bool isPlaying_ = false;
};

/// Returns the nodes of events, in the order of their numbers.
std::vector<std::string> nodes() {
  std::vector<std::string> found;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(kFolder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().starts_with("event")) found.push_back(entry->path().string());
  }
  std::sort(found.begin(), found.end(), [](const std::string& a, const std::string& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  return found;
}

}  // namespace

std::string EvdevForceFacts::words() const {
  std::string words;
  const auto add = [&words](const std::string& what) { words += (words.empty() ? "" : ", ") + what; };
  if (constant) add(axes == 1 ? "constant force on 1 axis" : "constant force on 2 axes");
  if (rumble) add("rumble");
  if (gain) add("gain");
  return words + "; " + std::to_string(effects) + " effects";
}

std::vector<EvdevForceFacts> listEvdevForces() {
  std::vector<EvdevForceFacts> listed;
  for (const std::string& path : nodes()) {
    const Node node(path);
    EvdevForceFacts facts;
    if (node.isOpen()) {
      facts = factsOf(path, node);
    } else if (errno == EACCES || errno == EPERM) {
      facts.node = path;
      facts.problem = path + kRights;
    }
    if (facts.hasForce() || !facts.problem.empty()) listed.push_back(facts);
  }
  return listed;
}

std::unique_ptr<ForceDevice> openEvdevForce(const std::string& given, double forceMax_n,
                                            const RoomAxes& axes) {
  std::string path = given;
  if (path.empty()) {
    const std::vector<EvdevForceFacts> listed = listEvdevForces();
    const auto found = std::find_if(listed.begin(), listed.end(),
                                    [](const EvdevForceFacts& facts) { return facts.hasForce(); });
    if (found == listed.end() && !listed.empty()) throw NeedsHelp(listed.front().problem);
    if (found == listed.end()) throw std::runtime_error("no input device with force is plugged in");
    path = found->node;
  }
  Node node(path);
  if (!node.isOpen() && (errno == EACCES || errno == EPERM)) throw NeedsHelp(path + kRights);
  if (!node.isOpen()) throw std::runtime_error(path + " is not there (" + std::strerror(errno) + ")");
  EvdevForceFacts facts = factsOf(path, node);
  if (!facts.hasForce())
    throw NeedsHelp(path + " (" + facts.name +
                    ") has no force, expected a device with constant force or rumble");
  if (::flock(node.get(), LOCK_EX | LOCK_NB) != 0)
    throw NeedsHelp(path + " (" + facts.name + ") is the force device of another session");
  return std::make_unique<EvdevForce>(std::move(node), std::move(facts), forceMax_n, axes);
}

}  // namespace carom
