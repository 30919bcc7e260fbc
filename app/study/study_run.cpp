#include "app/study/study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "app/journal/session_games.h"
#include "app/study/study_code.h"
#include "engine/text/log.h"
#include "engine/text/plain_words.h"

namespace carom {
namespace {

constexpr std::size_t kMostTokens = 1000, kReasonLetters = 200, kBackgroundLetters = 40;
constexpr double kLongestLook_s = 600.0;  // of one item; a page that stays open overnight is none
constexpr int kDaysToDelayed = 7;
constexpr const char *kStudyPath = "/study", *kAt = "/study?at=";

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

std::string StudyRun::take(std::string_view form, double now_s) {
  const std::scoped_lock hold(mutex_);
  store();
  const FormFields fields(form);
  const auto code = codes_.find(fields["token"]);
  if (code == codes_.end()) return enter(fields, now_s);
  Place& place = places_.at(code->second);
  place.notice = take(place, fields, now_s);
  place.shown_s = now_s;
  store();
  const std::string end = endOf(place);
  if (end.empty()) return kAt + code->first;
  codes_.erase(code);
  return addressOf(endPage(end));
}

std::string StudyRun::page(std::string_view query) {
  const std::scoped_lock hold(mutex_);
  store();
  const FormFields fields(query);
  const std::string& token = fields["at"];
  if (const auto code = codes_.find(token); code != codes_.end())
    return render(places_.at(code->second), token);
  const auto page = pages_.find(token);
  return page == pages_.end() ? codePage(setup_.study.title, "") : page->second;
}

/// Keeps a page that is of no participant, and returns its address.
std::string StudyRun::addressOf(std::string page) {
  if (pages_.size() >= kMostTokens) pages_.erase(pages_.begin());
  const std::string token = setup_.newToken();
  pages_[token] = std::move(page);
  return kAt + token;
}

/// Returns the words at the end of a participant's visit; empty before.
std::string StudyRun::endOf(const Place& place) const {
  if (!place.row.excluded.empty())
    return "You have stopped. What you answered so far is kept, but left out of the analysis.";
  if (stepOf(place.row) == StudyStep::done) return "For today this was all.";
  return stepOf(place.row) == StudyStep::doneDelayed ? "This was the last test." : "";
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

std::string StudyRun::enter(const FormFields& fields, double now_s) {
  if (fields["go"] == "called" && called_.empty())
    return addressOf(
        codePage(setup_.study.title, "No code has been typed at the console. Please type yours here."));
  if (fields["go"] == "called") return enter(std::exchange(called_, {}), now_s);
  return fields.has("code") ? enter(fields["code"], now_s) : kStudyPath;
}

std::string StudyRun::enter(const std::string& typed, double now_s) {
  const std::optional<std::string> code = codeOf(typed);
  const Refusal refused =
      code ? refusalOf(*code) : "This is no code: a letter of it is mistyped. Please try again.";
  if (!refused.empty()) return addressOf(codePage(setup_.study.title, refused));
  Place& place = placeOf(*code);
  if (stepOf(place.row) == StudyStep::done) goTo(place, StudyStep::delayed);
  if (codes_.size() >= kMostTokens) codes_.erase(codes_.begin());
  std::erase_if(codes_, [&](const auto& one) { return one.second == *code; });  // one page a person
  const std::string token = setup_.newToken();
  codes_[token] = *code;
  place.shown_s = now_s;
  place.notice.clear();
  store();
  return kAt + token;
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
  if (go == "stop-now" && (place.isUnwell || place.asksStop)) {
    stop(place);
    return "";
  }
  if (std::exchange(place.asksStop, go == "stop")) return "";  // of that page every form but one goes on
  if (place.asksStop) return "";
  const bool isOfAnotherPage = go == "stop-now" || (go == "anyway" && !place.asksOnwards) ||
                               (go == "stay" && !place.isUnwell && !place.asksOnwards);
  if (isOfAnotherPage) return "";
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
      return takeBackground(place, fields);
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
      takeLesson(place, go, now_s);
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

/// A person under age goes on with a guardian's consent alone; without it no row of them stays.
StudyRun::Refusal StudyRun::takeBackground(Place& place, const FormFields& fields) {
  place.needsGuardian = fields["age_band"] == kUnderAge && !place.row.allows("guardian");
  if (place.needsGuardian) {
    place.row.consent.clear();
    unwritten_.emplace_back([this, code = place.row.code] { tables_.forget(code); });
    goTo(place, StudyStep::consent);
    return "You are under 18: the consent of a parent or guardian on paper is needed. Please speak to the "
           "person who leads before you go on.";
  }
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
  return "";
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

/// The present lesson is over: the next one begins, or the test after the last one. Before it has explained
/// itself the page asks once.
void StudyRun::takeLesson(Place& place, const std::string& go, double now_s) {
  if (inRoom_ != place.row.code) return enterRoom(place);
  if (now_s - place.askedUnwell_s >= kAskUnwellEvery_s) {
    askUnwell(place, now_s);
    return;
  }
  const bool isSure = place.hasExplained || (place.asksOnwards && go == "anyway");
  place.asksOnwards = !isSure && go != "stay";
  if (!isSure || go == "stay") return;
  place.hasExplained = false;
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

std::string StudyRun::render(const Place& place, const std::string& token) const {
  StudyPageFrame frame{token, place.row.step, place.item, place.notice};
  if (isTroubled_)
    frame.notice +=
        " Your answers cannot be stored at the moment; they are kept. Please tell the person who leads.";
  if (place.isUnwell || place.asksStop) return stopPage(frame, place.isUnwell);
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
      if (place.asksOnwards) return onwardsPage(frame);
      return lessonPage(frame, place.row.lesson, place.plan.lessons.size(), inRoom_ != place.row.code);
    case StudyStep::ratings:
      return ratingPage(frame, kRatingsAfter);
    case StudyStep::done:
    case StudyStep::doneDelayed:
      break;
  }
  return endPage(endOf(place));
}

std::string StudyRun::renderTest(const Place& place, const StudyPageFrame& frame) const {
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

}  // namespace carom
