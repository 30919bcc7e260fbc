#pragma once
// The other side of QTM's protocol for tests, written from its description and sharing nothing with the
// decoder.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace carom::test {

class QtmSender {
 public:
  using Bytes = std::vector<std::uint8_t>;

  struct Body {
    float x_mm, y_mm, z_mm;
    /// Where the body's x, y and z axis point.
    std::array<std::array<float, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  };

  /// A body turned about z.
  static Body turned(float x_mm, float y_mm, float z_mm, double angle_rad) {
    const auto c = static_cast<float>(std::cos(angle_rad)), s = static_cast<float>(std::sin(angle_rad));
    return {x_mm, y_mm, z_mm, {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}};
  }
  static Body lost() {
    const float none = std::numeric_limits<float>::quiet_NaN();
    return {none, none, none, {{{none, none, none}, {none, none, none}, {none, none, none}}}};
  }

  static Bytes packet(std::uint32_t type, const Bytes& content) {
    Bytes bytes;
    put(bytes, static_cast<std::uint32_t>(content.size() + 8));
    put(bytes, type);
    bytes.insert(bytes.end(), content.begin(), content.end());
    return bytes;
  }
  /// An error (0), a command or its answer (1) or XML (2).
  static Bytes text(std::uint32_t type, const std::string& text) {
    Bytes content(text.begin(), text.end());
    content.push_back(0);
    return packet(type, content);
  }
  static Bytes event(std::uint8_t number) { return packet(6, {number}); }

  /// With a component that nobody asked for before that of the bodies.
  static Bytes frameContent(std::uint32_t number, double time_s, const std::vector<Body>& bodies,
                            bool residuals = true) {
    Bytes content;
    put(content, static_cast<std::uint64_t>(time_s * 1e6 + 0.5));
    put(content, number);
    put(content, std::uint32_t{2});
    component(content, 1, Bytes(24, 7));
    Bytes part;
    put(part, static_cast<std::uint32_t>(bodies.size()));
    put(part, std::uint32_t{0});
    for (const Body& body : bodies) {
      for (const float number_mm : {body.x_mm, body.y_mm, body.z_mm}) put(part, number_mm);
      for (const auto& axis : body.axes) {
        for (const float number_1 : axis) put(part, number_1);
      }
      if (residuals) put(part, 0.5f);
    }
    component(content, residuals ? 11 : 5, part);
    return content;
  }
  static Bytes frame(std::uint32_t number, double time_s, const std::vector<Body>& bodies) {
    return packet(3, frameContent(number, time_s, bodies));
  }

  static std::string xml(const std::vector<std::string>& names) {
    std::string text = "<QTM_Parameters_Ver_1.19><The_6D>\n";
    for (const std::string& name : names) {
      text += "<Body><Name>" + name +
              "</Name><Enabled>true</Enabled><Color R=\"255\" G=\"1\" B=\"2\"/>"
              "<Mesh><Name>chair.obj</Name></Mesh><Points><Point X=\"1\" Y=\"2\" Z=\"3\" "
              "Name=\"a\"/></Points></Body>\n";
    }
    return text + "</The_6D></QTM_Parameters_Ver_1.19>";
  }

  template <class T>
  static void put(Bytes& bytes, T value) {
    std::array<std::uint8_t, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  }

 private:
  static void component(Bytes& bytes, std::uint32_t type, const Bytes& content) {
    put(bytes, static_cast<std::uint32_t>(content.size() + 8));
    put(bytes, type);
    bytes.insert(bytes.end(), content.begin(), content.end());
  }
};

}  // namespace carom::test
