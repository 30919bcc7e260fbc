#pragma once
// The inertial sensor of a headset on USB (Oculus Rift DK1, DK2) as a head tracker for use at a desk.

#include "devices/tracker/device_tracker.h"
#include "devices/tracker/simulated_tracker.h"
#include "devices/usb/usb_address.h"

namespace carom {

/// A head that turns and stays in one place: such a sensor knows nothing of position. Tilt is true, heading
/// begins at the front and drifts by some degrees a minute (see OrientationFilter). A thousand samples a
/// second, on the device's clock. `standing_m` is where the head is, in the tracker's axes, which are `axes`.
/// Throws std::invalid_argument where the address names no such headset.
Transport hidImuTransport(const UsbAddress& address, const glm::dvec3& standing_m, const RoomAxes& axes = {});

/// What the headset is called; null where it is none of ours.
const char* headsetName(std::uint16_t vendor, std::uint16_t product);

}  // namespace carom
