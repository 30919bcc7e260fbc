#include "devices/usb/hid_transport.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "devices/tracker/retry.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kLookForHid = 500ms;
constexpr auto kTick = 10ms;

/// Until it is gone or a stop is asked for.
void serve(HidDevice& device, const std::stop_token& stop, DeviceSink& sink, HidListener& listener) {
  std::array<std::uint8_t, 256> bytes;  // four times the longest report
  listener.connected(device);
  while (!stop.stop_requested()) {
    const int size = device.read(bytes, kTick);
    const Clock::time_point now = Clock::now();
    if (size < 0) return;
    if (size > 0) listener.report({bytes.data(), static_cast<std::size_t>(size)}, now, sink);
    listener.tick(device, now, sink);
  }
}

}  // namespace

void listenToHid(const std::stop_token& stop, DeviceSink& sink, HidListener& listener) {
  retry(stop, sink, kLookForHid, [&] {
    const std::vector<HidEntry> entries = listHid();
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const HidEntry& entry) { return listener.wants(entry); });
    if (found == entries.end()) throw std::runtime_error(listener.name() + " is not plugged in");
    HidDevice device(found->node);
    if (!device.isOpen()) {
      throw NeedsHelp(listener.name() + ": " + found->node +
                      " may not be opened by this user: copy config/udev/70-carom.rules to /etc/udev/rules.d "
                      "and plug the device in again");
    }
    sink.connected();
    serve(device, stop, sink, listener);
    listener.disconnected(Clock::now(), sink);
    if (!stop.stop_requested()) throw std::runtime_error(listener.name() + " was unplugged");
  });
}

}  // namespace carom
