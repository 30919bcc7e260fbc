#pragma once
// A Polhemus tracker as its manual describes it, behind a mocked usbfs: it takes commands as text and makes
// records of what it was asked for, at its own pace. Written from the manuals, apart from the code it tests.

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <list>
#include <mutex>
#include <numbers>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "devices/mocked_kernel.h"

namespace carom::test {

/// How it looks to the kernel.
struct PolhemusBoxModel {
  bool fastrak = false;
  std::string mark = "LY";
  std::uint16_t product = 0xff12;
  std::uint8_t out = 0x02, in = 0x82, data = 0x82;
  int stations = 2;
};

/// In the names of tests.
inline void PrintTo(const PolhemusBoxModel& model, std::ostream* out) {
  *out << (model.fastrak ? "FASTRAK" : model.mark) << '-' << model.stations;
}

class PolhemusBox : public MockedNode {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr const char* kNode = "/dev/bus/usb/001/003";
  static constexpr const char* kSystemPath = "/sys/devices/pci0000:00/0000:00:14.0/usb1/1-3";
  static constexpr double kRate_hz = 240.0;

  explicit PolhemusBox(const PolhemusBoxModel& model) : model_(model) {}

  /// What umockdev is told of it.
  static std::string description(const PolhemusBoxModel& model);

  // What happens to it; from any thread.
  void breakNextTransfers(int count) { broken_ = count; }  ///< they end with −EPROTO
  void loseBytes(std::size_t count) { lost_ = count; }     ///< out of the stream
  void skipFrames(std::uint32_t count) { skipped_ = count; }
  void flagStation(int station) { flagged_ = station; }  ///< 1 …; 0: none
  void freeze(bool frozen) { frozen_ = frozen; }         ///< says nothing, takes everything
  void pull() { gone_ = true; }                          ///< out of its socket

  // What it has seen.
  std::vector<std::string> commands() const { return locked(commands_); }
  bool continuous() const { return locked(continuous_); }
  bool binary() const { return locked(binary_); }
  std::size_t mostPending() const { return locked(mostPending_); }
  std::uint32_t framesMade() const { return locked(frame_); }

  /// Where a station is: metres. It circles once in four seconds; orientation about z by `angle_rad`.
  static void placeAt(double time_s, int station, double position_m[3], double& angle_rad) {
    angle_rad = 0.5 * std::numbers::pi * time_s;
    position_m[0] = 0.5 + 0.1 * std::cos(angle_rad);
    position_m[1] = 0.1 * std::sin(angle_rad);
    position_m[2] = -0.2 * station;
  }

 protected:
  bool ioctl(UMockdevIoctlClient* client, gulong request, UMockdevIoctlData* argument) override {
    const std::unique_lock lock(mutex_);
    switch (request) {
      case USBDEVFS_GET_CAPABILITIES: {
        const std::uint32_t capabilities = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                           USBDEVFS_CAP_REAP_AFTER_DISCONNECT | USBDEVFS_CAP_ZERO_PACKET;
        UMockdevIoctlData* answer = umockdev_ioctl_data_resolve(argument, 0, sizeof capabilities, nullptr);
        std::memcpy(answer->data, &capabilities, sizeof capabilities);
        umockdev_ioctl_data_unref(answer);
        return complete(client, 0, 0);
      }
      case USBDEVFS_CLAIMINTERFACE:
      case USBDEVFS_DISCONNECT_CLAIM:
      case USBDEVFS_RELEASEINTERFACE:
      case USBDEVFS_CLEAR_HALT:
        return complete(client, gone_ ? -1 : 0, gone_ ? ENODEV : 0);
      case USBDEVFS_SUBMITURB:
        return submit(client, argument);
      case USBDEVFS_DISCARDURB:
        return discard(client, argument);
      case USBDEVFS_REAPURB:
      case USBDEVFS_REAPURBNDELAY:
        return reap(client, argument);
      default:
        return complete(client, -1, ENOTTY);
    }
  }

 private:
  struct Urb {
    UMockdevIoctlData* data;
    usbdevfs_urb* urb() const { return reinterpret_cast<usbdevfs_urb*>(data->data); }
    void finish(int status, int length) const {
      urb()->status = status;
      urb()->actual_length = length;
    }
  };

  template <class T>
  T locked(const T& value) const {
    const std::lock_guard lock(mutex_);
    return value;
  }

  static bool complete(UMockdevIoctlClient* client, long result, int error) {
    umockdev_ioctl_client_complete(client, result, error);
    return true;
  }

