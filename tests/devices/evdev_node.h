#pragma once
// An input device with force behind a mocked /dev/input/event0: it answers the requests of the kernel's input
// events, and keeps what effects are uploaded, started, stopped and removed, in order.

#include <linux/input.h>
#include <sys/ioctl.h>

#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "devices/mocked_kernel.h"

namespace carom::test {

class EvdevNode : public MockedNode {
 public:
  static constexpr const char* kNode = "/dev/input/event0";
  static constexpr const char* kPath = "/devices/pci0000:00/0000:00:14.0/usb1/1-3/input/input5/event0";

  /// One request or event of the program.
  struct Told {
    enum class What { upload, play, stop, remove, gain } what;
    int id = -1;
    ff_effect effect{};
    int value = 0;
  };

  EvdevNode(std::string name, std::vector<int> effects, int axes)
      : name_(std::move(name)), effects_(std::move(effects)), axes_(axes) {}

  void plugInto(MockedKernel& kernel) {
    kernel.attach(kNode, *this);
    kernel.plugIn(
        "P: " + std::string(kPath) +
        "\nN: input/event0\nE: DEVNAME=/dev/input/event0\nE: MAJOR=13\nE: MINOR=64\nE: SUBSYSTEM=input\nA: "
        "dev=13:64\\n\n");
  }

  void unplug() {
    const std::lock_guard lock(mutex_);
    gone_ = true;
  }
  void send(int type, int code, int value) {
    const std::lock_guard lock(mutex_);
    input_event event{};
    event.type = static_cast<std::uint16_t>(type);
    event.code = static_cast<std::uint16_t>(code);
    event.value = value;
    events_.push_back(event);
  }
  std::vector<Told> told() const {
    const std::lock_guard lock(mutex_);
    return told_;
  }

 protected:
  bool ioctl(UMockdevIoctlClient* client, gulong request, UMockdevIoctlData* argument) override {
    const std::lock_guard lock(mutex_);
    if (_IOC_TYPE(request) != 'E') return false;
    if (gone_) {
      umockdev_ioctl_client_complete(client, -1, ENODEV);
      return true;
    }
    if (_IOC_NR(request) == _IOC_NR(EVIOCRMFF)) {  // its argument is a number, not a place in memory
      std::intptr_t id = 0;
      std::memcpy(&id, argument->data,
                  std::min<std::size_t>(sizeof id, static_cast<std::size_t>(argument->data_len)));
      told_.push_back({Told::What::remove, static_cast<int>(id), {}, 0});
      umockdev_ioctl_client_complete(client, 0, 0);
      return true;
    }
    UMockdevIoctlData* const data = umockdev_ioctl_data_resolve(argument, 0, _IOC_SIZE(request), nullptr);
    if (data == nullptr) return false;
    const long result = answer(request, *data);
    umockdev_ioctl_data_unref(data);
    umockdev_ioctl_client_complete(client, result, result < 0 ? EINVAL : 0);
    return true;
  }

  bool read(UMockdevIoctlClient* client, UMockdevIoctlData* buffer) override {
    const std::lock_guard lock(mutex_);
    if (gone_) {
      umockdev_ioctl_client_complete(client, -1, ENODEV);
      return true;
    }
    if (events_.empty()) {
      umockdev_ioctl_client_complete(client, -1, EAGAIN);
      return true;
    }
    umockdev_ioctl_data_update(buffer, 0, reinterpret_cast<std::uint8_t*>(&events_.front()),
                               sizeof(input_event));
    events_.pop_front();
    umockdev_ioctl_client_complete(client, sizeof(input_event), 0);
    return true;
  }

  bool write(UMockdevIoctlClient* client, UMockdevIoctlData* bytes) override {
    const std::lock_guard lock(mutex_);
    if (gone_) {
      umockdev_ioctl_client_complete(client, -1, ENODEV);
      return true;
    }
    input_event event{};
    std::memcpy(&event, bytes->data,
                std::min<std::size_t>(sizeof event, static_cast<std::size_t>(bytes->data_len)));
    if (event.type == EV_FF && event.code == FF_GAIN)
      told_.push_back({Told::What::gain, -1, {}, event.value});
    else if (event.type == EV_FF)
      told_.push_back({event.value ? Told::What::play : Told::What::stop, event.code, {}, event.value});
    umockdev_ioctl_client_complete(client, bytes->data_len, 0);
    return true;
  }

 private:
  static void setBit(UMockdevIoctlData& data, int bit) {
    if (bit / 8 < data.data_len)
      data.data[bit / 8] = static_cast<std::uint8_t>(data.data[bit / 8] | 1U << (bit % 8));
  }

  long answer(gulong request, UMockdevIoctlData& data) {
    const auto number = static_cast<int>(_IOC_NR(request));
    if (number == static_cast<int>(_IOC_NR(EVIOCGNAME(0)))) {
      std::strncpy(reinterpret_cast<char*>(data.data), name_.c_str(),
                   static_cast<std::size_t>(data.data_len));
      return static_cast<long>(name_.size());
    }
    if (number == static_cast<int>(_IOC_NR(EVIOCGEFFECTS))) {
      const int effects = 16;
      std::memcpy(data.data, &effects, sizeof effects);
      return 0;
    }
    if (number == static_cast<int>(_IOC_NR(EVIOCSFF))) return upload(data);
    if (number == static_cast<int>(_IOC_NR(EVIOCGKEY(0)))) return data.data_len;
    if (number >= 0x20 && number < 0x40) return bits(number - 0x20, data);
    if (number >= 0x40 && number < 0x80) {
      const input_absinfo info{0, 0, 255, 0, 0, 0};
      std::memcpy(data.data, &info, sizeof info);
      return 0;
    }
    return -1;
  }

  long bits(int type, UMockdevIoctlData& data) {
    std::memset(data.data, 0, static_cast<std::size_t>(data.data_len));
    if (type == 0) {
      setBit(data, EV_ABS);
      setBit(data, EV_KEY);
      if (!effects_.empty()) setBit(data, EV_FF);
    }
    if (type == EV_FF) {
      for (const int effect : effects_) setBit(data, effect);
    }
    if (type == EV_ABS) {
      setBit(data, ABS_X);
      if (axes_ > 1) setBit(data, ABS_Y);
    }
    return data.data_len;
  }

  long upload(UMockdevIoctlData& data) {
    Told told{Told::What::upload, -1, {}, 0};
    std::memcpy(&told.effect, data.data, sizeof told.effect);
    told.id = told.effect.id;
    told_.push_back(told);
    if (told.effect.id < 0) told.effect.id = next_++;
    std::memcpy(data.data, &told.effect, sizeof told.effect);
    return 0;
  }

  const std::string name_;
  const std::vector<int> effects_;
  const int axes_;
  mutable std::mutex mutex_;
  std::deque<input_event> events_;
  std::vector<Told> told_;
  std::int16_t next_ = 3;
  bool gone_ = false;
};

}  // namespace carom::test
