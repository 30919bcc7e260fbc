#include "devices/usb/usb_handles.h"

#include <cstdio>

namespace carom {
namespace {

std::string placeOf(libusb_device* device) {
  std::uint8_t ports[8];
  const int count = libusb_get_port_numbers(device, ports, sizeof ports);
  std::string place = "USB " + std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < count; ++i) place += (i == 0 ? '-' : '.') + std::to_string(ports[i]);
  return place;
}

std::string nodeOf(libusb_device* device) {
  char node[40];
  std::snprintf(node, sizeof node, "/dev/bus/usb/%03u/%03u", unsigned{libusb_get_bus_number(device)},
                unsigned{libusb_get_device_address(device)});
  return node;
}

}  // namespace

UsbContext openUsb() {
  libusb_context* context = nullptr;
  return UsbContext(libusb_init(&context) == LIBUSB_SUCCESS ? context : nullptr);
}

std::vector<UsbDeviceEntry> listUsb(libusb_context* context) {
  std::vector<UsbDeviceEntry> entries;
  libusb_device** devices = nullptr;
  const auto count = libusb_get_device_list(context, &devices);
  for (ssize_t i = 0; i < count; ++i) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(devices[i], &descriptor) != LIBUSB_SUCCESS) continue;
    entries.push_back({UsbDevice(libusb_ref_device(devices[i])), descriptor.idVendor, descriptor.idProduct,
                       placeOf(devices[i]), nodeOf(devices[i])});
  }
  if (count >= 0) libusb_free_device_list(devices, 1);
  return entries;
}

std::string serialOf(libusb_device_handle* handle) {
  libusb_device_descriptor descriptor{};
  unsigned char text[128];
  if (libusb_get_device_descriptor(libusb_get_device(handle), &descriptor) != LIBUSB_SUCCESS) return {};
  if (descriptor.iSerialNumber == 0) return {};
  const int size = libusb_get_string_descriptor_ascii(handle, descriptor.iSerialNumber, text, sizeof text);
  return size > 0 ? std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)) : "";
}

}  // namespace carom
