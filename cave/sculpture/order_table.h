#pragma once
// The table that stands at a picked event of the sculpture of spacetime: where the event comes in the order
// of the table, of the person, and of the others; of two events the interval, and which is first for each.

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "cave/marks/mark_buffer.h"
#include "cave/record/frame_state.h"

namespace carom {

/// Whose a row is.
enum class OrderOf { interval, table, me, other };

struct OrderRow {
  OrderOf whose = OrderOf::table;
  PlateText who, what;
};

struct OrderTable {
  std::array<OrderRow, 2 + kMostViewers> rows;
  std::size_t count = 0;
  std::span<const OrderRow> all() const { return std::span(rows).first(count); }
};

/// Returns the table for one viewer and the event that is picked; empty if `events` no longer has it.
/// `flashes`: the names of the game's flashes (cave/frame/event_mark.h).
OrderTable orderTable(const FrameRecord& record, std::size_t viewer, std::span<const GameEvent> events,
                      std::span<const std::string> flashes);

}  // namespace carom
