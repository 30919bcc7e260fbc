// A connection on which a server says anything in place of QTM: packets, frames and lists of bodies. The
// first byte says how it is cut.

#include <algorithm>
#include <stdexcept>

#include "devices/protocol/qtm_bodies.h"
#include "devices/protocol/qtm_frame.h"
#include "devices/protocol/qtm_packets.h"
#include "fuzz/expect.h"

namespace {

void understand(const carom::QtmPacket& packet) {
  std::vector<carom::Reading> readings;
  if (packet.type == carom::QtmPacket::Type::data) carom::readQtmFrame(packet.content, readings);
  if (packet.type == carom::QtmPacket::Type::xml) carom::readQtmBodies(packet.text());
  carom::test::expectSound(readings);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t piece = 1 + bytes[0];
  carom::QtmPackets packets;
  try {
    for (std::size_t at = 1; at < size; at += piece) {
      packets.add({bytes + at, std::min(piece, size - at)});
      while (const auto packet = packets.next()) understand(*packet);
    }
  } catch (const std::runtime_error&) {  // it hangs up
  }
  return 0;
}
