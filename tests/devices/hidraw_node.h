#pragma once
// A HID device behind a mocked /dev/hidraw0: reports keep their borders and come when a test says.

#include <linux/hidraw.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "devices/mocked_kernel.h"

namespace carom::test {

using Bytes = std::vector<std::uint8_t>;

class HidrawNode : public MockedNode {
 public:
  static constexpr const char* kNode = "/dev/hidraw0";
  static constexpr const char* kUsb = "/devices/pci0000:00/0000:00:14.0/usb1/1-2";

  /// A report descriptor of one application collection with that usage.
  HidrawNode(std::uint16_t vendor, std::uint16_t product, std::string name, std::uint8_t usagePage,
             std::uint8_t usage)
      : vendor_(vendor), product_(product), name_(std::move(name)), descriptor_{5, usagePage, 9, usage, 0xa1,
                                                                                1, 0x85,      1, 0xc0} {}

  void plugInto(MockedKernel& kernel) {
    kernel.attach(kNode, *this);
    kernel.plugIn(description());
  }

  /// What umockdev is told of it.
  std::string description() const {
    std::string descriptor;
    for (const std::uint8_t byte : descriptor_) {
      char two[3];
      std::snprintf(two, sizeof two, "%02X", unsigned{byte});
      descriptor += two;
    }
    return "P: " + hidrawPath() +
           "\nN: hidraw0=00\nE: DEVNAME=/dev/hidraw0\nE: MAJOR=240\nE: MINOR=0\nE: SUBSYSTEM=hidraw\nA: "
           "dev=240:0\\n\n"
           "L: device=../../../0003:" +
           ids("%04X:%04X.0001") + "\n\nP: " + hidPath() + "\nE: HID_ID=0003:" + ids("%08X:%08X") +
           "\nE: HID_NAME=" + name_ +
           "\nE: HID_UNIQ=S1\nE: SUBSYSTEM=hid\nH: report_descriptor=" + descriptor +
           "\n\nP: /devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0\nE: DEVTYPE=usb_interface\nE: "
           "SUBSYSTEM=usb\n"
           "A: bInterfaceNumber=00\\n\n\n"
           "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\n"
           "A: manufacturer=Maker\\n\nA: product=" +
           name_ + "\\n\nA: serial=S1\\n\nA: bcdDevice=0100\\n\n";
  }

  void unplugFrom(MockedKernel& kernel) {
    {
      const std::lock_guard lock(mutex_);
      gone_ = true;
    }
    for (const std::string& path :
         {hidrawPath(), hidPath(), std::string(kUsb) + "/1-2:1.0", std::string(kUsb)}) {
      kernel.unplug("/sys" + path);
    }
  }

  void send(const Bytes& report) {
    const std::lock_guard lock(mutex_);
    reports_.push_back(report);
  }

  std::vector<Bytes> features() const {
    const std::lock_guard lock(mutex_);
    return features_;
  }

  /// Output reports, in order.
  std::vector<Bytes> written() const {
    const std::lock_guard lock(mutex_);
    return written_;
  }
  /// Every report takes so long to write.
  void takeLong(std::chrono::milliseconds each) {
    const std::lock_guard lock(mutex_);
    writing_ = each;
  }

  std::size_t unread() const {
    const std::lock_guard lock(mutex_);
    return reports_.size();
  }

 protected:
  bool ioctl(UMockdevIoctlClient* client, gulong request, UMockdevIoctlData* argument) override {
    const std::lock_guard lock(mutex_);
    if (_IOC_TYPE(request) != 'H') return false;
    UMockdevIoctlData* const data = umockdev_ioctl_data_resolve(argument, 0, _IOC_SIZE(request), nullptr);
    if (data == nullptr) return false;
    const long result = answer(request, *data);
    umockdev_ioctl_data_unref(data);
    umockdev_ioctl_client_complete(client, result, result < 0 ? ENOTTY : 0);
    return true;
  }

  /// One report for each read, as the kernel does. Nothing for 2 ms: as if poll had waited so long.
  bool read(UMockdevIoctlClient* client, UMockdevIoctlData* buffer) override {
    std::unique_lock lock(mutex_);
    if (gone_) {
      umockdev_ioctl_client_complete(client, -1, EIO);
      return true;
    }
    if (reports_.empty()) {
      lock.unlock();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      umockdev_ioctl_client_complete(client, -1, EAGAIN);
      return true;
    }
    Bytes report = reports_.front();
    reports_.pop_front();
    report.resize(std::min(report.size(), static_cast<std::size_t>(buffer->data_len)));
    umockdev_ioctl_data_update(buffer, 0, report.data(), static_cast<int>(report.size()));
    umockdev_ioctl_client_complete(client, static_cast<long>(report.size()), 0);
    return true;
  }

  bool write(UMockdevIoctlClient* client, UMockdevIoctlData* bytes) override {
    std::unique_lock lock(mutex_);
    const std::chrono::milliseconds wait = writing_;
    lock.unlock();
    std::this_thread::sleep_for(wait);
    lock.lock();
    if (gone_) {
      umockdev_ioctl_client_complete(client, -1, ENODEV);
      return true;
    }
    written_.emplace_back(bytes->data, bytes->data + bytes->data_len);
    umockdev_ioctl_client_complete(client, bytes->data_len, 0);
    return true;
  }

 private:
  long answer(gulong request, UMockdevIoctlData& data) {
    switch (_IOC_NR(request)) {
      case _IOC_NR(HIDIOCGRDESCSIZE): {
        const int size = static_cast<int>(descriptor_.size());
        std::memcpy(data.data, &size, sizeof size);
        return 0;
      }
      case _IOC_NR(HIDIOCGRDESC): {
        hidraw_report_descriptor filled{};
        filled.size = static_cast<std::uint32_t>(descriptor_.size());
        std::copy(descriptor_.begin(), descriptor_.end(), filled.value);
        std::memcpy(data.data, &filled, sizeof filled);
        return 0;
      }
      case _IOC_NR(HIDIOCSFEATURE(0)):
        features_.emplace_back(data.data, data.data + data.data_len);
        return data.data_len;
      default:
        return -1;
    }
  }

  std::string ids(const char* format) const {
    char text[64];
    std::snprintf(text, sizeof text, format, unsigned{vendor_}, unsigned{product_});
    return text;
  }
  std::string hidPath() const { return kUsb + ids("/1-2:1.0/0003:%04X:%04X.0001"); }
  std::string hidrawPath() const { return hidPath() + "/hidraw/hidraw0"; }

  const std::uint16_t vendor_, product_;
  const std::string name_;
  const Bytes descriptor_;
  mutable std::mutex mutex_;
  std::deque<Bytes> reports_;
  std::vector<Bytes> features_, written_;
  std::chrono::milliseconds writing_{0};
  bool gone_ = false;
};

}  // namespace carom::test
