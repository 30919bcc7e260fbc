#pragma once
// The tables of a study in a session file (app/journal/journal.h), written beside the journal by another
// connection:
//   participant(code, study, arm, order_row, forms, consent, consent_version, number, started_utc, step,
//               lesson, excluded)
//       One row a participant: the title of the study, the allocation, the boxes that were ticked
//       ("take-part paths publish"), the beginning of the SHA-256 of the consent page, the day, and how far
//       they have come. excluded: empty, or the rule by which they are left out.
//   response(code, phase, form, item, answer, confidence, seconds, changes, reason, t_s)
//       One row an item that was shown; phase is background, pre, post, delayed or rating. answer: its id,
//       dont-know or empty; confidence 1 to 4 or NULL; t_s on the session's clock, when it was last changed.
//   response_change(code, phase, item, answer, confidence, t_s)
//       Each answer that was set, in its order.
//   participation(code, lesson, position, first_frame)
//       The games of the session that are lessons of a participant: those that begin with these frames.
// The study itself stands in table session: study, study_items (texts), study_sha256, and if it was amended
// after the first participant study_sha256_before; study_bank: shipped or own. study_withdrew counts those
// whose data were deleted, study_withdrawals has a random identifier of each deletion, the same in all its
// files.

#include <SQLiteCpp/SQLiteCpp.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/study.h"
#include "app/study/study_lock.h"

namespace carom {

/// The tables whose rows belong to one participant each, by their column `code`.
inline constexpr std::array<const char*, 4> kStudyTables{"participant", "response", "response_change",
                                                         "participation"};

struct ParticipantRow {
  std::string code, arm;
  std::size_t number = 0, orderRow = 0;
  std::string forms;    ///< "BCA"
  std::string consent;  ///< ticked boxes, separated by blanks
  std::string consentVersion, startedUtc;
  int step = 0;            ///< as StudyStep (app/study/study_progress.h)
  std::size_t lesson = 0;  ///< how many of the lessons are over
  std::string excluded;    ///< empty or the rule

  bool allows(std::string_view box) const;
};

struct ResponseRow {
  std::string phase, form, item, answer;
  int confidence = 0;  ///< 1 to 4; 0: none
  double seconds = 0.0;
  int changes = 0;
  std::string reason;
  double t_s = 0.0;
};

struct ParticipationRow {
  std::string code, lesson;
  std::size_t position = 0;
  std::int64_t firstFrame = 0;
};

/// Returns whether the file has the tables of a study.
bool hasStudy(SQLite::Database& session);
std::vector<ParticipantRow> participantsIn(SQLite::Database& session);
std::vector<ResponseRow> responsesOf(SQLite::Database& session, const std::string& code);
std::vector<ParticipationRow> participationsIn(SQLite::Database& session);

/// Writes the rows of a study. Lets SQLite::Exception through: the disk may be full.
class StudyTables {
 public:
  /// Opens a session file that exists. Throws std::runtime_error if it has participants of another study, or
  /// of this one as it was before a change; with `isAmended` both hashes are kept.
  StudyTables(const std::filesystem::path& session, const Study& study, bool isAmended);

  ~StudyTables();  ///< makes the file complete without FILE-wal, unless the journal still writes
  StudyTables(const StudyTables&) = delete;
  StudyTables& operator=(const StudyTables&) = delete;

  void write(const ParticipantRow& row);
  /// Writes a response, in place of an earlier one of the same item, and if it has changed its answer too.
  void write(const std::string& code, const ResponseRow& row, bool isChanged);
  /// Removes the rows of a person who may not take part after all.
  void forget(const std::string& code);
  /// Records that the newest game of the session is a lesson of this participant.
  void beginLesson(const std::string& code, const std::string& lesson, std::size_t position);

  SQLite::Database& database() { return database_; }

 private:
  void set(const std::string& key, const std::string& value);
  StudyLock lock_;
  SQLite::Database database_;
  std::string title_;
};

}  // namespace carom
