#include "app/session/session_listeners.h"

#include <fmt/format.h>

#include "app/hand/cue.h"
#include "engine/base/limits.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenSignals = 30;

}  // namespace

void JournalListener::keep(std::unique_ptr<Journal> journal) {
  if (journal_) journal_->close();
  onLeaving_.reset();
  journal_ = std::move(journal);
  onLeaving_.emplace([this] {
    if (lastNotes_) add(lastNotes_());
    if (journal_) journal_->close();
  });
}

void JournalListener::shown(const Decision& decision) {
  if (!journal_) return;
  const std::uint64_t number = last_ = decision.frame.record.number;
  for (const Note& input : decision.inputs) journal_->addInput(number, input.what, input.value, input.viewer);
  for (const LessonAnswer& answer : decision.answers) {
    journal_->addAnswer(number, answer.lesson, answer.question, answer.answer, answer.viewer);
  }
  for (const ClassVote& vote : decision.votes) journal_->addVote(number, vote);
  for (const TaskNews& news : decision.tasks) journal_->addTask(number, news);
  for (const Note& note : decision.notes) journal_->addInput(number, note.what, note.value, note.viewer);
  if (statistics_) journal_->add(statistics_->rows());
  journal_->add(decision.frame, decision.heads, decision.samples, decision.strokes, decision.link);
}

void JournalListener::add(const std::vector<Note>& notes) {
  if (!journal_) return;
  for (const Note& note : notes) journal_->addInput(last_, note.what, note.value, note.viewer);
}

void HapticListener::shown(const Decision& decision) {
  constexpr double kKnock_s = 0.05, kFrame_s = 0.02, kTremble = 0.4;  // of the strength of a knock
  const HandView& hand = decision.frame.record.viewers.front().hand;
  if (!decision.strokes.empty()) {
    headset_.knock(1.0, kKnock_s);
  } else if (hand.pulling) {
    headset_.knock(kTremble * costOf(hand.u) / costOf(kStrongestU), kFrame_s);
  }
}

void ProgressListener::shown(const Decision& decision) {
  const std::uint64_t shown = decision.frame.record.number + 1;
  if (shown % kFramesBetweenSignals != 0) return;
  const std::optional<std::uint64_t> end = source_.status().end;
  log::note(fmt::format("frame {}{}", shown, end ? fmt::format(" of {}", *end) : ""));
}

}  // namespace carom
