#pragma once
// Owners of libusb's objects, which release them.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <libusb.h>

namespace carom {

struct UsbContextDeleter {
  void operator()(libusb_context* context) const { libusb_exit(context); }
};
using UsbContext = std::unique_ptr<libusb_context, UsbContextDeleter>;

struct UsbDeviceDeleter {
  void operator()(libusb_device* device) const { libusb_unref_device(device); }
};
using UsbDevice = std::unique_ptr<libusb_device, UsbDeviceDeleter>;

struct UsbHandleDeleter {
  void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using UsbHandle = std::unique_ptr<libusb_device_handle, UsbHandleDeleter>;

/// Opens libusb; returns null if the system has no USB at all.
UsbContext openUsb();

/// A device that is plugged in; not open.
struct UsbDeviceEntry {
  UsbDevice device;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string place;  ///< "USB 1-3.2": bus and ports
  std::string node;   ///< "/dev/bus/usb/001/003"
};

/// Returns all devices that are plugged in.
std::vector<UsbDeviceEntry> listUsb(libusb_context* context);

/// Returns the serial number; empty if the device has none or cannot be asked.
std::string serialOf(libusb_device_handle* handle);

}  // namespace carom
