#pragma once
// The inertial sensor of a headset on USB (Oculus Rift DK1, DK2) as a head tracker for use at a desk.

#include "devices/tracker/device_tracker.h"
#include "devices/tracker/simulated_tracker.h"
#include "devices/usb/usb_address.h"

namespace carom {

/// Returns the transport of a headset, whose head turns but stays in one place: such a sensor does not
/// measure position. Tilt is true; heading begins at the front and drifts by some degrees a minute (see
/// OrientationFilter). It delivers a thousand samples a second, on the device's clock. `standing_m` is the
/// position of the head in the tracker's axes, which are `axes`. Throws std::invalid_argument if the address
/// names no such headset.
Transport hidImuTransport(const UsbAddress& address, const glm::dvec3& standing_m, const RoomAxes& axes = {});

/// Returns the name of the headset; null if it is not supported.
const char* headsetName(std::uint16_t vendor, std::uint16_t product);

}  // namespace carom
