#pragma once
// From a datagram of OptiTrack's NatNet 3 or 4 to readings. Rigid body n (its streaming ID) is sensor n.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

class WireReader;

/// What a NatNet server says of itself. The layout of its frames depends on the version.
struct NatnetServer {
  std::string application;
  int major = 0;
  int minor = 0;
  double ticksPerSecond = 0.0;  ///< of the clock that stamps frames; 0 where it does not say
};

class NatnetDecoder {
 public:
  enum class Packet {
    frame,    ///< what its rigid bodies did was appended
    server,   ///< the server has said what it is: `server()`
    other,    ///< of another kind, or a frame before the server was known
    refused,  ///< made no sense; nothing was appended
  };

  /// Takes one datagram. Poses are those of the middle of the exposure: `device_s` is when the frame was
  /// sent, and `latency_s` how long before that the exposure was, where the server measures it.
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

/// Asks the server what it is and, if it sends to single clients, to send to us.
std::vector<std::uint8_t> natnetConnect();
/// Tells a server that sends to single clients that we are still there.
std::vector<std::uint8_t> natnetKeepAlive();

}  // namespace carom
