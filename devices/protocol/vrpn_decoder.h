#pragma once
// Decodes the bytes of a VRPN connection (Virtual Reality Peripheral Network) into readings.
//
// The protocol differs from VRPN's Format_Of_Protocol.txt in one point: a record's length counts its header
// and its payload, but not the padding to 8 bytes that follows.

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "devices/tracker/reading.h"

namespace carom {

/// Decodes one connection from its first byte on. Bytes may arrive in any portions.
class VrpnDecoder {
 public:
  /// Reads what `sender` says and ignores all other senders of the server.
  explicit VrpnDecoder(std::string sender) : sender_(std::move(sender)) {}

  /// Takes the next bytes, at most 8 KiB at a time, and appends what the sender said: poses, velocities,
  /// buttons (sensor 0) and analog channels (axes of sensor 0, clamped to −1 … 1). Throws std::runtime_error,
  /// which says why, if the stream cannot be followed: another version of the protocol, or a record
  /// of impossible length.
  void decode(std::span<const std::uint8_t> bytes, std::vector<Reading>& readings);

  bool greeted() const { return greeted_; }  ///< the server has sent its greeting
  bool spoke() const { return spoke_; }      ///< and a whole record after it
  /// Whether the server has named such a sender of its own accord. That does not prove that there is a
  /// device: a server keeps all names that any client has sent it since it started, and names them to every
  /// client.
  bool senderNamed() const { return senderNamed_; }
  /// Whether anything has arrived from the sender, even an answer to a ping; then there is such a device.
  bool senderHeard() const { return senderHeard_; }
  /// A sender that the server has named of its own accord.
  struct NamedSender {
    std::int32_t id = 0;
    std::string name;
    bool heard = false;  ///< as senderHeard()
  };
  static constexpr std::size_t kMostNamed = 64;
  /// Returns the first of them, at most kMostNamed.
  const std::vector<NamedSender>& namedSenders() const { return named_; }
  /// Must be called when `vrpnDescription` is sent: names that arrive from then on may be echoes of it and no
  /// longer count. What their senders say is still read.
  void ignoreNames() { namesCount_ = false; }
  std::uint64_t refused() const { return refused_; }  ///< number of records that made no sense
  /// Returns the number of pings since the last call.
  int takePings() { return std::exchange(pings_, 0); }

  static constexpr std::size_t kMostBytes = 8192;  ///< of one `decode`

 private:
  enum class Type : std::uint8_t { unknown, pose, velocity, buttonChange, buttonStates, analog, ping };
  struct Header;

  bool takeRecord(std::vector<Reading>& readings);
  void greet(std::string_view cookie);
  void describe(const Header& header, std::span<const std::uint8_t> payload);
  bool understand(const Header& header, std::span<const std::uint8_t> payload,
                  std::vector<Reading>& readings);
  static Type typeOf(std::string_view name);

  static constexpr std::size_t kMostIds = 2048;  // VRPN itself has no more than 2000 types and senders
  std::string sender_;
  std::bitset<kMostIds> senders_;  // ids that bear our sender's name
  std::array<Type, kMostIds> types_{};
  std::vector<NamedSender> named_;
  bool namesCount_ = true, senderNamed_ = false, senderHeard_ = false;
  std::vector<std::uint8_t> held_;  // the beginning of a record
  std::size_t used_ = 0;            // of it
  bool greeted_ = false, spoke_ = false;
  std::uint64_t refused_ = 0;
  int pings_ = 0;
};

/// Returns what a client sends first: its cookie.
std::vector<std::uint8_t> vrpnGreeting();
/// Returns what it sends next: the names under which it will ping `sender`.
std::vector<std::uint8_t> vrpnDescription(std::string_view sender);
/// Returns pings to some senders, each under a name of its own, for use after that description.
std::vector<std::uint8_t> vrpnPings(std::span<const VrpnDecoder::NamedSender> senders);
/// Return a ping, and the answer to one, for use after that description.
std::vector<std::uint8_t> vrpnPing();
std::vector<std::uint8_t> vrpnPong();

/// Returns the name under which a client sends fields of force to a force device, for use after that
/// description.
std::vector<std::uint8_t> vrpnForceDescription();
/// A field of force around a place: F = force + jacobian (x - origin) within the radius, and none beyond.
struct VrpnForceField {
  glm::dvec3 origin_m{0.0}, force_n{0.0};
  glm::dmat3 jacobian_n_m{0.0};
  double radius_m = 0.0;
};
/// Returns the message vrpn_ForceDevice Force_Field: 16 floats, the jacobian row by row. Source: VRPN,
/// vrpn_ForceDevice.C, encode_forcefield.
std::vector<std::uint8_t> vrpnForceField(const VrpnForceField& field);

}  // namespace carom
