#include "app/journal/stored_event.h"

#include <cmath>

namespace carom {
namespace {

constexpr auto kLastKind = static_cast<std::uint8_t>(EventKind::jam);
constexpr auto kLastCushion = static_cast<std::uint8_t>(Cushion::minusY);

bool isFinite(const Event& e) {
  return std::isfinite(e.t_s) && std::isfinite(e.r_m.x) && std::isfinite(e.r_m.y) && std::isfinite(e.r_m.z);
}

}  // namespace

StoredEvent stored(const GameEvent& event) {
  StoredEvent bytes;
  bytes.number = event.number;
  bytes.which = event.which;
  bytes.kind = static_cast<std::uint8_t>(event.kind);
  if (event.cushion) bytes.cushion = static_cast<std::uint8_t>(1 + static_cast<int>(*event.cushion));
  bytes.withoutDelay = event.withoutDelay ? 1 : 0;
  bytes.at = event.at;
  bytes.heat_j = event.heat_j;
  for (const Turn& turn : event.turns) {
    bytes.turns[bytes.turnCount++] = {turn.puck, turn.event, turn.betaBefore, turn.betaAfter,
                                      turn.properTime_s};
  }
  return bytes;
}

std::optional<GameEvent> restored(const StoredEvent& bytes, std::uint64_t pucks) {
  if (bytes.kind > kLastKind || bytes.cushion > 1 + kLastCushion || bytes.turnCount > bytes.turns.size() ||
      bytes.withoutDelay > 1 || !isFinite(bytes.at)) {
    return std::nullopt;
  }
  GameEvent event;
  event.number = bytes.number;
  event.which = bytes.which;
  event.kind = static_cast<EventKind>(bytes.kind);
  if (bytes.cushion > 0) event.cushion = static_cast<Cushion>(bytes.cushion - 1);
  event.at = bytes.at;
  event.withoutDelay = bytes.withoutDelay == 1;
  event.heat_j = bytes.heat_j;
  for (std::size_t i = 0; i < bytes.turnCount; ++i) {
    const StoredEvent::StoredTurn& turn = bytes.turns[i];
    if (turn.puck >= pucks || !isFinite(turn.event)) return std::nullopt;
    event.turns.push_back({turn.puck, turn.event, turn.betaBefore, turn.betaAfter, turn.properTime_s});
  }
  return event;
}

}  // namespace carom
