#include "devices/setup/tracker_factory.h"

#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "devices/network/dtrack_tracker.h"
#include "devices/network/natnet_tracker.h"
#include "devices/network/vrpn_tracker.h"
#include "devices/tracker/recorded_tracker.h"
#include "devices/tracker/simulated_tracker.h"
#include "devices/tracker/trace.h"
#include "devices/usb/hid_imu_tracker.h"
#include "devices/usb/polhemus_tracker.h"
#include "devices/usb/spacemouse.h"

namespace carom {
namespace {

UsbAddress usbAddress(const std::string& source) {
  const auto address = parseUsbAddress(source);
  if (!address) {
    throw std::invalid_argument("source is '" + source +
                                "', expected vid:pid or vid:pid:serial, such as '0f44:ff12'");
  }
  return *address;
}

/// A headset that no session follows.
class UnfollowedHeadset : public Tracker {
 public:
  void poll(double, std::vector<TrackerSample>&) override {}
  TrackerHealth health(double) const override {
    TrackerHealth health;
    health.state = TrackerHealth::State::failed;
    health.message = "a headset is followed by a session alone: carom cave";
    return health;
  }
};

}  // namespace

bool isDevice(TrackerKind kind) { return kind != TrackerKind::simulated && kind != TrackerKind::recorded; }

Transport createTransport(TrackerKind kind, const std::string& source, const RoomAxes& axes) {
  switch (kind) {
    case TrackerKind::vrpn:
      return vrpnTransport(readVrpnSource(source));
    case TrackerKind::dtrack:
      return dtrackTransport(readDtrackSource(source));
    case TrackerKind::natnet:
      return natnetTransport(readNatnetSource(source));
    case TrackerKind::polhemusUsb:
      return polhemusTransport(usbAddress(source));
    case TrackerKind::hidImu:
      return hidImuTransport(usbAddress(source), axes.up * kStandingEyes_m, axes);
    case TrackerKind::spaceMouse:
      return spaceMouseTransport(source.empty() ? std::nullopt : std::optional(usbAddress(source)));
    case TrackerKind::simulated:
    case TrackerKind::recorded:
    case TrackerKind::headset:
      break;
  }
  throw std::logic_error("createTransport: this tracker is no device");
}

std::unique_ptr<Tracker> createTracker(const TrackerSetup& setup, const RoomAxes& axes,
                                       std::chrono::steady_clock::time_point sessionStart) {
  if (setup.kind == TrackerKind::recorded) return std::make_unique<RecordedTracker>(readTrace(setup.source));
  if (setup.kind == TrackerKind::simulated) {
    SimulatedPerson person;
    person.seed = setup.seed;
    person.axes = axes;
    person.still = setup.person == SimulatedMotion::still;
    person.walks = setup.person == SimulatedMotion::walks;
    return std::make_unique<SimulatedTracker>(person);
  }
  if (setup.kind == TrackerKind::headset) return std::make_unique<UnfollowedHeadset>();
  Transport transport;
  if (setup.kind == TrackerKind::dtrack) {
    DtrackSource source = readDtrackSource(setup.source.string());
    source.start = setup.start;
    transport = dtrackTransport(source);
  } else {
    transport = createTransport(setup.kind, setup.source.string(), axes);
  }
  const bool saysNothingAtRest =
      setup.kind == TrackerKind::spaceMouse || (setup.kind == TrackerKind::vrpn && setup.buttonsAlone);
  if (!saysNothingAtRest) {
    return std::make_unique<DeviceTracker>(std::move(transport), sessionStart);
  }
  // It may send nothing until it is touched.
  constexpr double kNeverSilent_s = std::numeric_limits<double>::infinity();
  return std::make_unique<DeviceTracker>(std::move(transport), sessionStart, kNeverSilent_s);
}

}  // namespace carom
