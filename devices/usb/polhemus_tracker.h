#pragma once
// A Polhemus tracker on USB: FASTRAK, PATRIOT, LIBERTY.

#include "devices/tracker/device_tracker.h"
#include "devices/usb/usb_address.h"

namespace carom {

/// Sensor 0 is station 1. Positions are in the source's axes, in the hemisphere that the device is set to.
/// The device is set to binary, continuous records in metric units with its own filters off; it is left quiet
/// at the end. It is found again when it was unplugged, and asked again when it has said nothing for two
/// seconds. Throws std::invalid_argument where the address names no Polhemus tracker.
Transport polhemusTransport(const UsbAddress& address);

}  // namespace carom
