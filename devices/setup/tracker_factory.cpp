#include "devices/setup/tracker_factory.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "devices/network/dtrack_tracker.h"
#include "devices/network/natnet_tracker.h"
#include "devices/network/osc_tracker.h"
#include "devices/network/qtm_tracker.h"
#include "devices/network/vrpn_tracker.h"
#include "devices/programs/survive_tracker.h"
#include "devices/programs/trackd_tracker.h"
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

Transport makeVrpn(const TrackerSetup& setup, const RoomAxes&) {
  return vrpnTransport(readVrpnSource(setup.source.string()));
}
Transport makeDtrack(const TrackerSetup& setup, const RoomAxes&) {
  DtrackSource source = readDtrackSource(setup.source.string());
  source.start = setup.start;
  return dtrackTransport(source);
}
Transport makeNatnet(const TrackerSetup& setup, const RoomAxes&) {
  return natnetTransport(readNatnetSource(setup.source.string()));
}
Transport makeQtm(const TrackerSetup& setup, const RoomAxes&) {
  return qtmTransport(readQtmServer(setup.source.string()), setup.names);
}
Transport makeTrackd(const TrackerSetup& setup, const RoomAxes&) {
  return trackdTransport(readTrackdSource(setup.source.string()), setup.unit_m);
}
Transport makeSurvive(const TrackerSetup& setup, const RoomAxes&) {
  return surviveTransport(
      setup.source.empty() ? std::nullopt : std::optional(readSurviveServer(setup.source.string())),
      setup.names);
}
Transport makeOsc(const TrackerSetup& setup, const RoomAxes&) {
  return oscTransport(readOscSource(setup.source.string()), setup.osc);
}
Transport makePolhemus(const TrackerSetup& setup, const RoomAxes&) {
  return polhemusTransport(usbAddress(setup.source.string()));
}
Transport makeHidImu(const TrackerSetup& setup, const RoomAxes& axes) {
  return hidImuTransport(usbAddress(setup.source.string()), axes.up * kStandingEyes_m, axes);
}
Transport makeSpaceMouse(const TrackerSetup& setup, const RoomAxes&) {
  return spaceMouseTransport(setup.source.empty() ? std::nullopt
                                                  : std::optional(usbAddress(setup.source.string())));
}

using Kind = TrackerKind;
using Source = SourceUse;
constexpr std::array kTrackerRows{
    TrackerRow{Kind::simulated, "simulated", true, Source::none, "person", nullptr},
    TrackerRow{Kind::recorded, "recorded", true, Source::trace, "", nullptr},
    TrackerRow{Kind::vrpn, "vrpn", true, Source::address, "", makeVrpn},
    TrackerRow{Kind::dtrack, "dtrack", true, Source::address, "start", makeDtrack},
    TrackerRow{Kind::natnet, "natnet", true, Source::address, "", makeNatnet},
    TrackerRow{Kind::qtm, "qtm", true, Source::address, "names", makeQtm},
    TrackerRow{Kind::trackd, "trackd", true, Source::address, "unit", makeTrackd},
    TrackerRow{Kind::survive, "survive", true, Source::maybeAddress, "names", makeSurvive},
    TrackerRow{Kind::osc, "osc", true, Source::address, "osc", makeOsc},
    TrackerRow{Kind::polhemusUsb, "polhemus-usb", true, Source::address, "", makePolhemus},
    TrackerRow{Kind::hidImu, "hid-imu", true, Source::address, "", makeHidImu},
    TrackerRow{Kind::spaceMouse, "spacemouse", true, Source::maybeAddress, "", makeSpaceMouse},
    TrackerRow{Kind::headset, "headset", false, Source::none, "", nullptr}};
static_assert(kTrackerRows.size() == static_cast<std::size_t>(Kind::headset) + 1, "a kind has no row");
static_assert(std::ranges::is_partitioned(kTrackerRows, &TrackerRow::isInRigs),
              "the kinds of rigs come first, as their key counts them");

/// Whether a tracker may send nothing until it is touched.
bool saysNothingAtRest(const TrackerSetup& setup) {
  switch (setup.kind) {
    case Kind::spaceMouse:
      return true;
    case Kind::vrpn:
      return setup.buttonsAlone;
    case Kind::osc:
      return setup.buttonsAlone || !setup.osc.pose;
    default:
      return false;
  }
}

}  // namespace

bool isDevice(TrackerKind kind) { return kind != TrackerKind::simulated && kind != TrackerKind::recorded; }

std::span<const TrackerRow> trackerRows() { return kTrackerRows; }

std::vector<std::string_view> trackerNamesInRigs() {
  std::vector<std::string_view> names;
  for (const TrackerRow& row : kTrackerRows) {
    if (row.isInRigs) names.push_back(row.name);
  }
  return names;
}

const TrackerRow& rowOf(TrackerKind kind) {
  return *std::find_if(kTrackerRows.begin(), kTrackerRows.end(),
                       [&](const TrackerRow& row) { return row.kind == kind; });
}

std::string_view toString(TrackerKind kind) { return rowOf(kind).name; }

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
  Transport transport = rowOf(setup.kind).make(setup, axes);
  if (!saysNothingAtRest(setup)) {
    return std::make_unique<DeviceTracker>(std::move(transport), sessionStart);
  }
  constexpr double kNeverSilent_s = std::numeric_limits<double>::infinity();
  return std::make_unique<DeviceTracker>(std::move(transport), sessionStart, kNeverSilent_s);
}

}  // namespace carom
