#pragma once
// A file of captured USB traffic as usbmon and Wireshark write it: pcap, link type USB_LINUX_MMAPPED (220).

#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace carom::test {

/// Transfers of device 3 on bus 1, in the order in which they were submitted and completed.
class UsbCapture {
 public:
  explicit UsbCapture(const std::filesystem::path& path) : file_(path, std::ios::binary) {
    put(std::uint32_t{0xa1b2c3d4});
    put(std::uint16_t{2});
    put(std::uint16_t{4});
    put(std::uint64_t{0});        // time zone, accuracy
    put(std::uint32_t{0x40000});  // longest packet
    put(std::uint32_t{220});
  }

  /// A command that the device took.
  void out(std::uint8_t endpoint, const std::string& bytes) {
    const std::uint64_t id = ++id_;
    packet(id, 'S', endpoint, -115, bytes.size(), bytes);  // −EINPROGRESS
    packet(id, 'C', endpoint, 0, bytes.size(), {});
  }

  /// A transfer begins to wait for `size` bytes.
  void wait(std::uint8_t endpoint, std::size_t size) {
    waiting_.push_back(++id_);
    packet(id_, 'S', endpoint, -115, size, {});
  }

  /// The one that waits longest ends so.
  void came(std::uint8_t endpoint, const std::string& bytes, int status = 0) {
    packet(waiting_.front(), 'C', endpoint, status, bytes.size(), bytes);
    waiting_.pop_front();
  }

  /// The one that waits longest was given up; nothing of it is in the file.
  void gaveUp() { waiting_.pop_front(); }

  std::size_t waiting() const { return waiting_.size(); }

  void close() {
    file_.close();
    if (!file_) throw std::runtime_error("cannot write a capture");
  }

 private:
  template <class T>
  void put(T value) {
    file_.write(reinterpret_cast<const char*>(&value), sizeof value);
  }

  void packet(std::uint64_t id, char event, std::uint8_t endpoint, std::int32_t status, std::size_t length,
              const std::string& bytes) {
    const auto captured = static_cast<std::uint32_t>(64 + bytes.size());
    put(std::uint64_t{0});  // time in the file's own header: nobody looks
    put(captured);
    put(captured);
    put(id);
    put(event);
    put(std::uint8_t{3});  // bulk
    put(endpoint);
    put(std::uint8_t{3});
    put(std::uint16_t{1});
    put('-');  // no setup packet
    put(bytes.empty() ? '<' : '\0');
    put(std::int64_t{0});
    put(std::int32_t{0});
    put(status);
    put(static_cast<std::uint32_t>(length));
    put(static_cast<std::uint32_t>(bytes.size()));
    for (int i = 0; i < 3; ++i) put(std::uint64_t{0});
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  std::ofstream file_;
  std::uint64_t id_ = 0xffff888000000000;  // as the kernel's pointers look
  std::deque<std::uint64_t> waiting_;
};

}  // namespace carom::test
