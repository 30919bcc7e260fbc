#include "app/link/link_message.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/matrix.hpp>
#include <optional>
#include <string_view>

#include "devices/wire/wire_reader.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

constexpr std::uint32_t kMagic = 0x4d524143;  // "CARM"
constexpr std::size_t kHeadBytes = 6, kMostWords = 200, kMostProgram = 64, kMostFileName = 255;
constexpr double kMostBoard_s = 1e6, kMostCelerity_m_s = 1e4;

/// Writes the fields of a message.
class FieldWriter {
 public:
  explicit FieldWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  template <class T>
  void number(T& value) {
    std::uint8_t raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(std::begin(raw), std::end(raw));
    bytes_.insert(bytes_.end(), std::begin(raw), std::end(raw));
  }
  template <class T>
  void within(T& value, T, T, const char*) {
    number(value);
  }
  void text(std::string& text, std::size_t, const char*) {
    auto size = static_cast<std::uint32_t>(text.size());
    number(size);
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  void name(std::string& name, std::size_t most, const char* what) { text(name, most, what); }
  void expect(bool, const char*) {}
  template <class T>
  void count(std::vector<T>& items, std::uint32_t, const char*) {
    auto size = static_cast<std::uint32_t>(items.size());
    number(size);
  }

 private:
  std::vector<std::uint8_t>& bytes_;
};

/// Whether a text is valid UTF-8 without control characters.
bool isClean(std::string_view text) {
  while (!text.empty()) {
    const std::optional<char32_t> sign = takeCodePoint(text);
    if (!sign || *sign < 0x20 || (*sign >= 0x7f && *sign < 0xa0)) return false;
  }
  return true;
}

/// Reads the fields of a message and checks each.
class FieldReader {
 public:
  explicit FieldReader(std::span<const std::uint8_t> bytes) : wire_(bytes, std::endian::little) {}

  template <class T>
  void number(T& value) {
    value = wire_.read<T>();
    if (!wire_.ok()) throw BrokenLink("it sent a message that is shorter than its kind");
  }
  template <class T>
  void within(T& value, T least, T most, const char* what) {
    number(value);
    if (!(value >= least && value <= most))
      throw BrokenLink("it sent " + std::string(what) + " of " + std::to_string(value) + ", expected " +
                       std::to_string(least) + " to " + std::to_string(most));
  }
  void text(std::string& text, std::size_t most, const char* what) {
    std::uint32_t size = 0;
    within(size, 0U, static_cast<std::uint32_t>(most), what);
    const auto taken = wire_.take(size);
    if (!wire_.ok()) throw BrokenLink("it sent a message that is shorter than its kind");
    text.assign(reinterpret_cast<const char*>(taken.data()), taken.size());
  }
  void name(std::string& name, std::size_t most, const char* what) {
    text(name, most, what);
    if (!isClean(name))
      throw BrokenLink("it sent " + std::string(what) + " with control characters or that is not UTF-8");
  }
  template <class T>
  void count(std::vector<T>& items, std::uint32_t most, const char* what) {
    std::uint32_t size = 0;
    within(size, 0U, most, what);
    if (size > wire_.rest().size()) throw BrokenLink("it sent a message that is shorter than its kind");
    items.resize(size);
  }
  void expect(bool isTrue, const char* otherwise) {
    if (!isTrue) throw BrokenLink(otherwise);
  }
  void end() const {
    if (!wire_.rest().empty()) throw BrokenLink("it sent a message that is longer than its kind");
  }

