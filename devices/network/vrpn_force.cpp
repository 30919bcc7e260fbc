#include "devices/network/vrpn_force.h"

#include <array>
#include <chrono>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>

#include "devices/network/only_session.h"
#include "devices/network/socket.h"
#include "devices/protocol/vrpn_decoder.h"
#include "devices/tracker/retry.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kGreetsWithin = 3s;

class VrpnForce : public ForceDevice {
 public:
  VrpnForce(const VrpnSource& source, const std::stop_token& stop)
      : source_(source),
        only_(source.sender + " at " + toString(source.server)),
        decoder_(source.sender),
        socket_(Socket::connectedTo(resolve(source.server, stop), stop)) {
    socket_.send(vrpnGreeting());
    for (const Clock::time_point begun = Clock::now(); !decoder_.greeted();) {
      if (stop.stop_requested() || Clock::now() - begun > kGreetsWithin)
        throw std::runtime_error("the server at " + toString(source_.server) + " does not greet");
      if (waitReadable({&socket_}, kLookAtStop)) take();
    }
    decoder_.ignoreNames();
    std::vector<std::uint8_t> bytes = vrpnDescription(source_.sender);
    for (const auto& more : {vrpnForceDescription(), vrpnPing()})
      bytes.insert(bytes.end(), more.begin(), more.end());
    socket_.send(bytes);
  }
  ~VrpnForce() override { zero(); }

  ForceDeviceState read(double now_s) override {
    while (waitReadable({&socket_}, 0ms)) {
      if (!take()) break;
    }
    for (const Reading& reading : readings_) {
      if (reading.kind == Reading::Kind::pose && reading.sensor == 0) {
        state_.position_m = reading.pose.position_m;
        state_.time_s = now_s;
      } else if (reading.kind == Reading::Kind::button && reading.index >= 0 && reading.index < 32) {
        const std::uint32_t bit = 1U << reading.index;
        buttons_ = reading.value > 0.5 ? buttons_ | bit : buttons_ & ~bit;
      }
    }
    readings_.clear();
    state_.pressed = buttons_ != 0;
    return state_;
  }

  void write(const ForceCommand& command) override {
    const bool isNothing = command.force_n == glm::dvec3(0.0);
    if (isNothing && wasNothing_) return;
    wasNothing_ = isNothing;
    state_.held_n = command.force_n;
    socket_.send(vrpnForceField(
        {command.at_m, command.force_n, command.stiffness_n_m, isNothing ? 0.0 : kFieldRadius_m}));
  }

  void zero() noexcept override {
    try {
      socket_.send(vrpnForceField({}));
    } catch (const std::exception&) {  // it is gone, and its server ends the field with the connection
    }
    wasNothing_ = true;
  }

 private:
  /// Returns whether more may have come.
  bool take() {
    const auto count = socket_.receive(bytes_);
    if (!count) return false;
    if (*count == 0) throw std::runtime_error("the server at " + toString(source_.server) + " hung up");
    try {
      decoder_.decode({bytes_.data(), *count}, readings_);
    } catch (const std::runtime_error& error) {
      throw NeedsHelp("the server at " + toString(source_.server) + ": " + error.what());
    }
    if (decoder_.takePings() > 0) socket_.send(vrpnPong());
    constexpr std::size_t kMost = 4096;  // a flood is followed in the next ticks
    return *count == bytes_.size() && readings_.size() < kMost;
  }

  VrpnSource source_;
  OnlySession only_;  // a server lets any number of clients push
  VrpnDecoder decoder_;
  Socket socket_;
  std::array<std::uint8_t, VrpnDecoder::kMostBytes> bytes_{};
  std::vector<Reading> readings_;
  ForceDeviceState state_;
  std::uint32_t buttons_ = 0;
  bool wasNothing_ = true;
};

}  // namespace

std::unique_ptr<ForceDevice> openVrpnForce(const VrpnSource& source, const std::stop_token& stop) {
  return std::make_unique<VrpnForce>(source, stop);
}

}  // namespace carom
