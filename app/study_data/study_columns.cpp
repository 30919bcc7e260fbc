#include "app/study_data/study_columns.h"

#include <array>
#include <regex>
#include <stdexcept>

#include "app/tables/csv_table.h"

namespace carom {
namespace {

constexpr std::string_view kResponses = "responses.csv", kPeople = "participants.csv",
                           kBehaviour = "behaviour.csv", kStudy = "study.csv";
constexpr std::string_view kText = "text", kWhole = "integer", kNumber = "number", kNone = "";

constexpr auto kColumns = std::to_array<StudyColumn>({
    {kResponses, "study", kText, kNone, "title of the study", "any"},
    {kResponses, "participant", kText, kNone, "code of the participant", "six letters"},
    {kResponses, "arm", kText, kNone, "arm of the participant", "an arm of the study"},
    {kResponses, "order_row", kWhole, kNone, "row of the Williams square", "0 and more"},
    {kResponses, "phase", kText, kNone, "when it was asked", "pre|post|delayed|lesson|rating"},
    {kResponses, "form", kText, kNone, "form of the test; empty for lessons and ratings", "A|B|C|"},
    {kResponses, "item", kText, kNone, "id of the item, name of the lesson, or the rating", "any"},
    {kResponses, "concept", kText, kNone, "concept of the item; empty for lessons and ratings", "any"},
    {kResponses, "position", kWhole, kNone, "place in the form, or of the lesson, from 1", "1 and more"},
    {kResponses, "answer", kText, kNone,
     "id of the answer; for lessons its number from 1; for ratings 0 to 10; empty: none",
     "an id|dont-know|a number|"},
    {kResponses, "correct", kWhole, kNone, "whether the answer is the right one; empty: none", "0|1|"},
    {kResponses, "misconception", kText, kNone, "misconception of the answer", "any or empty"},
    {kResponses, "confidence", kWhole, kNone, "1 guess, 2 unsure, 3 fairly sure, 4 certain", "1|2|3|4|"},
    {kResponses, "seconds", kNumber, "s", "how long the item was in sight", "0 and more, or empty"},
    {kResponses, "changes", kWhole, kNone, "how often the answer was changed", "0 and more, or empty"},
    {kResponses, "reason", kText, kNone, "why, in the participant's words; addresses and numbers are masked",
     "any or empty"},
    {kPeople, "study", kText, kNone, "title of the study", "any"},
    {kPeople, "participant", kText, kNone, "code of the participant", "six letters"},
    {kPeople, "arm", kText, kNone, "arm of the participant", "an arm of the study"},
    {kPeople, "order_row", kWhole, kNone, "row of the Williams square", "0 and more"},
    {kPeople, "forms", kText, kNone, "forms before, after and delayed", "ABC|BCA|CAB|BAC|CBA|ACB"},
    {kPeople, "consent_version", kText, kNone, "beginning of the SHA-256 of the consent page", "any"},
    {kPeople, "started_utc", kText, kNone, "day on which the participant began", "YYYY-MM-DD"},
    {kPeople, "age_band", kText, kNone, "age", "under-18|18-24|25-34|35-49|50-64|65-|"},
    {kPeople, "physics_years", kText, kNone, "years of physics courses", "0|1-2|3-4|5-|"},
    {kPeople, "relativity", kText, kNone, "relativity before", "none|read|course|"},
    {kPeople, "games_hours", kText, kNone, "hours of 3D games a week", "0|1-3|4-9|10-|"},
    {kPeople, "language", kText, kNone, "language that is spoken best", "any or empty"},
    {kPeople, "gender", kText, kNone, "gender, if the study asks for it", "any or empty"},
    {kPeople, "guardian", kWhole, kNone, "whether the consent of a guardian is there on paper", "0|1"},
    {kPeople, "excluded", kText, kNone,
     "rule by which the participant is left out: stopped by their own wish, or unfinished, with something "
     "still "
     "to come; empty: none",
     "stopped|unfinished|"},
    {kBehaviour, "participant", kText, kNone, "code of the participant", "six letters"},
    {kBehaviour, "lesson", kText, kNone, "name of the lesson", "a lesson of the study"},
    {kBehaviour, "position", kWhole, kNone, "which of the participant's lessons, from 1", "1 and more"},
    {kBehaviour, "attempt", kWhole, kNone, "how often the participant had begun this lesson, with this time",
     "1 and more"},
    {kBehaviour, "ask_s", kNumber, "s", "time while the lesson asked", "0 and more"},
    {kBehaviour, "show_s", kNumber, "s", "time while it showed", "0 and more"},
    {kBehaviour, "explain_s", kNumber, "s", "time while it explained", "0 and more"},
    {kBehaviour, "explained", kWhole, kNone, "whether the lesson explained itself", "0|1"},
    {kBehaviour, "repeats", kWhole, kNone, "how often it was shown again", "0 and more"},
    {kBehaviour, "velocities", kText, kNone, "numbers of the velocities chosen, from 1, in their order",
     "numbers, separated by blanks"},
    {kBehaviour, "views_switched", kWhole, kNone, "how often a view of time was switched", "0 and more"},
    {kBehaviour, "strokes", kWhole, kNone, "strokes by hand", "0 and more"},
    {kBehaviour, "path_m", kNumber, "m",
     "path of the head in the room: 60 Hz positions, low-passed at 2 Hz (second order, forwards and "
     "backwards)",
     "0 and more"},
    {kBehaviour, "beta_mean", kNumber, "c", "mean speed of the head, in units of the light's", "0 to 1"},
    {kBehaviour, "beta_most", kNumber, "c", "largest speed of the head", "0 to 1"},
    {kBehaviour, "towards_table", kNumber, kNone,
     "share of the time in which the head pointed within 15 degrees of the table's middle; a head, not a "
     "gaze",
     "0 to 1"},
    {kBehaviour, "towards_panel", kNumber, kNone,
     "the same of the middle of the front wall, or of the panel that carries the words", "0 to 1, or empty"},
    {kBehaviour, "blank_s", kNumber, "s", "time in which the walls were dark", "0 and more"},
    {kBehaviour, "lost_s", kNumber, "s", "time in which the head was lost", "0 and more"},
    {kStudy, "key", kText, kNone, "name of a fact of the study",
     "title|sha256|sha256_before|primary|bank|seed|planned|withdrew|keep_until"},
    {kStudy, "value", kText, kNone, "its value", "any or empty"},
});

}  // namespace

std::span<const StudyColumn> studyColumns() { return kColumns; }

std::string codebookCsv() {
  static const std::vector<CsvColumn<StudyColumn>> columns{
      {"file", [](const StudyColumn& column) { return column.file; }},
      {"name", [](const StudyColumn& column) { return column.name; }},
      {"type", [](const StudyColumn& column) { return column.type; }},
      {"unit", [](const StudyColumn& column) { return column.unit; }},
      {"meaning", [](const StudyColumn& column) { return column.meaning; }},
      {"allowed", [](const StudyColumn& column) { return column.allowed; }}};
  return csvText(columns, {kColumns.begin(), kColumns.end()});
}

StudyCsv::StudyCsv(std::string_view file) {
  for (const StudyColumn& column : kColumns) {
    if (column.file != file) continue;
    text_ += (columns_.empty() ? "" : ",") + std::string(column.name);
    columns_.push_back(column.name);
  }
  text_ += '\n';
}

void StudyCsv::add(const std::map<std::string_view, std::string>& values) {
  if (values.size() != columns_.size()) throw std::logic_error("a row of an export has other columns");
  for (std::size_t i = 0; i < columns_.size(); ++i)
    text_ += (i == 0 ? "" : ",") + csvField(values.at(columns_[i]));
  text_ += '\n';
}

std::string masked(const std::string& text) {
  static const std::regex mail(R"([^\s@]+@[^\s@]+)"), number(R"(\+?\d(?:[ ./()-]*\d){5,})");
  return std::regex_replace(std::regex_replace(text, mail, "[masked]"), number, "[masked]");
}

}  // namespace carom
