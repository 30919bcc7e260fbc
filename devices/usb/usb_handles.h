#pragma once
// libusb's objects, given back when they are no longer needed.

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

/// Null where the system has no USB at all.
UsbContext openUsb();

/// A device that is plugged in, closed.
struct UsbDeviceEntry {
  UsbDevice device;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string place;  ///< "USB 1-3.2": bus and ports
  std::string node;   ///< "/dev/bus/usb/001/003"
};

/// All that are plugged in.
std::vector<UsbDeviceEntry> listUsb(libusb_context* context);

/// Empty where it has none or may not be asked.
std::string serialOf(libusb_device_handle* handle);

}  // namespace carom