 private:
  WireReader wire_;
};

// ------------------------------------------------------------ the fields of each message, in their order
template <class Wire>
void flag(Wire& wire, bool& value) {
  std::uint8_t byte = value ? 1 : 0;
  wire.within(byte, std::uint8_t{0}, std::uint8_t{1}, "a flag");
  value = byte != 0;
}
template <class Wire>
void vector(Wire& wire, Vec3& v, double most, const char* what) {
  for (int axis = 0; axis < 3; ++axis) wire.within(v[axis], -most, most, what);
}
template <class Wire>
void event(Wire& wire, Event& event) {
  wire.within(event.t_s, -kMostBoard_s, kMostBoard_s, "a board time (s)");
  vector(wire, event.r_m, kMostLinkPlace_m, "a place (m)");
}
template <class Wire>
void lightSpeed(Wire& wire, double& speed_m_s) {
  wire.within(speed_m_s, kLeastLightSpeed_m_s, kMostLightSpeed_m_s, "a speed of light (m/s)");
}
template <class Wire>
void fields(Wire& wire, LinkHello& hello) {
  std::uint32_t magic = kMagic;
  wire.number(magic);
  wire.expect(magic == kMagic, "it is no carom");
  wire.within(hello.protocol, kLinkProtocol, kLinkProtocol, "a protocol");
  wire.number(hello.arithmetic);
  wire.name(hello.program, kMostProgram, "a version");
  wire.name(hello.room, kMostLinkName, "a room's name");
  wire.count(hello.viewers, static_cast<std::uint32_t>(kMostViewers), "a number of viewers");
  for (std::string& viewer : hello.viewers) wire.name(viewer, kMostLinkName, "a viewer's name");
  for (glm::dvec2* corner : {&hello.floor.least_m, &hello.floor.most_m}) {
    for (int axis = 0; axis < 2; ++axis)
      wire.within((*corner)[axis], -kMostLinkPlace_m, kMostLinkPlace_m, "a floor's corner (m)");
  }
  wire.number(hello.game);
  wire.within(hello.heard, 0U, kMostStrokesTold, "a number of strokes");
}
template <class Wire>
void fields(Wire& wire, LinkPing& ping) {
  wire.number(ping.number);
  wire.number(ping.sent_ns);
}
template <class Wire>
void fields(Wire& wire, LinkPong& pong) {
  fields(wire, pong.ping);
}
template <class Wire>
void fields(Wire& wire, LinkStroke& stroke) {
  wire.within(stroke.room, 0U, kMostRooms - 1, "a room's number");
  wire.within(stroke.told.number, 0U, kMostStrokesTold - 1, "a stroke's number");
  wire.within(stroke.told.viewer, 0U, static_cast<std::uint32_t>(kMostViewers) - 1, "a viewer's number");
  Stroke& made = stroke.told.stroke;
  auto puck = static_cast<std::uint32_t>(made.puck);
  wire.number(puck);
  made.puck = puck;
  Event at{made.at_s, made.from_m.value_or(Vec3(0.0))};
  event(wire, at);
  made.at_s = at.t_s;
  made.from_m = at.r_m;
  for (int axis = 0; axis < 2; ++axis)
    wire.within(made.momentum_kg_m_s[axis], -1e9, 1e9, "a stroke's momentum (kg m/s)");
  wire.within(made.offset_m, -kMostLinkPlace_m, kMostLinkPlace_m, "a stroke's offset (m)");
}
template <class Wire>
void fields(Wire& wire, LinkWelcome& welcome) {
  wire.number(welcome.game);
  wire.expect(welcome.game != 0, "it sent a game without a number");
  wire.within(welcome.rooms, 2U, kMostRooms, "a number of rooms");
  wire.within(welcome.room, 1U, welcome.rooms - 1, "a room's number");
  wire.within(welcome.apart_m, 0.0, kMostLinkPlace_m, "a distance of rooms (m)");
  lightSpeed(wire, welcome.lightSpeedShown_m_s);
  wire.within(welcome.board_s, -kMostBoard_s, kMostBoard_s, "a board time (s)");
  wire.text(welcome.scenario, kMostScenarioBytes, "a size of a scenario");
  wire.count(welcome.meshes, kMostLinkMeshes, "a number of meshes");
  for (LinkWelcome::Mesh& mesh : welcome.meshes) {
    wire.name(mesh.name, kMostFileName, "a name of a mesh");
    wire.expect(mesh.name.find('/') == std::string::npos,
                "it sent a mesh in a folder, expected a name without '/'");
    wire.number(mesh.digest);
  }
  wire.count(welcome.strokes, kMostStrokesTold, "a number of strokes");
  for (LinkStroke& stroke : welcome.strokes) fields(wire, stroke);
}
/// Whether a matrix is a Lorentz transform that keeps the direction of time: ΛᵀgΛ = g, Λ₀₀ ≥ 1.
bool isLorentz(const glm::dmat4& matrix) {
  const glm::dmat4 metric(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, -1, 0),
                          glm::dvec4(0, 0, 0, -1));
  const glm::dmat4 product = glm::transpose(matrix) * metric * matrix;
  const double gamma = matrix[0][0];
  double error = 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      error = std::max(error, std::abs(product[column][row] - metric[column][row]));
  }
  return gamma >= 1.0 - 1e-6 && glm::determinant(matrix) > 0.0 && error <= 1e-6 * gamma * gamma;
}
template <class Wire>
void person(Wire& wire, PersonTold& told, LinkPerson& person) {
  event(wire, told.promise);
  event(wire, told.head);
  event(wire, told.hand);
  wire.within(told.properTime_s, -kMostBoard_s, kMostBoard_s, "a proper time (s)");
  for (int i = 0; i < 4; ++i) wire.within(person.attitude[i], -2.0, 2.0, "a part of an attitude");
  wire.expect(std::abs(glm::length(person.attitude) - 1.0) <= 1e-6,
              "it sent an attitude that is no rotation");
  vector(wire, person.celerity_m_s, kMostCelerity_m_s, "a celerity (m/s)");
  wire.number(person.held);
  vector(wire, person.pull_m, kMostLinkPlace_m, "a pull (m)");
  wire.number(person.caroms);
  wire.within(person.lastCarom, 0U, kMostStrokesTold, "a carom");
}
template <class Wire>
void fields(Wire& wire, LinkPresent& message) {
  Present& present = message.present;
  wire.within(message.room, 0U, kMostRooms - 1, "a room's number");
  wire.number(present.number);
  wire.within(present.strokes, 0U, kMostStrokesTold, "a number of strokes");
  flag(wire, present.waits);
  for (int i = 0; i < 16; ++i)
    wire.within(message.boardFromRoom[i / 4][i % 4], -1e6, 1e6, "a part of a motion");
  wire.expect(isLorentz(message.boardFromRoom), "it sent a motion that is no Lorentz transform");
  auto size = static_cast<std::uint8_t>(present.size);
  wire.within(size, std::uint8_t{1}, static_cast<std::uint8_t>(kMostViewers), "a number of viewers");
  present.size = size;
  for (std::size_t i = 0; i < present.size; ++i) person(wire, present.persons[i], message.persons[i]);
}
template <class Wire>
void fields(Wire& wire, LinkReady& ready) {
  fields(wire, ready.first);
}
template <class Wire>
void fields(Wire& wire, LinkAccept& accept) {
  wire.within(accept.room, 0U, kMostRooms - 1, "a room's number");
}
template <class Wire>
void fields(Wire& wire, LinkDigest& digest) {
  wire.number(digest.second);
  wire.number(digest.digest);
}
template <class Wire>
void fields(Wire& wire, LinkSettings& settings) {
  wire.number(settings.number);
  lightSpeed(wire, settings.lightSpeedShown_m_s);
  flag(wire, settings.isFrozen);
}
template <class Wire>
void fields(Wire& wire, LinkTurns& message) {
  constexpr double kMost = 1e15;  // of any number of a turn
  wire.number(message.second);
  wire.number(message.strokes);
  wire.count(message.turns, kMostTurnsTold, "a number of turns");
  for (FinalTurn& turn : message.turns) {
    for (double& number : turn) wire.within(number, -kMost, kMost, "a number of a turn");
  }
}
template <class Wire>
void fields(Wire& wire, LinkBye& bye) {
  wire.name(bye.reason, kMostWords, "a reason");
}

