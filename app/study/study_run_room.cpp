// What the room and the console see of a study: the lessons that are wanted, who is how far, and the orders
// of the person who leads.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "app/study/study_code.h"
#include "app/study/study_run.h"
#include "engine/text/log.h"

namespace carom {

std::optional<RoomWish> StudyRun::takeWish() {
  const std::unique_lock hold(mutex_, std::try_to_lock);
  return hold ? std::exchange(wish_, {}) : std::nullopt;
}

void StudyRun::lessonBegins(const RoomWish& wish) {
  const std::scoped_lock hold(mutex_);
  unwritten_.emplace_back([this, wish] {
    tables_.beginLesson(wish.code, setup_.study.lessons.at(wish.lesson).name, wish.position);
  });
  store();
}

bool StudyRun::lessonExplains(const RoomWish& wish) {
  const std::unique_lock hold(mutex_, std::try_to_lock);
  if (!hold) return false;
  Place& place = places_.at(wish.code);
  if (place.row.lesson + 1 == wish.position) place.hasExplained = true;
  return true;
}

bool StudyRun::asksUnwell(double now_s) {
  const std::unique_lock hold(mutex_, std::try_to_lock);
  if (!hold || inRoom_.empty()) return false;
  Place& place = places_.at(inRoom_);
  const double every_s = place.asksUnwell ? kRemindEvery_s : kAskUnwellEvery_s;
  if (static_cast<StudyStep>(place.row.step) != StudyStep::lessons || place.isUnwell ||
      now_s - place.askedUnwell_s < every_s)
    return false;
  askUnwell(place, now_s);
  return true;
}

std::optional<std::string> StudyRun::order(const StudyOrder& order, double now_s) {
  const std::unique_lock hold(mutex_, std::try_to_lock);
  if (!hold) return {};
  return std::visit([&](const auto& one) { return carryOut(one, now_s); }, order);
}

std::string StudyRun::carryOut(const CallCode& called, double /*now_s*/) {
  const std::optional<std::string> code = codeOf(called.typed);
  if (!code) return "This is no code: a letter of it is mistyped.";
  if (Refusal refused = refusalOf(*code); !refused.empty()) return refused;
  called_ = *code;
  const StudyArm& arm = setup_.study.arms.at(planned_.at(setup_.slips.at(*code) - 1).arm);
  return fmt::format("{}{}: ready. On the tablet: \"My code was typed for me\".", *code,
                     setup_.study.isOpen ? " (" + arm.name + ")" : "");
}

std::string StudyRun::carryOut(const RateUnwell& rated, double now_s) {
  if (inRoom_.empty()) return "Nobody is in a lesson.";
  Place& place = places_.at(inRoom_);
  place.shown_s = place.asksUnwell ? place.askedUnwell_s : now_s;
  takeRatings(place, std::span(&kUnwellDuring, 1),
              FormFields(fmt::format("{}={}", kUnwellDuring.id, rated.value)), now_s);
  if (place.isUnwell) return fmt::format("{} feels unwell: offer to stop.", inRoom_);
  return fmt::format("{}: {} is kept.", inRoom_, rated.value);
}

std::string StudyRun::carryOut(const StopInRoom& /*stopped*/, double /*now_s*/) {
  if (inRoom_.empty()) return "Nobody is in a lesson.";
  const std::string code = inRoom_;
  stop(places_.at(code));
  return fmt::format("{} has stopped.", code);
}

std::optional<std::vector<StudyStanding>> StudyRun::takeStandings() {
  const std::unique_lock hold(mutex_, std::try_to_lock);
  if (!hold || !std::exchange(isNews_, false)) return {};
  std::vector<StudyStanding> all;
  for (const auto& [code, place] : places_) {
    const StudyStep step = static_cast<StudyStep>(place.row.step);
    if (!place.row.excluded.empty() || step == StudyStep::done || step == StudyStep::doneDelayed) continue;
    const bool isInRoom = code == inRoom_;
    all.push_back({code, wordsOf(place), isInRoom, isInRoom && place.asksUnwell, place.isUnwell});
  }
  return all;
}

/// Returns how far a participant is, and the arm only if the study is open.
std::string StudyRun::wordsOf(const Place& place) const {
  constexpr std::array<const char*, 10> kWords{"consent",      "background", "test before", "rating",
                                               "lesson",       "test after", "ratings",     "done",
                                               "delayed test", "done"};
  const ParticipantRow& row = place.row;
  std::string words = kWords.at(static_cast<std::size_t>(row.step));
  if (static_cast<StudyStep>(row.step) == StudyStep::lessons)
    words += fmt::format(" {} of {}", row.lesson + 1, place.plan.lessons.size());
  if (place.asksUnwell) words += ", asked how they feel";
  if (place.needsGuardian) words += ", under 18 without the consent of a guardian: speak with them";
  if (!row.excluded.empty()) words = row.excluded;
  return setup_.study.isOpen ? fmt::format("{} ({})", words, row.arm) : words;
}

/// Says in the log how far a participant is.
void StudyRun::tellOperator(const Place& place) {
  isNews_ = true;
  log::note(fmt::format("study: {} ({}): {}", place.row.code, place.row.number, wordsOf(place)));
}

}  // namespace carom
