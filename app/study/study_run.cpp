#include "app/study/study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
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

std::map<std::string, std::size_t> readSlips(const std::filesystem::path& file, std::size_t participants) {
  std::map<std::string, std::size_t> slips;
  std::vector<InputError> faults;
  const std::string text = readText(file, InputKind::trace);
  int line = 0;
  for (std::size_t from = 0; from < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string row = text.substr(from, end - from);
    from = end + 1;
    if (row.ends_with('\r')) row.pop_back();
    const auto fault = [&](const std::string& words) {
      if (faults.size() < kMostFindings) faults.emplace_back(file.string(), line + 1, 1, words);
    };
    if (line == 0) {
      if (row != "number,code") fault("expected the line number,code of carom study codes");
      continue;
    }
    const std::size_t comma = row.find(',');
    const auto number = comma == std::string::npos ? std::nullopt : wholeNumber(row.substr(0, comma));
    const auto code = comma == std::string::npos ? std::nullopt : codeOf(row.substr(comma + 1));
    if (!number || *number < 1.0 || *number > static_cast<double>(participants) ||
        *number != std::floor(*number))
      fault(fmt::format("there is no such number of a participant, expected 1 to {}", participants));
    else if (!code)
      fault("this is no code, expected one that carom study codes has drawn");
    else if (!slips.emplace(*code, static_cast<std::size_t>(*number)).second)
      fault("this code stands here twice, expected it once");
  }
  if (slips.empty() && faults.empty())
    faults.emplace_back(file.string(), 1, 1, "there is no code here, expected those of carom study codes");
  if (!faults.empty()) throw InputErrors(std::move(faults));
  return slips;
}

StudyRun::StudyRun(Setup setup, StudyTables& tables)
    : setup_(std::move(setup)), tables_(tables), planned_(allocate(setup_.study)) {
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
    if (!fields.has("code")) return codePage(setup_.study.title, "");
    return enter(fields["code"], now_s);
  }
  Place& place = places_.at(code->second);
  const Refusal refused = take(place, fields, now_s);
  store();
  return render(place, refused, now_s);
}

/// Returns why a code cannot be used now; empty if it can.
StudyRun::Refusal StudyRun::refusalOf(const std::string& code) const {
  if (!setup_.slips.contains(code)) return "This code is none of this study. Please look at the slip again.";
  const std::string withdrawn = sessionValue(tables_.database(), "study_withdrawn");
  if (withdrawn.find(withdrawnMark(code)) != std::string::npos)
    return "The data of this code were deleted, as its owner wished: it cannot be used again.";
  const std::size_t arm = planned_.at(setup_.slips.at(code) - 1).arm;
  if (!setup_.armsHere.empty() && !setup_.armsHere.at(arm))
    return "This code is for another room. Please tell the person who leads.";
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
  if (place.isUnwell) {
    place.isUnwell = false;
    return "";
  }
  if (place.asksUnwell) {
    const Refusal refused = takeRatings(place, std::span(&kUnwellDuring, 1), fields, now_s);
    if (refused.empty()) place.asksUnwell = false;
    return refused;
  }
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
    keep(place, std::move(row), true);
    if (row.item.starts_with("unwell") || std::string_view(question.id).starts_with("unwell"))
      place.isUnwell = value >= kUnwell;
  }
  place.askedUnwell_s = now_s;
  return "";
}

/// The present lesson is over: the next one begins, or the test after the last one.
void StudyRun::takeLesson(Place& place, double now_s) {
  if (inRoom_ != place.row.code) return enterRoom(place);
  if (now_s - place.askedUnwell_s >= kAskUnwellEvery_s) {
    place.asksUnwell = true;
    place.askedUnwell_s = now_s;
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

/// Says in the log how far a participant is: the code, and the arm only if the study is open.
void StudyRun::tellOperator(const Place& place) const {
  constexpr std::array<const char*, 10> kWords{"consent",      "background", "test before", "rating",
                                               "lesson",       "test after", "ratings",     "done",
                                               "delayed test", "done"};
  const ParticipantRow& row = place.row;
  std::string words = kWords.at(static_cast<std::size_t>(row.step));
  if (stepOf(row) == StudyStep::lessons)
    words += fmt::format(" {} of {}", row.lesson + 1, place.plan.lessons.size());
  if (!row.excluded.empty()) words = row.excluded;
  log::note(fmt::format("study: {} ({}){}: {}", row.code, row.number,
                        setup_.study.isOpen ? " in " + row.arm : "", words));
}

}  // namespace carom
