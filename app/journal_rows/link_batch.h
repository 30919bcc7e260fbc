#pragma once
// Another room of a linked game as rows of a session file (app/journal/journal.h).

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "app/journal_rows/journal_news.h"

namespace carom {

/// Rows still to be written, each with the number of its frame.
struct LinkBatch {
  template <typename Row>
  using Rows = std::vector<std::pair<std::uint64_t, Row>>;

  Rows<LinkRow> rows;
  Rows<LinkPersonRow> persons;
  Rows<LinkNoteRow> notes;

  void add(std::uint64_t frame, const LinkNews& news);
  bool empty() const { return rows.empty() && persons.empty() && notes.empty(); }
  void clear();
};

class LinkWriter {
 public:
  /// Creates the tables if they are not there.
  explicit LinkWriter(SQLite::Database& database);

  void write(const LinkBatch& batch);

 private:
  SQLite::Statement row_, person_, note_;
};

/// Reads the moments of people of another room. The file of a session without a link has none.
class ToldReader {
 public:
  explicit ToldReader(SQLite::Database& database);

  static bool hasTable(const SQLite::Database& database);

  /// Reads the moments that were told in a frame. Throws std::exception that gives the fault but not the
  /// frame.
  void read(std::uint64_t frame, std::vector<ToldMoment>& told);

 private:
  std::optional<SQLite::Statement> row_;  ///< empty without a link
};

}  // namespace carom
