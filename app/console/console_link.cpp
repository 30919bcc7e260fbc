#include "app/console/console_link.h"

#include <fmt/format.h>

#include "cave/texts/link_texts.h"

namespace carom::console {

void drawLink(const ConsoleFrame& frame) {
  using namespace texts::link;
  const LinkReport& link = *frame.status.link;
  const std::string other = link.other.empty() ? kNobody : link.other;
  heading(fmt::format(kHeading, link.room, other, kStates.at(static_cast<std::size_t>(link.state))).c_str());
  if (link.staysOut) {
    if (ImGui::Button(kJoinAgain)) frame.commands.emplace_back(SetLinked{true});
  } else if (ImGui::Button(kLeave)) {
    frame.commands.emplace_back(SetLinked{false});
  }
  words(fmt::format(kRoundTrip, 1e3 * link.roundTrip.median_s, 1e3 * link.roundTrip.p99_s));
  words(fmt::format(kSlack, link.slack_s,
                    link.slack_s * frame.record.viewers.front().observer.headFromBoard.lightSpeed_m_s()));
  tip(kTip);
  words(fmt::format(kPace, link.pace, 1e2 * link.waiting));
  words(fmt::format(kStrokes, link.strokesIn, link.strokesOut, link.putOff));
  words(fmt::format(kSame, link.sameUntil_s));
  words(fmt::format(kClocks, link.own_s, link.others_s));
  words(fmt::format(kApart, link.apart_m));
  words(fmt::format(kTraffic, link.sent_kB_s, link.received_kB_s));
}

}  // namespace carom::console
