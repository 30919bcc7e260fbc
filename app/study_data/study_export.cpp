#include "app/study_data/study_export.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

#include "app/journal/session_facts.h"
#include "app/journal/session_games.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/study/study.h"
#include "app/study/study_progress.h"
#include "app/study/study_tables.h"
#include "app/study_data/lesson_behaviour.h"
#include "app/study_data/motion_export.h"
#include "app/study_data/study_columns.h"
#include "cave/room/room_geometry.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

namespace fs = std::filesystem;
using Values = std::map<std::string_view, std::string>;

/// A session file that is read.
struct OpenSession {
  fs::path file;
  SQLite::Database database;
  Study study;
  std::string sha256Before;
  std::set<std::string> withdrawals;  ///< identifiers of deletions
  int withdrew = 0;                   ///< how many, also those without an identifier

  explicit OpenSession(const fs::path& path)
      : file(path), database(path.string(), SQLite::OPEN_READONLY, 2000) {}
};

std::unique_ptr<OpenSession> openSession(const fs::path& file) try {
  auto session = std::make_unique<OpenSession>(file);
  if (session->database.execAndGet("PRAGMA user_version").getInt() != kJournalVersion ||
      !hasStudy(session->database))
    throw std::runtime_error(fmt::format(
        "{}: there is no study in this file, expected a session of carom cave --study", file.string()));
  session->study =
      keptStudy(sessionValue(session->database, "study"), sessionValue(session->database, "study_items"));
  session->sha256Before = sessionValue(session->database, "study_sha256_before");
  const std::string withdrew = sessionValue(session->database, "study_withdrew");
  session->withdrew = withdrew.empty() ? 0 : std::atoi(withdrew.c_str());
  std::istringstream withdrawals(sessionValue(session->database, "study_withdrawals"));
  for (std::string one; withdrawals >> one;) session->withdrawals.insert(one);
  return session;
} catch (const SQLite::Exception& error) {
  throw std::runtime_error(fmt::format("{}: {}, expected a session file", file.string(), error.what()));
}

/// Throws unless both sessions are of one study, which may have been amended.
void checkSameStudy(const OpenSession& first, const OpenSession& other) {
  const auto isEarlier = [](const OpenSession& one, const OpenSession& than) {
    return than.sha256Before.find(one.study.sha256) != std::string::npos;
  };
  if (first.study.sha256 == other.study.sha256 || isEarlier(first, other) || isEarlier(other, first)) return;
  throw std::runtime_error(fmt::format(
      "{} is of another study than {} ('{}' and '{}'; SHA-256 {:.12} and {:.12}), expected sessions "
      "of one study",
      other.file.string(), first.file.string(), other.study.title, first.study.title, other.study.sha256,
      first.study.sha256));
}

/// Throws if both files are of the same session: its people would be counted twice. A copy began in the same
/// second, and has some of the same people.
void checkAnother(OpenSession& first, OpenSession& other) {
  std::error_code failed;
  const auto first_ = participantsIn(first.database), other_ = participantsIn(other.database);
  const auto isIn = [&](const ParticipantRow& row) {
    return std::any_of(first_.begin(), first_.end(),
                       [&](const ParticipantRow& one) { return one.code == row.code; });
  };
  const bool isCopy =
      sessionValue(first.database, "started_utc") == sessionValue(other.database, "started_utc") &&
      std::any_of(other_.begin(), other_.end(), isIn);
  if (!isCopy && !fs::equivalent(first.file, other.file, failed)) return;
  throw std::runtime_error(fmt::format("{} is the same session as {}, expected each session once",
                                       other.file.string(), first.file.string()));
}

/// The CSV files of an export.
struct StudyFiles {
  StudyCsv responses{"responses.csv"}, people{"participants.csv"}, behaviour{"behaviour.csv"},
      study{"study.csv"};
  std::map<std::pair<std::string, std::string>, int> attempts;  ///< so far, by code and lesson
};

Values commonValues(const OpenSession& session, const ParticipantRow& person) {
  return {{"study", session.study.title},
          {"participant", person.code},
          {"arm", person.arm},
          {"order_row", std::to_string(person.orderRow)}};
}

