#include "app/console_parts/console_link.h"

#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {

void drawLink(const ConsoleFrame& frame) {
  using namespace texts::link;
  const LinkReport& link = *frame.status.link;
  const std::string other = link.other.empty() ? kNobody.words() : link.other;
  heading(
      texts::format(kHeading, link.room, other, kStates.at(static_cast<std::size_t>(link.state))).c_str());
  if (link.staysOut) {
    if (ImGui::Button(kJoinAgain)) frame.commands.emplace_back(SetLinked{true});
  } else if (ImGui::Button(kLeave)) {
    frame.commands.emplace_back(SetLinked{false});
  }
  words(texts::format(kRoundTrip, 1e3 * link.roundTrip.median_s, 1e3 * link.roundTrip.p99_s));
  words(texts::format(kSlack, link.slack_s,
                      link.slack_s * frame.record.viewers.front().observer.headFromBoard.lightSpeed_m_s()));
  tip(kTip);
  words(texts::format(kPace, link.pace, 1e2 * link.waiting));
  words(texts::format(kStrokes, link.strokesIn, link.strokesOut, link.putOff));
  words(texts::format(kSame, link.sameUntil_s));
  words(texts::format(kClocks, link.own_s, link.others_s));
  words(texts::format(kApart, link.apart_m));
  words(texts::format(kTraffic, link.sent_kB_s, link.received_kB_s));
}

}  // namespace carom::console