/// Reads a message of the kind with that number.
template <std::size_t kind = 0>
LinkMessage read(std::size_t type, std::span<const std::uint8_t> body) {
  if constexpr (kind < std::variant_size_v<LinkMessage>) {
    if (type != kind) return read<kind + 1>(type, body);
    std::variant_alternative_t<kind, LinkMessage> message;
    FieldReader wire(body);
    fields(wire, message);
    wire.end();
    return message;
  }
  throw BrokenLink("it sent a message of no kind that there is");
}

}  // namespace

void append(const LinkMessage& message, std::vector<std::uint8_t>& bytes) {
  const std::size_t begin = bytes.size();
  FieldWriter wire(bytes);
  auto type = static_cast<std::uint16_t>(message.index());
  std::uint32_t length = 0;
  wire.number(type);
  wire.number(length);
  std::visit([&](auto body) { fields(wire, body); }, message);
  length = static_cast<std::uint32_t>(bytes.size() - begin - kHeadBytes);
  for (std::size_t i = 0; i < 4; ++i) bytes[begin + 2 + i] = static_cast<std::uint8_t>(length >> (8 * i));
}

std::optional<std::size_t> sizeOfLinkMessage(std::span<const std::uint8_t> bytes) {
  WireReader wire(bytes, std::endian::little);
  const auto type = wire.read<std::uint16_t>();
  const auto length = wire.read<std::uint32_t>();
  if (!wire.ok()) return std::nullopt;
  if (type >= std::variant_size_v<LinkMessage>)
    throw BrokenLink("it sent a message of kind " + std::to_string(type) + ", which there is not");
  const bool isWelcome = type == LinkMessage(LinkWelcome()).index();
  if (length > (isWelcome ? kMostWelcomeBytes : kMostLinkBytes))
    throw BrokenLink("it sent a message of " + std::to_string(length) + " bytes, which is too long");
  return kHeadBytes + length;
}

LinkMessage linkMessageOf(std::span<const std::uint8_t> bytes) {
  const std::optional<std::size_t> size = sizeOfLinkMessage(bytes);
  if (!size || *size != bytes.size()) throw BrokenLink("it sent a message that is not whole");
  return read(bytes[0] | bytes[1] << 8U, bytes.subspan(kHeadBytes));
}

}  // namespace carom
