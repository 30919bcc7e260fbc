#pragma once
// The other side of NatNet for tests, written from the protocol and sharing nothing with the decoder.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace carom::test {

class NatnetSender {
 public:
  using Bytes = std::vector<std::uint8_t>;
  static constexpr std::uint64_t kTicksPerSecond = 10'000'000;

  NatnetSender(int major, int minor) : major_(major), minor_(minor) {}

  Bytes serverInfo() const {
    Bytes payload(256);
    std::memcpy(payload.data(), "Test", 4);
    for (const int number : {2, 0, 0, 0, major_, minor_, 0, 0})
      payload.push_back(static_cast<std::uint8_t>(number));
    put(payload, kTicksPerSecond);
    put(payload, std::uint16_t{1511});
    payload.push_back(0);
    put(payload, std::uint32_t{0});
    return message(1, payload);
  }

  struct Body {
    int id;
    float x_m, y_m, z_m;
    float qx, qy, qz, qw;
    bool tracked = true;
  };

  /// Exposed `latency_s` before it is sent. Everything that a frame can hold is in it.
  Bytes frame(std::uint32_t number, const std::vector<Body>& bodies, double sent_s, double latency_s) const {
    Bytes payload;
    put(payload, number);
    Bytes sets;
    for (const char* name : {"all", "Head"}) {
      append(sets, Bytes(name, name + std::strlen(name) + 1));
      put(sets, std::uint32_t{2});
      for (int i = 0; i < 6; ++i) put(sets, 0.25f);
    }
    part(payload, 2, sets);
    Bytes markers;
    for (int i = 0; i < 9; ++i) put(markers, 0.5f);
    part(payload, 3, markers);
    Bytes rigid;
    for (const Body& body : bodies) putBody(rigid, body);
    part(payload, static_cast<std::uint32_t>(bodies.size()), rigid);
    Bytes skeletons;
    put(skeletons, std::uint32_t{17});
    put(skeletons, std::uint32_t{1});
    putBody(skeletons, {65537, 9, 9, 9, 0, 0, 0, 1});
    part(payload, 1, skeletons);
    if (hasSizes()) part(payload, 0, {});  // assets
    Bytes labelled;
    put(labelled, std::uint32_t{3});
    for (int i = 0; i < 4; ++i) put(labelled, 0.125f);
    put(labelled, std::uint16_t{10});
    put(labelled, 0.0002f);
    part(payload, 1, labelled);
    for (int kind = 0; kind < 2; ++kind) {  // a force plate, a device
      Bytes channels;
      put(channels, std::uint32_t{5});
      put(channels, std::uint32_t{1});
      put(channels, std::uint32_t{2});
      put(channels, 1.5f);
      put(channels, 2.5f);
      part(payload, 1, channels);
    }
    put(payload, std::uint64_t{0});  // time code
    put(payload, 1234.5);
    put(payload, ticks(sent_s - latency_s));
    put(payload, ticks(sent_s - latency_s / 2));
    put(payload, ticks(sent_s));
    if (hasSizes()) put(payload, std::uint64_t{0});  // finer times
    put(payload, std::uint16_t{0});
    put(payload, std::uint32_t{0});
    return message(7, payload);
  }

 private:
  bool hasSizes() const { return major_ > 4 || (major_ == 4 && minor_ >= 1); }

  static std::uint64_t ticks(double time_s) {
    return static_cast<std::uint64_t>(time_s * static_cast<double>(kTicksPerSecond) + 0.5);
  }

  static void putBody(Bytes& bytes, const Body& body) {
    put(bytes, static_cast<std::uint32_t>(body.id));
    for (const float number : {body.x_m, body.y_m, body.z_m, body.qx, body.qy, body.qz, body.qw, 0.0005f}) {
      put(bytes, number);
    }
    put(bytes, static_cast<std::uint16_t>(body.tracked));
  }

  void part(Bytes& bytes, std::uint32_t count, const Bytes& content) const {
    put(bytes, count);
    if (hasSizes()) put(bytes, static_cast<std::uint32_t>(content.size()));
    append(bytes, content);
  }

  static void append(Bytes& bytes, const Bytes& more) {
    for (const std::uint8_t byte : more) bytes.push_back(byte);
  }

  static Bytes message(std::uint16_t id, const Bytes& payload) {
    Bytes bytes;
    put(bytes, id);
    put(bytes, static_cast<std::uint16_t>(payload.size()));
    append(bytes, payload);
    return bytes;
  }

  /// x86 and ARM hold numbers in NatNet's own order.
  template <class T>
  static void put(Bytes& bytes, T value) {
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    for (std::size_t i = 0; i < sizeof value; ++i) bytes.push_back(raw[i]);
  }

  int major_, minor_;
};

}  // namespace carom::test
