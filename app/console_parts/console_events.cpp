#include "app/console_parts/console_events.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/tables/event_table.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

const char* whatOf(const GameEvent& event) {
  switch (event.kind) {
    case EventKind::puckPuck:
    case EventKind::softSoft:
      return texts::console::kMeet;
    case EventKind::puckCushion:
    case EventKind::softCushion:
      return texts::console::kMeetsCushion;
    case EventKind::stroke:
      return texts::console::kIsStruck;
    case EventKind::flash:
      return texts::console::kFlashes;
    case EventKind::jam:
      return texts::console::kJam;
    case EventKind::parted:
      return texts::console::kParts;
    case EventKind::farSide:
      return texts::console::kFarSide;
  }
  return "";
}

}  // namespace

void EventsPanel::play(const Scenario& scenario) {
  pucks_.clear();
  flashes_.clear();
  for (const Puck& puck : scenario.billiard.pucks) pucks_.push_back(puck.name);
  for (const Flash& flash : scenario.billiard.flashes) flashes_.push_back(flash.name);
  nameInLanguage();
  c_m_s_ = scenario.billiard.lightSpeed_m_s;
  events_.clear();
}

void EventsPanel::follow(const World& world) {
  if (world.events.empty()) return;
  const std::uint64_t first = world.events.front().number;
  std::erase_if(events_, [first](const GameEvent& event) { return event.number >= first; });
  events_.insert(events_.end(), world.events.begin(), world.events.end());
  if (events_.size() > kKept) events_.erase(events_.begin(), events_.end() - kKept);
}

void EventsPanel::nameInLanguage() {
  language_ = texts::language();
  puckNames_.clear();
  flashNames_.clear();
  for (const std::string& name : pucks_) puckNames_.push_back(texts::other(name));
  for (const std::string& name : flashes_) flashNames_.push_back(texts::other(name));
}

/// Finds the events that have happened by now, by the board's clocks or in the viewer's own frame.
void EventsPanel::find(const FrameRecord& record) {
  const Event& here = record.viewers.front().observer.middle.observation;
  rows_.clear();
  for (const GameEvent& event : events_) {
    const Displacement ago = event.at - here;
    const double mine_s = (record.viewers.front().observer.headFromBoard * ago).dt_s;
    if ((mine_ ? mine_s : ago.dt_s) > 0.0) continue;
    const bool seen = ago.dt_s < 0.0 && interval_m2(ago, c_m_s_) >= 0.0;
    rows_.push_back({&event, event.at.t_s, record.viewers.front().observer.properTime_s + mine_s, seen});
  }
  std::stable_sort(rows_.begin(), rows_.end(), [this](const Row& a, const Row& b) {
    return mine_ ? a.mine_s > b.mine_s : a.board_s > b.board_s;
  });
}

void EventsPanel::drawRow(const Row& row) const {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  words(std::to_string(row.event->number));
  ImGui::TableNextColumn();
  words(whoOf(*row.event, puckNames_, flashNames_));
  ImGui::TableNextColumn();
  words(whatOf(*row.event));
  if (row.event->cushion) {
    ImGui::SameLine();
    words(nameOf(*row.event->cushion));
  }
  for (const auto& [time_s, chosen] : {std::pair(row.board_s, !mine_), std::pair(row.mine_s, mine_)}) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? kBright : kDim);
    seconds(time_s);
    ImGui::PopStyleColor();
  }
  ImGui::TableNextColumn();
  ImGui::TextColored(row.seen ? kGood : kDim, "%s",
                     (row.seen ? texts::console::kSeen : texts::console::kNotYet).words());
}

void EventsPanel::draw(const FrameRecord& record) {
  if (language_ != texts::language()) nameInLanguage();
  find(record);
  ImGui::AlignTextToFramePadding();
  words(texts::console::kHappened);
  ImGui::SameLine();
  if (ImGui::RadioButton(texts::console::kTableFrame, !mine_)) mine_ = false;
  ImGui::SameLine();
  if (ImGui::RadioButton(texts::console::kObserverFrame, mine_)) mine_ = true;
  tip(texts::console::kObserverFrameTip);
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("##events", 6, kFlags)) return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupScrollFreeze(0, 1);
  constexpr std::array<float, texts::console::kEventColumns.size()> kWidths_em{2.5F, 9.0F, 9.0F,
                                                                               7.0F, 9.0F, 0.0F};
  for (std::size_t i = 0; i < kWidths_em.size(); ++i) {
    const char* name = texts::console::kEventColumns[i];
    ImGui::TableSetupColumn(name, 0, kWidths_em[i] > 0.0F ? widthOf({name}, kWidths_em[i] * em) : 0.0F);
  }
  ImGui::TableHeadersRow();
  for (const Row& row : rows_) drawRow(row);
  ImGui::EndTable();
  if (rows_.empty()) dim(texts::console::kNothingYet);
}

}  // namespace carom::console
