#include "devices/usb/hid_device.h"

#include <mutex>

#include <hidapi.h>

namespace carom {
namespace {

/// hidapi keeps its last error for the whole program: listing, opening and closing take turns.
std::mutex& turn() {
  static std::mutex mutex;
  return mutex;
}

/// Letters beyond ASCII become '?': names and serial numbers are for people and for comparing.
std::string narrow(const wchar_t* text) {
  std::string narrowed;
  for (; text != nullptr && *text != L'\0'; ++text) {
    narrowed += *text >= L' ' && *text < 127 ? static_cast<char>(*text) : '?';
  }
  return narrowed;
}

}  // namespace

std::vector<HidEntry> listHid() {
  const std::lock_guard lock(turn());
  std::vector<HidEntry> entries;
  hid_device_info* const first = hid_enumerate(0, 0);
  for (const hid_device_info* info = first; info != nullptr; info = info->next) {
    entries.push_back({info->path, info->vendor_id, info->product_id, narrow(info->product_string),
                       narrow(info->serial_number), info->usage_page, info->usage,
                       info->bus_type == HID_API_BUS_USB});
  }
  hid_free_enumeration(first);
  return entries;
}

HidDevice::HidDevice(const std::string& node) {
  const std::lock_guard lock(turn());
  device_.reset(hid_open_path(node.c_str()));
}

int HidDevice::read(std::span<std::uint8_t> report, std::chrono::milliseconds wait) {
  return hid_read_timeout(device_.get(), report.data(), report.size(), static_cast<int>(wait.count()));
}

bool HidDevice::write(std::span<const std::uint8_t> report) {
  return hid_write(device_.get(), report.data(), report.size()) >= 0;
}

bool HidDevice::sendFeature(std::span<const std::uint8_t> report) {
  return hid_send_feature_report(device_.get(), report.data(), report.size()) >= 0;
}

void HidDevice::Close::operator()(hid_device_* device) const {
  const std::lock_guard lock(turn());
  hid_close(device);
}

}  // namespace carom
