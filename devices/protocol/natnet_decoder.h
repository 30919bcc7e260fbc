#pragma once
// Decodes datagrams of OptiTrack's NatNet 3 or 4 into readings. Rigid body n (its streaming ID) is sensor n.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

class WireReader;

/// What a NatNet server says about itself. The layout of its frames depends on the version.
struct NatnetServer {
  std::string application;
  int major = 0;
  int minor = 0;
  double ticksPerSecond = 0.0;  ///< of the clock that stamps frames; 0 if it does not say
};

class NatnetDecoder {
 public:
  enum class Packet {
    frame,    ///< the readings of its rigid bodies were appended
    server,   ///< the server's description: see `server()`
    other,    ///< of another kind, or a frame before the server was known
    refused,  ///< made no sense; nothing was appended
  };

  /// Takes one datagram. Poses are those at the middle of the exposure: `device_s` is when the frame was
  /// sent, and `latency_s` how long before that the exposure was, if the server measures it.
  Packet decode(std::span<const std::uint8_t> datagram, std::vector<Reading>& readings);

  const std::optional<NatnetServer>& server() const { return server_; }
  std::uint32_t frame() const { return frame_; }  ///< number of the last frame

 private:
  bool readServer(WireReader& wire);
  bool readFrame(WireReader& wire, std::vector<Reading>& readings);
  bool hasSizes() const { return server_->major > 4 || (server_->major == 4 && server_->minor > 0); }
  void skipMarkers(WireReader& wire) const;
  void skipAfterBodies(WireReader& wire) const;
  bool readTimes(WireReader& wire, Reading& times) const;

  std::optional<NatnetServer> server_;
  std::uint32_t frame_ = 0;
};

/// Returns the packet that asks the server for its version and, if it sends to single clients, to send to
/// this program.
std::vector<std::uint8_t> natnetConnect();
/// Returns the packet that tells a server which sends to single clients that this program is still there.
std::vector<std::uint8_t> natnetKeepAlive();

}  // namespace carom
