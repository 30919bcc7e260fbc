#pragma once
// A 3Dconnexion SpaceMouse: six axes and buttons to steer by.

#include <optional>

#include "devices/tracker/device_tracker.h"
#include "devices/usb/hid_device.h"
#include "devices/usb/usb_address.h"

namespace carom {

/// Whether it is one. Its makers' other devices (mice, keyboards) are not.
bool isSpaceMouse(const HidEntry& entry);

/// The SpaceMouse at that address, or the first one that is plugged in, whenever that is. Delivers axes and
/// buttons of sensor 0 as SpaceMouseDecoder numbers them, no poses. An axis that the device says no more of
/// for 50 ms is zero; when it is unplugged, all axes are zero and all buttons are let go. Throws
/// std::invalid_argument where nothing at the address can be a SpaceMouse.
Transport spaceMouseTransport(const std::optional<UsbAddress>& address);

}  // namespace carom
