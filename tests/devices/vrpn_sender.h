#pragma once
// The other side of VRPN for tests, written from the protocol and sharing nothing with the decoder: packs
// records as a server does.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace carom::test {

class VrpnSender {
 public:
  using Bytes = std::vector<std::uint8_t>;

  static Bytes cookie(const std::string& version = "07.35") {
    const std::string text = "vrpn: ver. " + version + "  0";
    Bytes bytes(24);
    std::copy(text.begin(), text.end(), bytes.begin());
    return bytes;
  }

  static constexpr int kSenderName = -1, kTypeName = -2;
  static constexpr int kPong = 6;

  /// Names 0 and 1 of senders, 0 to 6 of types.
  static Bytes names(const std::string& sender) {
    Bytes bytes = name(0, kSenderName, "VRPN Control");
    add(bytes, name(1, kSenderName, sender));
    const char* types[]{"vrpn_Tracker Velocity", "vrpn_Tracker Pos_Quat", "vrpn_Button Change",
                        "vrpn_Button States",    "vrpn_Analog Channel",   "vrpn_Base ping_message",
                        "vrpn_Base pong_message"};
    for (int i = 0; i < 7; ++i) add(bytes, name(i, kTypeName, types[i]));
    return bytes;
  }

  static Bytes name(int id, int what, const std::string& text) {
    Bytes payload;
    put(payload, static_cast<std::uint32_t>(text.size() + 1));
    for (const char c : text) payload.push_back(static_cast<std::uint8_t>(c));
    payload.push_back(0);
    return record(id, what, payload, 0.0);
  }

  /// At x along x, turned by `angle` about y.
  static Bytes pose(int sensor, double x_m, double angle_rad, double time_s, int sender = 1) {
    Bytes payload;
    put(payload, static_cast<std::uint32_t>(sensor));
    put(payload, std::uint32_t{0xdeadbeef});  // whatever
    for (const double number :
         {x_m, 1.7, -0.25, 0.0, std::sin(angle_rad / 2), 0.0, std::cos(angle_rad / 2)}) {
      put(payload, std::bit_cast<std::uint64_t>(number));
    }
    return record(sender, 1, payload, time_s);
  }

  static Bytes velocity(int sensor, double vx_m_s, double angle_rad, double interval_s, double time_s) {
    Bytes payload;
    put(payload, static_cast<std::uint32_t>(sensor));
    put(payload, std::uint32_t{0});
    for (const double number :
         {vx_m_s, 0.0, 0.0, 0.0, std::sin(angle_rad / 2), 0.0, std::cos(angle_rad / 2), interval_s}) {
      put(payload, std::bit_cast<std::uint64_t>(number));
    }
    return record(1, 0, payload, time_s);
  }

  static Bytes button(int index, bool pressed, double time_s) {
    Bytes payload;
    put(payload, static_cast<std::uint32_t>(index));
    put(payload, std::uint32_t{pressed});
    return record(1, 2, payload, time_s);
  }

  static Bytes buttons(const std::vector<bool>& states, double time_s) {
    Bytes payload;
    put(payload, static_cast<std::uint32_t>(states.size()));
    for (const bool state : states) put(payload, std::uint32_t{state});
    return record(1, 3, payload, time_s);
  }

  static Bytes channels(const std::vector<double>& values, double time_s) {
    Bytes payload;
    put(payload, std::bit_cast<std::uint64_t>(static_cast<double>(values.size())));
    for (const double value : values) put(payload, std::bit_cast<std::uint64_t>(value));
    return record(1, 4, payload, time_s);
  }

  static Bytes ping(double time_s) { return record(1, 5, {}, time_s); }

  static Bytes record(int sender, int type, const Bytes& payload, double time_s) {
    Bytes bytes;
    put(bytes, static_cast<std::uint32_t>(24 + payload.size()));
    put(bytes, static_cast<std::uint32_t>(std::floor(time_s)));
    put(bytes, static_cast<std::uint32_t>(std::lround((time_s - std::floor(time_s)) * 1e6)));
    put(bytes, static_cast<std::uint32_t>(sender));
    put(bytes, static_cast<std::uint32_t>(type));
    put(bytes, std::uint32_t{4711});  // a sequence number, which nobody reads
    add(bytes, payload);
    while (bytes.size() % 8 != 0) bytes.push_back(0);
    return bytes;
  }

  static void add(Bytes& bytes, const Bytes& more) {
    for (const std::uint8_t byte : more) bytes.push_back(byte);
  }

 private:
  template <class T>
  static void put(Bytes& bytes, T value) {
    for (std::size_t i = sizeof(T); i-- > 0;) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
};

}  // namespace carom::test
