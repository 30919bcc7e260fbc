#include "cave/sculpture/order_table.h"

#include <algorithm>
#include <cmath>

#include "cave/frame/event_mark.h"
#include "cave/texts/texts.h"
#include "engine/sculpture/event_order.h"

namespace carom {
namespace {

/// `picked`: as the record has it, 1 and the event's number.
const GameEvent* eventOf(std::span<const GameEvent> events, std::uint64_t picked) {
  const auto found = std::ranges::find(events, picked, [](const GameEvent& e) { return e.number + 1; });
  return found == events.end() ? nullptr : &*found;
}

/// The interval: the time of a clock that attends both, or their distance where they are simultaneous.
PlateText intervalOf(const Event& a, const Event& b, double c_m_s) {
  const double square_m2 = interval_m2(b - a, c_m_s);
  return square_m2 > 0.0 ? measured(texts::plate::kIntervalOfTime, std::sqrt(square_m2) / c_m_s)
                         : measured(texts::plate::kIntervalOfSpace, std::sqrt(-square_m2));
}

}  // namespace

OrderTable orderTable(const FrameRecord& record, std::size_t viewer, std::span<const GameEvent> events,
                      std::span<const std::string> flashes) {
  OrderTable table;
  const GameEvent *const last = eventOf(events, record.sculpture.picked), *const before = eventOf(
                                                                              events,
                                                                              record.sculpture.compared);
  if (!last) return table;
  const double c_m_s = record.viewers[viewer].observer.headFromBoard.lightSpeed_m_s();
  const auto orderFor = [&](const Vec3& beta) {
    if (!before)
      return written(texts::plate::kPlaceOf, placeAmong(last->at, events, beta, c_m_s), events.size());
    const int order = firstOf(before->at, last->at, beta, c_m_s);
    const GameEvent &first = order > 0 ? *last : *before, &second = order > 0 ? *before : *last;
    return written(order == 0 ? texts::plate::kTogether : texts::plate::kThen, eventMark(first, flashes),
                   eventMark(second, flashes));
  };
  const auto add = [&](OrderOf whose, const PlateText& who, const PlateText& what) {
    table.rows[table.count++] = {whose, who, what};
  };
  const auto betaOf = [&](std::size_t who) {
    return betaFromU(record.viewers[who].observer.headFromBoard.inverse().u());
  };
  if (before)
    add(OrderOf::interval, plateText(texts::plate::kInterval), intervalOf(before->at, last->at, c_m_s));
  add(OrderOf::table, plateText(texts::plate::kTable), orderFor(Vec3(0.0)));
  add(OrderOf::me, plateText(texts::plate::kYou), orderFor(betaOf(viewer)));
  for (std::size_t other = 0; other < record.viewerCount; ++other) {
    if (other == viewer) continue;
    add(OrderOf::other,
        record.viewerCount == 2 ? plateText(texts::plate::kOther) : written(texts::plate::kViewer, other + 1),
        orderFor(betaOf(other)));
  }
  return table;
}

}  // namespace carom
