#pragma once
// A 3Dconnexion SpaceMouse: six axes and buttons for steering.

#include <optional>

#include "devices/tracker/device_tracker.h"
#include "devices/usb/hid_device.h"
#include "devices/usb/usb_address.h"

namespace carom {

/// Whether the device is a SpaceMouse. The makers' other devices (mice, keyboards) are not.
bool isSpaceMouse(const HidEntry& entry);

/// Returns the transport of the SpaceMouse at that address, or of the first one that is plugged in, at any
/// time. Delivers axes and buttons of sensor 0 as SpaceMouseDecoder numbers them, and no poses. An axis that
/// the device has not sent for 50 ms counts as zero. When the device is unplugged, all axes are zero and all
/// buttons are released. Throws std::invalid_argument if nothing at the address can be a SpaceMouse.
Transport spaceMouseTransport(const std::optional<UsbAddress>& address);

}  // namespace carom