std::string excludedBy(const ParticipantRow& person) {
  if (!person.excluded.empty()) return person.excluded;
  return person.step < static_cast<int>(StudyStep::done) ? "unfinished" : "";
}

/// Adds the rows of a test: one for each item of its form, also of those without an answer.
void addTest(const OpenSession& session, const ParticipantRow& person, std::size_t phase,
             const std::vector<ResponseRow>& responses, StudyCsv& file) {
  const std::size_t form = std::string_view("ABC").find(person.forms.at(phase));
  std::size_t position = 0;
  for (const Item* item : session.study.bank.ofForm(form)) {
    const auto given = std::find_if(responses.begin(), responses.end(), [&](const ResponseRow& row) {
      return row.phase == kTestPhases[phase] && row.item == item->id;
    });
    Values row = commonValues(session, person);
    const bool isShown = given != responses.end();
    const std::string answer = isShown ? given->answer : "";
    const ItemAnswer* chosen = item->answer(answer);
    const int confidence = isShown ? given->confidence : 0;
    row.insert({{"phase", kTestPhases[phase]},
                {"form", kForms[form]},
                {"item", item->id},
                {"concept", item->concept_},
                {"position", std::to_string(++position)},
                {"answer", answer},
                {"correct", answer.empty()              ? ""
                            : chosen && chosen->isRight ? "1"
                                                        : "0"},
                {"misconception", chosen ? chosen->misconception : ""},
                {"confidence", confidence > 0 ? std::to_string(confidence) : ""},
                {"seconds", isShown ? fmt::format("{:.1f}", given->seconds) : ""},
                {"changes", isShown ? std::to_string(given->changes) : ""},
                {"reason", isShown ? masked(given->reason) : ""}});
    file.add(row);
  }
}

Values rowWithoutItem(const OpenSession& session, const ParticipantRow& person, std::string_view phase) {
  Values row = commonValues(session, person);
  row["phase"] = phase;
  for (const char* empty : {"form", "concept", "misconception", "confidence", "seconds", "changes", "reason"})
    row[empty] = "";
  return row;
}

void addRatings(const OpenSession& session, const ParticipantRow& person,
                const std::vector<ResponseRow>& responses, StudyCsv& file) {
  std::size_t position = 0;
  for (const ResponseRow& rating : responses) {
    if (rating.phase != "rating") continue;
    Values row = rowWithoutItem(session, person, "rating");
    row.insert({{"item", rating.item},
                {"position", std::to_string(++position)},
                {"answer", rating.answer},
                {"correct", ""}});
    row["seconds"] = fmt::format("{:.1f}", rating.seconds);
    row["changes"] = std::to_string(rating.changes);
    file.add(row);
  }
}

/// Adds the first answer that the person gave in the room to the question of a lesson.
void addLessonAnswer(OpenSession& session, const ParticipantRow& person, const ParticipationRow& lesson,
                     const SessionGame& game, std::int64_t end, StudyCsv& file) {
  SQLite::Statement given(
      session.database,
      "SELECT answer, (SELECT display_s FROM frame WHERE number >= a.frame ORDER BY number "
      "LIMIT 1) FROM answer a WHERE frame >= ? AND frame < ? ORDER BY frame LIMIT 1");
  given.bind(1, lesson.firstFrame);
  given.bind(2, end);
  const std::optional<Lesson> asked = readScenario(game.scenario, game.scenarioText).lesson;
  if (!asked || !given.executeStep()) return;
  const std::vector<std::string>& answers = asked->words.answers;
  const auto found = std::find(answers.begin(), answers.end(), given.getColumn(0).getString());
  if (found == answers.end()) return;
  const auto number = static_cast<std::size_t>(found - answers.begin());
  Values row = rowWithoutItem(session, person, "lesson");
  row.insert({{"item", lesson.lesson},
              {"position", std::to_string(lesson.position)},
              {"answer", std::to_string(number + 1)},
              {"correct", number == asked->words.right ? "1" : "0"}});
  row["seconds"] = fmt::format("{:.1f}", std::max(0.0, given.getColumn(1).getDouble() - game.from_s));
  file.add(row);
}