  bool submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
    if (gone_) return complete(client, -1, ENODEV);
    Urb urb{umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr)};
    UMockdevIoctlData* const buffer = umockdev_ioctl_data_resolve(
        urb.data, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(urb.urb()->buffer_length), nullptr);
    if (urb.urb()->endpoint == model_.out) {
      take(std::string(reinterpret_cast<const char*>(buffer->data),
                       static_cast<std::size_t>(buffer->data_len)));
      urb.finish(0, urb.urb()->buffer_length);
      done_.push_back(urb);
    } else {
      pending_.push_back(urb);
      const auto waiting = std::count_if(pending_.begin(), pending_.end(), [&](const Urb& other) {
        return other.urb()->endpoint == model_.data;
      });
      mostPending_ = std::max(mostPending_, static_cast<std::size_t>(waiting));
    }
    umockdev_ioctl_data_unref(buffer);
    return complete(client, 0, 0);
  }

  bool discard(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
    gulong address = 0;
    std::memcpy(&address, argument->data, sizeof address);
    const auto found = std::find_if(pending_.begin(), pending_.end(),
                                    [&](const Urb& urb) { return urb.data->client_addr == address; });
    if (found == pending_.end()) return complete(client, -1, EINVAL);
    found->finish(-ENOENT, 0);
    done_.splice(done_.end(), pending_, found);
    return complete(client, 0, 0);
  }

  bool reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
    work();
    if (done_.empty()) {
      std::this_thread::sleep_for(std::chrono::microseconds(300));  // the caller would ask again at once
      return complete(client, -1, EAGAIN);
    }
    const Urb urb = done_.front();
    done_.pop_front();
    UMockdevIoctlData* const pointer = umockdev_ioctl_data_resolve(argument, 0, sizeof(gpointer), nullptr);
    umockdev_ioctl_data_set_ptr(pointer, 0, urb.data);
    umockdev_ioctl_data_unref(pointer);
    umockdev_ioctl_data_unref(urb.data);
    return complete(client, 0, 0);
  }

  /// Makes the records that are due and fills waiting transfers, one packet of at most 64 bytes each.
  void work() {
    if (gone_) {  // the kernel ends every transfer
      for (const Urb& urb : pending_) urb.finish(-ESHUTDOWN, 0);
      done_.splice(done_.end(), pending_);
      return;
    }
    makeRecords();
    for (auto next = pending_.begin(); next != pending_.end();) {
      const auto urb = next++;
      std::string& stream = urb->urb()->endpoint == model_.data ? records_ : replies_;
      if (broken_ > 0 && urb->urb()->endpoint == model_.data && continuous_) {
        --broken_;
        urb->finish(-EPROTO, 0);
      } else if (stream.empty()) {
        continue;
      } else {
        const std::size_t size =
            std::min({stream.size(), std::size_t{64}, static_cast<std::size_t>(urb->urb()->buffer_length)});
        std::memcpy(urb->urb()->buffer, stream.data(), size);
        stream.erase(0, size);
        urb->finish(0, static_cast<int>(size));
      }
      done_.splice(done_.end(), pending_, urb);
    }
  }

  void makeRecords() {
    if (!continuous_) return;
    const double now_s = std::chrono::duration<double>(Clock::now() - start_).count();
    for (; static_cast<double>(frame_ + 1) / kRate_hz <= now_s; ++frame_) {
      if (skipped_ > 0) {
        --skipped_;
        continue;
      }
      if (frozen_) continue;
      for (int station = 1; station <= model_.stations; ++station) addRecord(station);
    }
  }

  void addRecord(int station) {
    std::string record = model_.fastrak ? fastrakRecord(station) : libertyRecord(station);
    const std::size_t lost = std::min<std::size_t>(lost_, record.size());
    record.erase(0, lost);
    lost_ -= lost;
    if (records_.size() < 4096) records_ += record;  // as much as it holds back
  }

  template <class T>
  static void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);  // this machine's lowest byte is first
  }

  void appendPose(std::string& bytes, int station) const {
    double position_m[3], angle_rad;
    placeAt(frame_ / kRate_hz, station, position_m, angle_rad);
    const double unit_m = centimetres_ ? 0.01 : 0.0254;
    for (const double coordinate_m : position_m) append(bytes, static_cast<float>(coordinate_m / unit_m));
    append(bytes, static_cast<float>(std::cos(angle_rad / 2)));
    append(bytes, 0.0F);
    append(bytes, 0.0F);
    append(bytes, static_cast<float>(std::sin(angle_rad / 2)));
  }

  char flag(int station) const { return station == flagged_ ? 'a' : ' '; }

  std::string libertyRecord(int station) {
    if (!binary_ || list_ != "*,8,9,11,3,7") return "01 12.3 4.5 6.7 0 0 0\r\n";
    std::string record = model_.mark;
    record += {static_cast<char>(station), 'C', flag(station), '\0'};
    append(record, std::uint16_t{40});
    append(record,
           static_cast<std::uint32_t>(std::lround(1e3 * frame_ / kRate_hz)) + 0xfffff000U);  // about to wrap
    append(record, frame_);
    append(record, std::uint32_t{1});
    appendPose(record, station);
    return record;
  }

  std::string fastrakRecord(int station) {
    if (!binary_ || list_.substr(1) != ",2,11,0") return "01  12.3  4.5  6.7   0.0   0.0   0.0\r\n";
    std::string record = {'0', static_cast<char>('0' + station), flag(station)};
    appendPose(record, station);
    record += ' ';
    return record;
  }

  /// Takes bytes of commands: letters that need no return are done at once.
  void take(const std::string& bytes) {
    commands_.push_back(bytes);
    for (const char byte : bytes) {
      line_ += byte;
      if (model_.fastrak && line_.size() == 1 && std::string("cCfFuU").find(byte) != std::string::npos)
        obey();
      else if (byte == '\r')
        obey();
    }
  }

  void obey() {
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    if (model_.fastrak) {
      if (line_ == "c") continuous_ = false;
      if (line_ == "C") begin();
      if (line_ == "f") binary_ = true;
      if (line_ == "F") binary_ = false;
      if (line_ == "U") centimetres_ = true;
    } else {
      if (line_ == "P") {
        continuous_ = false;
        makeSingle();
      }
      if (line_ == "C") begin();
      if (line_ == "F1") binary_ = true;
      if (line_ == "U1") centimetres_ = true;
    }
    if (line_.starts_with('O')) list_ = line_.substr(1);
    line_.clear();
  }

  void begin() {
    continuous_ = true;
    start_ = Clock::now() -
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(frame_ / kRate_hz));
  }

  void makeSingle() {
    for (int station = 1; station <= model_.stations; ++station) addRecord(station);
  }

  const PolhemusBoxModel model_;
  mutable std::mutex mutex_;
  std::list<Urb> pending_, done_;
  std::size_t mostPending_ = 0;
  std::string line_, list_, records_, replies_;
  std::vector<std::string> commands_;
  bool binary_ = false, centimetres_ = false;
  bool continuous_ = true;  // somebody left it talking, in text
  std::uint32_t frame_ = 0;
  Clock::time_point start_ = Clock::now();
  std::atomic<int> broken_{0}, flagged_{0};
  std::atomic<std::size_t> lost_{0};
  std::atomic<std::uint32_t> skipped_{0};
  std::atomic<bool> frozen_{false}, gone_{false};
};

