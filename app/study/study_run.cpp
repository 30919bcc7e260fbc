#include "app/study/study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "app/journal/session_games.h"
#include "app/study/study_code.h"
#include "engine/base/log.h"
#include "engine/base/plain_words.h"

namespace carom {
namespace {

constexpr std::size_t kMostTokens = 1000, kReasonLetters = 200, kBackgroundLetters = 40;
constexpr double kLongestLook_s = 600.0;  // of one item; a page that stays open overnight is none
constexpr int kDaysToDelayed = 7;

StudyStep stepOf(const ParticipantRow& row) { return static_cast<StudyStep>(row.step); }

/// Returns which test a step is, as an index of kTestPhases; none if it is none.
std::optional<std::size_t> testOf(StudyStep step) {
  if (step == StudyStep::before) return 0;
  if (step == StudyStep::after) return 1;
  if (step == StudyStep::delayed) return 2;
  return {};
}

/// Returns the days from 1970 to a day such as 2026-11-23; 0 if it is none.
int daysOf(const std::string& day) {
  int year = 0;
  unsigned month = 0, date = 0;
  if (std::sscanf(day.c_str(), "%d-%u-%u", &year, &month, &date) != 3) return 0;
  const std::chrono::year_month_day given = std::chrono::year(year) / month / date;
  return given.ok() ? static_cast<int>(std::chrono::sys_days(given).time_since_epoch().count()) : 0;
}

std::string formsOf(const Participant& plan) {
  std::string forms;
  for (const std::size_t form : plan.forms) forms += kForms[form];
  return forms;
}

}  // namespace

StudyRun::StudyRun(Setup setup, StudyTables& tables)
    : setup_(std::move(setup)),
      tables_(tables),
      planned_(allocate(setup_.study)),
      withdrawn_(sessionValue(tables.database(), "study_withdrawn")) {
  for (const ParticipantRow& row : participantsIn(tables_.database())) {
    if (row.number < 1 || row.number > planned_.size()) continue;
    Place& place = places_[row.code];
    place.row = row;
    place.plan = planned_[row.number - 1];
    for (const ResponseRow& response : responsesOf(tables_.database(), row.code))
      place.responses[{response.phase, response.item}] = response;
  }
}

std::string StudyRun::page(std::string_view form, double now_s) {
  const std::scoped_lock hold(mutex_);
  store();
  const FormFields fields(form);
  const auto code = codes_.find(fields["token"]);
  if (code == codes_.end()) {
    if (fields["go"] == "called" && called_.empty())
      return codePage(setup_.study.title, "No code has been typed at the console. Please type yours here.");
    if (fields["go"] == "called") return enter(std::exchange(called_, {}), now_s);
    return fields.has("code") ? enter(fields["code"], now_s) : codePage(setup_.study.title, "");
  }
  Place& place = places_.at(code->second);
  const Refusal refused = take(place, fields, now_s);
  store();
  return render(place, refused, now_s);
}

/// Returns why a code cannot be used now; empty if it can.
StudyRun::Refusal StudyRun::refusalOf(const std::string& code) const {
  if (!setup_.slips.contains(code)) return "This code is none of this study. Please look at the slip again.";
  if (withdrawn_.find(withdrawnMark(code)) != std::string::npos)
    return "The data of this code were deleted, as its owner wished: it cannot be used again.";
  const std::size_t arm = planned_.at(setup_.slips.at(code) - 1).arm;
  if (!setup_.armsHere.empty() && !setup_.armsHere.at(arm))
    return fmt::format("This code is for another room ({}). Please tell the person who leads.",
                       setup_.study.arms.at(arm).rig.stem().string());
  const auto known = places_.find(code);
  if (known == places_.end()) return "";
  const ParticipantRow& row = known->second.row;
  if (!row.excluded.empty()) return "This code was used, and its participant stopped.";
  if (stepOf(row) == StudyStep::doneDelayed) return "This code was used, and its last test is handed in.";
  const int days = daysOf(setup_.today()) - daysOf(row.startedUtc);
  if (stepOf(row) == StudyStep::done && days < kDaysToDelayed)
    return fmt::format("This code was used. Its last test comes {} days after the first day ({}).",
                       kDaysToDelayed, row.startedUtc);
  return "";
}

std::string StudyRun::enter(const std::string& typed, double now_s) {
  const std::optional<std::string> code = codeOf(typed);
  if (!code)
    return codePage(setup_.study.title, "This is no code: a letter of it is mistyped. Please try again.");
  if (const Refusal refused = refusalOf(*code); !refused.empty())
    return codePage(setup_.study.title, refused);
  Place& place = placeOf(*code);
  if (stepOf(place.row) == StudyStep::done) goTo(place, StudyStep::delayed);
  if (codes_.size() >= kMostTokens) codes_.erase(codes_.begin());
  std::erase_if(codes_, [&](const auto& one) { return one.second == *code; });  // one page a person
  codes_[setup_.newToken()] = *code;
  store();
  return render(place, "", now_s);
}

/// Returns the place of a code, which may be new.
StudyRun::Place& StudyRun::placeOf(const std::string& code) {
  const auto known = places_.find(code);
  if (known != places_.end()) return known->second;
  Place& place = places_[code];
  place.plan = planned_.at(setup_.slips.at(code) - 1);
  place.row.code = code;
  place.row.number = place.plan.number;
  place.row.arm = setup_.study.arms[place.plan.arm].name;
  place.row.orderRow = place.plan.orderRow;
  place.row.forms = formsOf(place.plan);
  place.row.startedUtc = setup_.today();
  place.row.consentVersion = sha256Of(setup_.consent).substr(0, 12);
  return place;
}

/// Takes a form of the step that the participant is at; others, such as one sent twice, change nothing.
/// Returns why not, or nothing.
StudyRun::Refusal StudyRun::take(Place& place, const FormFields& fields, double now_s) {
  const StudyStep step = stepOf(place.row);
  if (fields.number("step", 100, -1) != place.row.step) return "";
  const std::string& go = fields["go"];
  if (go == "stop") {
    stop(place);
    return "";
  }
  if (place.isUnwell) {  // the offer to stop is seen, whatever page was open before
    place.isUnwell = go != "stay";
    isNews_ = true;
    return "";
  }
  if (place.asksUnwell)
    return go == "rate" ? takeRatings(place, std::span(&kUnwellDuring, 1), fields, now_s) : "";
  switch (step) {
    case StudyStep::consent:
      return takeConsent(place, fields);
    case StudyStep::background:
      takeBackground(place, fields);
      return "";
    case StudyStep::before:
    case StudyStep::after:
    case StudyStep::delayed:
      takeItem(place, fields, now_s);
      return "";
    case StudyStep::wellBefore: {
      const Refusal refused = takeRatings(place, std::span(&kUnwellBefore, 1), fields, now_s);
      if (refused.empty()) {
        goTo(place, StudyStep::lessons);
        place.askedUnwell_s = now_s;
        enterRoom(place);
      }
      return refused;
    }
    case StudyStep::lessons:
      takeLesson(place, now_s);
      return "";
    case StudyStep::ratings: {
      const Refusal refused = takeRatings(place, kRatingsAfter, fields, now_s);
      if (refused.empty()) goTo(place, StudyStep::done);
      place.isUnwell = false;
      return refused;
    }
    case StudyStep::done:
    case StudyStep::doneDelayed:
      break;
  }
  return "";
}

StudyRun::Refusal StudyRun::takeConsent(Place& place, const FormFields& fields) {
  if (fields["part"] != "yes") return "To take part, tick the first box. Otherwise press \"I want to stop\".";
  place.row.consent = "take-part";
  for (const char* box : {"paths", "publish", "guardian"}) {
    if (fields[box] == "yes") place.row.consent += std::string(" ") + box;
  }
  goTo(place, StudyStep::background);
  return "";
}

void StudyRun::takeBackground(Place& place, const FormFields& fields) {
  for (const BackgroundQuestion& question : kBackground) {
    if (std::string_view(question.id) == "gender" && !setup_.study.asksGender) continue;
    const std::string answer = plainWords(fields[question.id], kBackgroundLetters);
    const bool isBand = std::any_of(question.bands.begin(), question.bands.end(),
                                    [&](const char* band) { return band && answer == band; });
    ResponseRow row;
    row.phase = "background";
    row.item = question.id;
    row.answer = isBand || !question.bands[0] ? answer : "";
    keep(place, std::move(row), false);
  }
  goTo(place, StudyStep::before);
}

std::vector<const Item*> StudyRun::itemsOf(const Place& place) const {
  return setup_.study.bank.ofForm(place.plan.forms[testOf(stepOf(place.row)).value()]);
}

/// Takes the answer to an item, and goes to the next one or back. After the last one stands the page from
/// which the test is handed in.
void StudyRun::takeItem(Place& place, const FormFields& fields, double now_s) {
  const std::vector<const Item*> items = itemsOf(place);
  const std::size_t test = *testOf(stepOf(place.row));
  const auto at = static_cast<std::size_t>(
      fields.number("item", static_cast<int>(items.size()), static_cast<int>(place.item)));
  const bool isBack = fields["go"] == "back";
  if (at == items.size()) {
    place.item = isBack ? items.size() - 1 : at;
    if (isBack) return;
    constexpr std::array<StudyStep, 3> kNext{StudyStep::wellBefore, StudyStep::ratings,
                                             StudyStep::doneDelayed};
    for (const Item* item : items) {  // an item without an answer has a row, too
      ResponseRow empty;
      empty.phase = kTestPhases[test];
      empty.form = kForms[item->form];
      empty.item = item->id;
      if (!place.responses.contains({empty.phase, empty.item})) keep(place, empty, false);
    }
    place.item = 0;
    goTo(place, kNext[test]);
    return;
  }
  const Item& item = *items[at];
  ResponseRow row = place.responses[{kTestPhases[test], item.id}];
  const ResponseRow before = row;
  const std::string& given = fields["answer"];
  if (item.answer(given) || given == kDontKnow) row.answer = given;
  row.confidence = fields.number("confidence", 4, row.confidence);
  if (setup_.study.asksReasons) row.reason = plainWords(fields["reason"], kReasonLetters);
  row.phase = kTestPhases[test];
  row.form = kForms[item.form];
  row.item = item.id;
  row.seconds += std::clamp(now_s - place.shown_s, 0.0, kLongestLook_s);
  const bool isChanged = row.answer != before.answer || row.confidence != before.confidence;
  if (!before.answer.empty() && row.answer != before.answer) ++row.changes;
  row.t_s = session_s_;
  keep(place, std::move(row), isChanged);
  place.item = isBack ? (at > 0 ? at - 1 : 0) : at + 1;
}

StudyRun::Refusal StudyRun::takeRatings(Place& place, std::span<const RatingQuestion> questions,
                                        const FormFields& fields, double now_s) {
  for (const RatingQuestion& question : questions) {
    if (fields.number(question.id, 10, -1) < 0) return "Please choose a number for each question.";
  }
  for (const RatingQuestion& question : questions) {
    ResponseRow row;
    row.phase = "rating";
    row.item = question.id;
    if (row.item == kUnwellDuring.id) {
      const auto same = [](const auto& one) { return one.first.second.starts_with(kUnwellDuring.id); };
      row.item += fmt::format("-{}", 1 + std::count_if(place.responses.begin(), place.responses.end(), same));
    }
    const int value = fields.number(question.id, 10, 0);
    row.answer = std::to_string(value);
    row.seconds = std::clamp(now_s - place.shown_s, 0.0, kLongestLook_s);
    row.t_s = session_s_;
    if (row.item.starts_with("unwell")) place.isUnwell = value >= kUnwell;
    keep(place, std::move(row), true);
  }
  place.asksUnwell = false;
  place.askedUnwell_s = now_s;
  isNews_ = true;
  return "";
}

/// The present lesson is over: the next one begins, or the test after the last one.
void StudyRun::takeLesson(Place& place, double now_s) {
  if (inRoom_ != place.row.code) return enterRoom(place);
  if (now_s - place.askedUnwell_s >= kAskUnwellEvery_s) {
    askUnwell(place, now_s);
    return;
  }
  ++place.row.lesson;
  if (place.row.lesson < place.plan.lessons.size()) {
    goTo(place, StudyStep::lessons);
    return enterRoom(place);
  }
  leaveRoom(place);
  goTo(place, StudyStep::after);
}

/// Has the page of somebody in a lesson ask how they feel.
void StudyRun::askUnwell(Place& place, double now_s) {
  place.askedUnwell_s = now_s;
  if (!std::exchange(place.asksUnwell, true)) tellOperator(place);
}

void StudyRun::stop(Place& place) {
  leaveRoom(place);
  place.row.excluded = "stopped";
  goTo(place, stepOf(place.row));
}

/// Wishes for the present lesson of a participant, unless somebody else is in the room.
void StudyRun::enterRoom(Place& place) {
  if (!inRoom_.empty() && inRoom_ != place.row.code) return;
  inRoom_ = place.row.code;
  wish_ =
      RoomWish{place.row.code, place.plan.lessons.at(place.row.lesson), place.row.lesson + 1, place.plan.arm};
}

void StudyRun::leaveRoom(const Place& place) {
  if (inRoom_ != place.row.code) return;
  inRoom_.clear();
  wish_ = RoomWish{};
}

void StudyRun::goTo(Place& place, StudyStep step) {
  place.row.step = static_cast<int>(step);
  tellOperator(place);
  if (place.row.consent.empty() && place.row.excluded.empty()) return;  // nothing is stored without consent
  if (place.row.consent.empty()) place.row.consent = "none";
  unwritten_.emplace_back([this, row = place.row] { tables_.write(row); });
}

void StudyRun::keep(Place& place, ResponseRow row, bool isChanged) {
  place.responses[{row.phase, row.item}] = row;
  unwritten_.emplace_back([this, code = place.row.code, row = std::move(row), isChanged] {
    tables_.write(code, row, isChanged);
  });
}

/// Writes what waits. While the disk is full it goes on waiting, and the pages say so.
void StudyRun::store() {
  try {
    for (; !unwritten_.empty(); unwritten_.pop_front()) unwritten_.front()();
    if (isTroubled_) log::note("The answers of the study are being written again.");
    isTroubled_ = false;
  } catch (const SQLite::Exception& error) {
    if (!isTroubled_)
      log::warn(fmt::format("the answers of the study cannot be written: {}. They are kept in memory.",
                            error.what()));
    isTroubled_ = true;
  }
}

std::string StudyRun::render(Place& place, const Refusal& notice, double now_s) {
  place.shown_s = now_s;
  if (!place.row.excluded.empty()) return endPage("You have stopped. What you answered so far is not used.");
  const auto token = std::find_if(codes_.begin(), codes_.end(),
                                  [&](const auto& one) { return one.second == place.row.code; });
  StudyPageFrame frame{token == codes_.end() ? "" : token->first, place.row.step, place.item, notice};
  if (isTroubled_)
    frame.notice +=
        " Your answers cannot be stored at the moment; they are kept. Please tell the person who leads.";
  if (place.isUnwell) return stopPage(frame);
  if (place.asksUnwell) return ratingPage(frame, std::span(&kUnwellDuring, 1));
  switch (stepOf(place.row)) {
    case StudyStep::consent:
      return consentPage(frame, setup_.consent);
    case StudyStep::background:
      return backgroundPage(frame, setup_.study.asksGender);
    case StudyStep::before:
    case StudyStep::after:
    case StudyStep::delayed:
      return renderTest(place, frame);
    case StudyStep::wellBefore:
      return ratingPage(frame, std::span(&kUnwellBefore, 1));
    case StudyStep::lessons:
      return lessonPage(frame, place.row.lesson, place.plan.lessons.size(), inRoom_ != place.row.code);
    case StudyStep::ratings:
      return ratingPage(frame, kRatingsAfter);
    case StudyStep::done:
      return endPage("For today this was all.");
    case StudyStep::doneDelayed:
      break;
  }
  return endPage("This was the last test.");
}

std::string StudyRun::renderTest(Place& place, const StudyPageFrame& frame) const {
  const std::vector<const Item*> items = itemsOf(place);
  const char* phase = kTestPhases[*testOf(stepOf(place.row))];
  const auto answerTo = [&](const Item& item) {
    const auto found = place.responses.find({phase, item.id});
    return found == place.responses.end()
               ? FormAnswer{}
               : FormAnswer{found->second.answer, found->second.confidence, found->second.reason};
  };
  if (place.item >= items.size()) {
    const auto open = std::count_if(items.begin(), items.end(),
                                    [&](const Item* item) { return answerTo(*item).answer.empty(); });
    return handInPage(frame, static_cast<std::size_t>(open));
  }
  const Item& item = *items[place.item];
  return itemPage(frame, item, place.item, items.size(), answerTo(item), setup_.study.asksReasons);
}

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

bool StudyRun::asksUnwell(double now_s) {
  const std::unique_lock hold(mutex_, std::try_to_lock);
  if (!hold || inRoom_.empty()) return false;
  Place& place = places_.at(inRoom_);
  const double every_s = place.asksUnwell ? kRemindEvery_s : kAskUnwellEvery_s;
  if (stepOf(place.row) != StudyStep::lessons || place.isUnwell || now_s - place.askedUnwell_s < every_s)
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
    const StudyStep step = stepOf(place.row);
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
  if (stepOf(row) == StudyStep::lessons)
    words += fmt::format(" {} of {}", row.lesson + 1, place.plan.lessons.size());
  if (place.asksUnwell) words += ", asked how they feel";
  if (!row.excluded.empty()) words = row.excluded;
  return setup_.study.isOpen ? fmt::format("{} ({})", words, row.arm) : words;
}

/// Says in the log how far a participant is.
void StudyRun::tellOperator(const Place& place) {
  isNews_ = true;
  log::note(fmt::format("study: {} ({}): {}", place.row.code, place.row.number, wordsOf(place)));
}

}  // namespace carom