HeadInRoom headOf(OpenSession& session) {
  const fs::path file = sessionValue(session.database, "rig_file");
  const Rig rig = readRig(file, sessionValue(session.database, "rig"));
  const RoomGeometry room = roomGeometryOf(rig);
  HeadInRoom head;
  head.axesOfSensor = glm::mat3_cast(room.viewers.front().sensorFromEyes.orientation);
  head.forward = room.forward;
  if (const std::optional<Wall> front = frontWall(room))
    head.panelMiddle_m = 0.5 * (front->lowerRight_m + front->upperLeft_m);
  return head;
}

void addBehaviour(const LessonBehaviour& seen, const ParticipationRow& lesson, int attempt, StudyCsv& file) {
  const auto number = [](double value) { return fmt::format("{:.6g}", value); };
  file.add({{"participant", lesson.code},
            {"lesson", lesson.lesson},
            {"position", std::to_string(lesson.position)},
            {"attempt", std::to_string(attempt)},
            {"ask_s", number(seen.ask_s)},
            {"show_s", number(seen.show_s)},
            {"explain_s", number(seen.explain_s)},
            {"explained", seen.hasExplained ? "1" : "0"},
            {"repeats", std::to_string(seen.repeats)},
            {"velocities", fmt::format("{}", fmt::join(seen.velocities, " "))},
            {"views_switched", std::to_string(seen.viewsSwitched)},
            {"strokes", std::to_string(seen.strokes)},
            {"path_m", number(seen.path_m)},
            {"beta_mean", number(seen.betaMean)},
            {"beta_most", number(seen.betaMost)},
            {"towards_table", number(seen.towardsTable)},
            {"towards_panel", seen.towardsPanel ? number(*seen.towardsPanel) : ""},
            {"blank_s", number(seen.blank_s)},
            {"lost_s", number(seen.lost_s)}});
}

/// Adds what the participants did in their lessons, and their paths if they are wanted and allowed.
void addLessons(OpenSession& session, const StudyExport& wanted, const fs::path& folder, StudyFiles& files) {
  const std::vector<ParticipationRow> lessons = participationsIn(session.database);
  if (lessons.empty()) return;
  const std::vector<ParticipantRow> people = participantsIn(session.database);
  const HeadInRoom head = headOf(session);
  const std::vector<SessionGame> games = gamesIn(session.database);
  for (std::size_t i = 0; i < games.size(); ++i) {
    const auto lesson = std::find_if(lessons.begin(), lessons.end(), [&](const ParticipationRow& row) {
      return row.firstFrame == games[i].firstFrame;
    });
    if (lesson == lessons.end() || !games[i].hasFrames) continue;
    const auto person = std::find_if(people.begin(), people.end(),
                                     [&](const ParticipantRow& row) { return row.code == lesson->code; });
    if (person == people.end()) continue;
    const std::int64_t end = i + 1 < games.size() ? games[i + 1].firstFrame : INT64_MAX;
    addLessonAnswer(session, *person, *lesson, games[i], end, files.responses);
    addBehaviour(behaviourIn(session.database, lesson->firstFrame, end, head), *lesson,
                 ++files.attempts[{lesson->code, lesson->lesson}], files.behaviour);
    if (wanted.hasMotion && person->allows("paths"))
      exportMotion(session.database, *lesson, games[i], end, folder / "motion");
  }
}

std::string backgroundOf(const std::vector<ResponseRow>& responses, std::string_view item) {
  const auto found = std::find_if(responses.begin(), responses.end(), [&](const ResponseRow& row) {
    return row.phase == "background" && row.item == item;
  });
  return found == responses.end() ? "" : masked(found->answer);
}

void addPerson(OpenSession& session, const ParticipantRow& person, StudyFiles& files) {
  const std::vector<ResponseRow> responses = responsesOf(session.database, person.code);
  Values row = commonValues(session, person);
  row.insert({{"forms", person.forms},
              {"consent_version", person.consentVersion},
              {"started_utc", person.startedUtc},
              {"guardian", person.allows("guardian") ? "1" : "0"},
              {"excluded", excludedBy(person)}});
  for (const BackgroundQuestion& question : kBackground)
    row[question.id] = backgroundOf(responses, question.id);
  files.people.add(row);
  for (const std::size_t phase : {0U, 1U, 2U}) {
    const bool isBegun = std::any_of(responses.begin(), responses.end(), [&](const ResponseRow& response) {
      return response.phase == kTestPhases[phase];
    });
    if (phase < 2 || isBegun) addTest(session, person, phase, responses, files.responses);
  }
  addRatings(session, person, responses, files.responses);
}

