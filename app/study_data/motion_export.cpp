#include "app/study_data/motion_export.h"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <string>
#include <utility>

#include "app/tables/json_text.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

constexpr std::array<const char*, 7> kParts{"x", "y", "z", "quat_w", "quat_x", "quat_y", "quat_z"};

/// Returns a name as BIDS has it: letters and digits alone.
std::string labelOf(const std::string& name) {
  std::string label;
  for (const char letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter))) label += letter;
  }
  return label.empty() ? "tracker" : label;
}

struct TrackedPoint {
  std::string rows;
  std::size_t count = 0;
  double first_s = 0.0, last_s = 0.0;
};

/// Returns the samples of each tracker and sensor while the game was played.
std::map<std::pair<std::string, int>, TrackedPoint> samplesOf(SQLite::Database& session,
                                                              const SessionGame& game) {
  std::map<std::pair<std::string, int>, TrackedPoint> points;
  SQLite::Statement row(session,
                        "SELECT tracker, sensor, time_s, x_m, y_m, z_m, qw, qx, qy, qz FROM sample WHERE "
                        "time_s >= ? AND time_s <= ? ORDER BY rowid");
  row.bind(1, game.from_s);
  row.bind(2, game.to_s);
  while (row.executeStep()) {
    TrackedPoint& point = points[{row.getColumn(0).getString(), row.getColumn(1).getInt()}];
    const double t_s = row.getColumn(2).getDouble() - game.from_s;
    point.rows += fmt::format("{:.17g}", t_s);
    for (int column = 3; column < 10; ++column)
      point.rows += row.isColumnNull(column) ? std::string("\tn/a")
                                             : fmt::format("\t{:.17g}", row.getColumn(column).getDouble());
    point.rows += '\n';
    if (point.count++ == 0) point.first_s = t_s;
    point.last_s = t_s;
  }
  return points;
}

std::string channelsText(const std::string& point) {
  std::string text = "name\tcomponent\ttype\ttracked_point\tunits\nt\tn/a\tLATENCY\tn/a\ts\n";
  for (const char* part : kParts) {
    const bool isPlace = std::string_view(part).size() == 1;
    text += fmt::format("{0}_{1}\t{1}\t{2}\t{0}\t{3}\n", point, part, isPlace ? "POS" : "ORNT",
                        isPlace ? "m" : "n/a");
  }
  return text;
}

std::string eventsText(SQLite::Database& session, const ParticipationRow& lesson, const SessionGame& game,
                       std::int64_t end) {
  std::string text = fmt::format("onset\tduration\ttrial_type\n0\t{:.17g}\t{}\n", game.to_s - game.from_s,
                                 labelOf(lesson.lesson));
  SQLite::Statement row(
      session,
      "SELECT f.display_s, f.lesson_phase FROM frame f WHERE f.number >= ? AND f.number < ? "
      "ORDER BY f.number");
  row.bind(1, lesson.firstFrame);
  row.bind(2, end);
  constexpr std::array<const char*, 4> kPhases{"none", "asks", "shows", "explains"};
  int phase = 0;
  while (row.executeStep()) {
    const int next = row.getColumn(1).getInt();
    if (next == phase || next < 0 || next > 3) continue;
    phase = next;
    text += fmt::format("{:.17g}\t0\t{}\n", row.getColumn(0).getDouble() - game.from_s,
                        kPhases.at(static_cast<std::size_t>(phase)));
  }
  return text;
}

}  // namespace

void exportMotion(SQLite::Database& session, const ParticipationRow& lesson, const SessionGame& game,
                  std::int64_t end, const std::filesystem::path& folder) {
  const std::filesystem::path place = folder / ("sub-" + lesson.code) / "motion";
  std::filesystem::create_directories(place);
  const std::string task = fmt::format("sub-{}_task-{}", lesson.code, labelOf(lesson.lesson));
  for (const auto& [named, point] : samplesOf(session, game)) {
    const std::string name = fmt::format("{}s{}", labelOf(named.first), named.second);
    const std::string start = (place / fmt::format("{}_tracksys-{}_", task, name)).string();
    const double span_s = point.last_s - point.first_s;
    const double rate = span_s > 0.0 ? static_cast<double>(point.count - 1) / span_s : 0.0;
    const Json facts{{"TaskName", lesson.lesson}, {"TrackingSystemName", name},
                     {"SamplingFrequency", rate}, {"MotionChannelCount", kParts.size() + 1},
                     {"TrackedPointsCount", 1},   {"SpatialAxes", "room"}};
    WholeFile(start + "motion.tsv").commit(point.rows);
    WholeFile(start + "motion.json").commit(jsonText(facts));
    WholeFile(start + "channels.tsv").commit(channelsText(name));
  }
  WholeFile(place / (task + "_events.tsv")).commit(eventsText(session, lesson, game, end));
}

}  // namespace carom