inline std::string PolhemusBox::description(const PolhemusBoxModel& model) {
  const auto hex = [](std::initializer_list<int> bytes) {
    std::string text;
    for (const int byte : bytes) {
      char two[3];
      std::snprintf(two, sizeof two, "%02X", static_cast<unsigned>(byte & 0xff));
      text += two;
    }
    return text;
  };
  const auto endpoint = [&](std::uint8_t address, int type) { return hex({7, 5, address, type, 64, 0, 1}); };
  const int endpoints = model.data != model.in ? 3 : 2;
  std::string descriptors =
      hex({18, 1, 0, 2, 0, 0, 0, 64, 0x44, 0x0f, model.product & 0xff, model.product >> 8, 0, 1, 0, 0, 0, 1});
  descriptors += hex({9, 2, 18 + 7 * endpoints, 0, 1, 1, 0, 0x80, 50});
  descriptors += hex({9, 4, 0, 0, endpoints, 0xff, 0, 0, 0});
  descriptors += endpoint(model.out, 2) + endpoint(model.in, 2);
  if (endpoints == 3) descriptors += endpoint(model.data, 3);
  return "P: /devices/pci0000:00/0000:00:14.0/usb1/1-3\n"
         "N: bus/usb/001/003=" +
         descriptors +
         "\n"
         "E: DEVNAME=/dev/bus/usb/001/003\n"
         "E: DEVTYPE=usb_device\n"
         "E: BUSNUM=001\n"
         "E: DEVNUM=003\n"
         "E: SUBSYSTEM=usb\n"
         "A: busnum=1\\n\nA: devnum=3\\n\nA: speed=12\\n\nA: bConfigurationValue=1\\n\n"
         "H: descriptors=" +
         descriptors + "\n";
}

}  // namespace carom::test