void addStudyFacts(const std::vector<std::unique_ptr<OpenSession>>& sessions, StudyCsv& file) {
  const auto newest = std::max_element(sessions.begin(), sessions.end(), [](const auto& a, const auto& b) {
    return a->sha256Before.size() < b->sha256Before.size();
  });
  const Study& study = (*newest)->study;
  std::set<std::string> withdrawals;  // one stands in each file of its call
  int unnamed = 0;
  for (const auto& session : sessions) {
    withdrawals.insert(session->withdrawals.begin(), session->withdrawals.end());
    unnamed += std::max(0, session->withdrew - static_cast<int>(session->withdrawals.size()));
  }
  std::string until;
  if (study.keepUntil)
    until = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(study.keepUntil->year()),
                        static_cast<unsigned>(study.keepUntil->month()),
                        static_cast<unsigned>(study.keepUntil->day()));
  const std::vector<std::pair<const char*, std::string>> facts{
      {"title", study.title},
      {"sha256", study.sha256},
      {"sha256_before", (*newest)->sha256Before},
      {"primary", study.primary},
      {"bank", sessionValue((*newest)->database, "study_bank")},
      {"seed", std::to_string(study.seed)},
      {"planned", std::to_string(study.participants)},
      {"withdrew", std::to_string(unnamed + static_cast<int>(withdrawals.size()))},
      {"keep_until", until}};
  for (const auto& [key, value] : facts) file.add({{"key", key}, {"value", value}});
}

/// A folder that takes its place whole, or is removed.
class WholeFolder {
 public:
  explicit WholeFolder(const fs::path& folder) : folder_(folder), part_(folder.string() + ".part") {
    std::error_code failed;
    if (fs::exists(folder_, failed))
      throw std::runtime_error(fmt::format("{} is there already, expected a new name", folder_.string()));
    fs::remove_all(part_, failed);
    fs::create_directories(part_, failed);
    if (failed) throw std::runtime_error(fmt::format("{}: {}", part_.string(), failed.message()));
  }
  ~WholeFolder() {
    std::error_code ignored;
    fs::remove_all(part_, ignored);
  }
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  const fs::path& part() const { return part_; }
  void commit() { fs::rename(part_, folder_); }

 private:
  fs::path folder_, part_;
};

}  // namespace

void exportStudy(const StudyExport& wanted) {
  std::vector<std::unique_ptr<OpenSession>> sessions;
  std::set<std::string> codes;
  for (const fs::path& file : wanted.sessions) {
    sessions.push_back(openSession(file));
    checkSameStudy(*sessions.front(), *sessions.back());
    for (std::size_t i = 0; i + 1 < sessions.size(); ++i) checkAnother(*sessions[i], *sessions.back());
  }
  WholeFolder folder(wanted.folder);
  StudyFiles files;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const auto& session = sessions[i];
    log::note(fmt::format("{}: session {} of {}", wanted.sessions[i].string(), i + 1, sessions.size()));
    for (const ParticipantRow& person : participantsIn(session->database)) {
      // A participant who came again on another day stands in a file of its own with the delayed test alone.
      const bool isNew = codes.insert(person.code).second;
      if (isNew) {
        addPerson(*session, person, files);
      } else {
        addTest(*session, person, 2, responsesOf(session->database, person.code), files.responses);
      }
    }
    addLessons(*session, wanted, folder.part(), files);
  }
  addStudyFacts(sessions, files.study);
  WholeFile(folder.part() / "responses.csv").commit(files.responses.text());
  WholeFile(folder.part() / "participants.csv").commit(files.people.text());
  WholeFile(folder.part() / "behaviour.csv").commit(files.behaviour.text());
  WholeFile(folder.part() / "study.csv").commit(files.study.text());
  WholeFile(folder.part() / "codebook.csv").commit(codebookCsv());
  folder.commit();
}

}  // namespace carom
