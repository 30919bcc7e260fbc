#pragma once
// A Polhemus tracker on USB: FASTRAK, PATRIOT, LIBERTY.

#include "devices/tracker/device_tracker.h"
#include "devices/usb/usb_address.h"

namespace carom {

/// Returns the transport of a Polhemus tracker. Sensor 0 is station 1. Positions are in the source's axes, in
/// the hemisphere that the device is set to. The transport sets the device to binary, continuous records in
/// metric units, turns its own filters off, and stops its records at the end. It finds the device again after
/// it was unplugged, and asks again if it has sent nothing for two seconds. Throws std::invalid_argument if
/// the address names no Polhemus tracker.
Transport polhemusTransport(const UsbAddress& address);

}  // namespace carom
