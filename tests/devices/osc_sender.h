#pragma once
// The other side of Open Sound Control for tests, written from its specification and sharing nothing with the
// decoder.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace carom::test {

class OscSender {
 public:
  using Bytes = std::vector<std::uint8_t>;

  /// A message of floats.
  static Bytes message(const std::string& address, const std::vector<float>& numbers) {
    Bytes bytes;
    text(bytes, address);
    text(bytes, ',' + std::string(numbers.size(), 'f'));
    for (const float number : numbers) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &number, sizeof bits);
      big(bytes, bits, 4);
    }
    return bytes;
  }

  /// A message whose types and arguments are given as they are.
  static Bytes message(const std::string& address, const std::string& types, const Bytes& arguments) {
    Bytes bytes;
    text(bytes, address);
    text(bytes, types);
    bytes.insert(bytes.end(), arguments.begin(), arguments.end());
    return bytes;
  }

  /// A bundle of the time tag "at once", or of a time in seconds since 1900.
  static Bytes bundle(const std::vector<Bytes>& elements, double time_s = 0.0) {
    Bytes bytes;
    text(bytes, "#bundle");
    if (time_s > 0.0) {
      const auto seconds = static_cast<std::uint64_t>(time_s);
      big(bytes, seconds, 4);
      big(bytes, static_cast<std::uint64_t>((time_s - static_cast<double>(seconds)) * 4294967296.0), 4);
    } else {
      big(bytes, 1, 8);
    }
    for (const Bytes& element : elements) {
      big(bytes, element.size(), 4);
      bytes.insert(bytes.end(), element.begin(), element.end());
    }
    return bytes;
  }

  static Bytes nested(int depth, Bytes inner) {
    for (int i = 0; i < depth; ++i) inner = bundle({inner});
    return inner;
  }

  static void text(Bytes& bytes, const std::string& text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
    do bytes.push_back(0);
    while (bytes.size() % 4 != 0);
  }
  static void big(Bytes& bytes, std::uint64_t number, int size) {
    for (int i = size - 1; i >= 0; --i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
  }
};

}  // namespace carom::test
