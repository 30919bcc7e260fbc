#include "app/live/announcements.h"

#include <algorithm>
#include <utility>

#include "cave/texts/saying.h"
#include "cave/texts/texts.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// Returns the message about effects and views that commands have just turned on or off, or nothing.
texts::Saying changesBy(std::span<const Command> commands) {
  texts::Saying all;
  const auto say = [&all](const texts::Text& name, bool on) {
    if (!all.empty()) all += texts::Saying("    ");
    all += on ? texts::say(texts::message::kTurnedOn, name) : texts::say(texts::message::kTurnedOff, name);
  };
  for (const Command& command : commands) {
    const auto* turned = std::get_if<SetSwitch>(&command);
    if (!turned) continue;
    for (const NamedSwitch& effect : kNamedSwitches) {
      if (effect.value == turned->effect) say(turned->beside ? effect.rightWords : effect.words, turned->on);
    }
  }
  return all;
}

}  // namespace

Announcements::Announcements(const Rig& rig, const Scenario& scenario,
                             const std::optional<FrameRecord>& before)
    : rig_(rig),
      scenario_(scenario),
      standing_(standingWalls(rig)),
      boundaries_(rig.viewers.size(), RoomBoundary(standing_)) {
  if (before) captions_ = captionsBegunAt(before->viewers.front().observer.properTime_s);
}

void Announcements::play() {
  messages_ = {};
  kept_ = {};
  captions_ = 0;
  saidWhyStill_ = false;
  effects_.reset();
}

void Announcements::say(const texts::Saying& words, Decision& decision) {
  if (words.empty()) return;
  log::note(words.english());
  for (StatusMessage& message : messages_) message.say(words, decision.frame.record.display_s);
  decision.notes.push_back({"notice", words.english()});
}

void Announcements::sayTo(std::size_t viewer, const texts::Saying& words, Decision& decision) {
  if (words.empty()) return;
  log::note(words.english());
  messages_[viewer].say(words, decision.frame.record.display_s);
  decision.notes.push_back({"notice", words.english(), viewer});
}

void Announcements::tellEffects(std::span<const Command> commands, Decision& decision) {
  FrameRecord& record = decision.frame.record;
  const bool byCaption = std::exchange(captionTurnsEffects_, false);  // whose sentence tells of it
  const texts::Saying changes = byCaption ? texts::Saying() : changesBy(commands);
  if (!changes.empty() && effects_) {
    std::tie(record.switches, record.views.beside) = *effects_;
    pending_ = changes;
  } else {
    effects_ = {record.switches, record.views.beside};
  }
}

void Announcements::tellCarom(std::size_t viewer, std::size_t cushions, Decision& decision) {
  if (!scenario_.tasks.empty()) return;  // whether the task is done is told
  if (rig_.viewers.size() == 1) return say(texts::say(texts::message::kCarom, cushions), decision);
  for (std::size_t reader = 0; reader < rig_.viewers.size(); ++reader) {
    sayTo(reader,
          reader == viewer ? texts::say(texts::message::kCarom, cushions)
                           : texts::say(texts::message::kCaromOf, rig_.viewers[viewer].name, cushions),
          decision);
  }
}

void Announcements::tellWhoSawFirst(std::span<const HitSeen::Seen> seen, Decision& decision) {
  for (std::size_t reader = 0; reader < rig_.viewers.size(); ++reader) {
    const auto nameOf = [&](std::size_t viewer) {
      return viewer == reader ? texts::Saying(texts::legend::kMe) : texts::Saying(rig_.viewers[viewer].name);
    };
    const std::size_t first = seen.front().viewer;
    texts::Saying words = first == reader ? texts::Saying(texts::message::kYouSawHitFirst)
                                          : texts::say(texts::message::kSawHitFirst, nameOf(first));
    for (const HitSeen::Seen& later : seen.subspan(1)) {
      const double later_s = later.room_s - seen.front().room_s;
      words += texts::say(texts::message::kSawHitLater, nameOf(later.viewer), later_s,
                          later_s * scenario_.billiard.lightSpeed_m_s);
    }
    sayTo(reader, words, decision);
  }
}

void Announcements::tellWhoseShot(std::size_t striker, std::size_t cushions, bool isEnd, Decision& decision) {
  for (std::size_t reader = 0; reader < rig_.viewers.size(); ++reader) {
    const texts::Saying words =
        reader == striker ? texts::say(texts::message::kBestShot, cushions)
                          : texts::say(texts::message::kBestShotOf, rig_.viewers[striker].name, cushions);
    sayTo(reader,
          isEnd ? texts::say(texts::message::kLastShot, words)
                : words + texts::Saying(texts::message::kBackToGame),
          decision);
  }
}

void Announcements::tellWhyStill(bool asked, bool frozen, Decision& decision) {
  if (!asked) {
    saidWhyStill_ = false;
  } else if (!std::exchange(saidWhyStill_, true)) {
    say(frozen ? texts::message::kFrozen : texts::message::kAsks, decision);
  }
}

void Announcements::tellWhoLeft(const Viewers& viewers, Decision& decision) {
  for (std::size_t viewer = 0; viewer < boundaries_.size(); ++viewer) {
    if (const Wall* left = boundaries_[viewer].look(viewers.head(viewer).pose.position_m))
      sayTo(viewer, texts::say(texts::message::kLeftRoom, left->name), decision);
  }
}

void Announcements::putInto(Decision& decision) {
  FrameRecord& record = decision.frame.record;
  say(std::exchange(pending_, {}), decision);
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer)
    record.viewers[viewer].notice = messages_[viewer].at(record.display_s);
  for (ViewerState& viewer : record.present())
    if (viewer.notice.empty()) viewer.notice = kept_;
  const double own_s = record.viewers.front().observer.properTime_s;
  beginCaptions(own_s, decision);
  if (captions_ == 0) return;
  const Caption& latest = scenario_.captions[captions_ - 1];
  if (own_s >= latest.from_s + latest.for_s) return;
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    Notice& notice = record.viewers[viewer].notice;
    if (notice.empty()) notice = Notice(rig_.viewers[viewer].hand ? latest.handText : latest.text);
  }
}

void Announcements::beginCaptions(double own_s, Decision& decision) {
  const std::vector<Caption>& captions = scenario_.captions;
  for (const std::size_t begun = captionsBegunAt(own_s); captions_ < begun; ++captions_) {
    const Caption& caption = captions[captions_];
    const TimeViews before = captions_ > 0 ? captions[captions_ - 1].views : TimeViews();
    for (const NamedView& view : kNamedViews) {
      const bool on = caption.views.*view.value != 0;
      if (on || before.*view.value != 0) decision.commands.push_back(SetView{view.value, on});
    }
    if (caption.colour || (captions_ > 0 && captions[captions_ - 1].colour)) {
      captionTurnsEffects_ = true;
      for (const auto effect : {&Switches::colour, &Switches::searchlight})
        decision.commands.push_back(SetSwitch{effect, false, caption.colour});
    }
    decision.notes.push_back({"notice", caption.text});
  }
}

/// Returns how many of the scenario's captions have begun by this time of the observer's own clock.
std::size_t Announcements::captionsBegunAt(double own_s) const {
  const auto begun = std::partition_point(scenario_.captions.begin(), scenario_.captions.end(),
                                          [&](const Caption& caption) { return caption.from_s <= own_s; });
  return static_cast<std::size_t>(begun - scenario_.captions.begin());
}

}  // namespace carom
