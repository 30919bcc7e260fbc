#include "devices/usb/device_list.h"

#include <unistd.h>

#include "devices/usb/hid_device.h"
#include "devices/usb/hid_imu_tracker.h"
#include "devices/usb/polhemus_models.h"
#include "devices/usb/spacemouse.h"
#include "devices/usb/usb_address.h"
#include "devices/usb/usb_handles.h"

namespace carom {
namespace {

/// What keeps this user from opening the node.
std::string accessProblem(const std::string& node) {
  if (access(node.c_str(), R_OK | W_OK) == 0) return {};
  return "may not be opened by this user: copy config/udev/70-carom.rules to /etc/udev/rules.d and plug it "
         "in again";
}

std::string serialOfClosed(const UsbDeviceEntry& entry) {
  libusb_device_handle* opened = nullptr;
  if (libusb_open(entry.device.get(), &opened) != LIBUSB_SUCCESS) return {};
  const UsbHandle handle(opened);
  return serialOf(opened);
}

void listPolhemus(std::vector<ListedDevice>& devices) {
  const UsbContext context = openUsb();
  if (!context) return;
  for (const UsbDeviceEntry& entry : listUsb(context.get())) {
    const PolhemusModel* const model = findPolhemusModel(entry.product);
    if (entry.vendor != kPolhemusVendor || model == nullptr) continue;
    ListedDevice device{std::string("Polhemus ") + model->name,
                        "polhemus-usb",
                        toString(UsbAddress{entry.vendor, model->product, {}}),
                        {},
                        entry.place + ", " + entry.node,
                        accessProblem(entry.node)};
    if (entry.product == model->bareProduct) {
      device.problem = "needs firmware: load its .hex file with fxload";
    } else if (device.problem.empty()) {
      device.serial = serialOfClosed(entry);
    }
    devices.push_back(device);
  }
}

void listHidDevices(std::vector<ListedDevice>& devices) {
  for (const HidEntry& entry : listHid()) {
    const char* const headset = headsetName(entry.vendor, entry.product);
    if (headset == nullptr && !isSpaceMouse(entry)) continue;
    devices.push_back({headset != nullptr ? headset : entry.name,
                       headset != nullptr ? "hid-imu" : "spacemouse",
                       toString(UsbAddress{entry.vendor, entry.product, {}}), entry.serial, entry.node,
                       accessProblem(entry.node)});
  }
}

}  // namespace

std::vector<ListedDevice> listDevices() {
  std::vector<ListedDevice> devices;
  listPolhemus(devices);
  listHidDevices(devices);
  return devices;
}

}  // namespace carom
