// Each field of a frame's record is changed in turn: the rules, the digest and the session file all notice.
#include "cave/record/record_fields.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "app/journal/session_facts.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "cave/record/record_rules.h"
#include "places.h"

namespace carom {
namespace {

using namespace test;

/// Changes the field of one number, and keeps its name and kind. A value of several numbers counts as one
/// field.
class Changer : public FieldVisitor {
 public:
  /// `impossible`: to a value that the rules refuse.
  Changer(std::size_t field, bool impossible) : field_(field), impossible_(impossible) {}

  template <typename Value, typename Kind>
  void operator()(const char* name, Value& value, const Kind& kind) {
    if (count_++ != field_) return;
    name_ = std::string(prefix) + name;
    if constexpr (std::is_same_v<Kind, FieldKind>) stored_ = kind.stored;
    isChanged_ = change(value, kind);
  }

  std::size_t count() const { return count_; }
  const std::string& name() const { return name_; }
  Stored stored() const { return stored_; }
  bool isChanged() const { return isChanged_; }  ///< false: there is no such value

 private:
  bool change(double& value, const FieldKind& kind) const {
    if (impossible_) {
      value = std::nan("");
    } else if (std::isinf(value)) {
      value = 2.0;
    } else {
      value = value + 0.125 <= kind.most ? value + 0.125 : value - 0.125;
    }
    return true;
  }
  template <typename Whole>
  requires(std::is_unsigned_v<Whole> || std::is_enum_v<Whole>) bool change(Whole& value,
                                                                           const FieldKind& kind) const {
    const auto now = static_cast<std::uint64_t>(value);
    if (impossible_ && kind.most == kCount.most) return false;
    const std::uint64_t most = kind.most == kCount.most ? now + 1 : static_cast<std::uint64_t>(kind.most);
    value = static_cast<Whole>(impossible_ ? most + 1 : now < most ? now + 1 : now - 1);
    return true;
  }
  template <Compound Value>
  bool change(Value& value, const FieldKind& kind) const {
    eachNumber(value, kind, [&](const char*, double& number) { change(number, kind); });
    return true;
  }
  bool change(Lorentz& transform, const FieldKind&) const {
    transform = impossible_ ? Lorentz::rotation({1.0, 1.0, 0.0, 0.0}, transform.lightSpeed_m_s())
                            : Lorentz::boost({0.1, 0.2, 0.3}, transform.lightSpeed_m_s());
    return true;
  }
  template <std::size_t bytes>
  bool change(ShortText<bytes>& text, const FieldKind&) const {
    text = ShortText<bytes>("changed");
    if (impossible_) text.text.fill('x');
    return true;
  }
  template <typename Flags, typename Row, std::size_t rows>
  bool change(Flags& flags, const std::array<Row, rows>& named) const {
    std::uint8_t& flag = flags.*named[0].value;
    flag = impossible_ ? 2 : 1 - flag;
    return true;
  }

  std::size_t field_;
  bool impossible_;
  std::size_t count_ = 0;
  std::string name_;
  Stored stored_ = Stored::asColumn;
  bool isChanged_ = false;
};

/// A frame of two viewers with force devices, and a headset.
FrameState frameForTwo() {
  FrameState state = frameOf(1);
  state.record.viewerCount = 2;
  state.record.viewers[0].force.shown = 1;
  state.record.viewers.fill(ViewerState(state.record.viewers[0]));
  state.record.viewers[1].hasTurn = 1;
  state.record.headset.isWorn = 1;
  state.knots.clear();
  state.events.clear();
  return state;
}

SessionFacts factsForTwo() {
  SessionFacts facts = kFacts;
  facts.viewers = {"anna", "ben", "cleo"};  // one more, where the number of viewers is changed
  facts.languages.all = {"en", "fr"};
  return facts;
}

/// Returns the frame as the session file gives it back.
FrameState throughFile(const FrameState& state) {
  const TemporaryFolder folder;
  const std::array<HeadEstimate, 3> heads{head()[0], head()[0], head()[0]};
  {
    Journal journal(folder / "game.db", factsForTwo(), false);
    journal.add(state, heads, {});
  }
  SessionFile session(folder / "game.db");
  FrameState read;
  EXPECT_TRUE(session.next(read));
  return read;
}

FrameDigest digestOf(const FrameRecord& record) {
  return digestOf(FrameState{record, {}, {}, {}, {}}, World{});
}

std::size_t countFields() {
  FrameState state = frameForTwo();
  Changer counter(static_cast<std::size_t>(-1), false);
  visitAll(state.record, counter);
  return counter.count();
}

TEST(RecordFields, TheRulesRefuseEachImpossibleField) {
  const std::size_t fields = countFields();
  std::set<std::string> refused;
  for (std::size_t field = 0; field < fields; ++field) {
    FrameState state = frameForTwo();
    EXPECT_NO_THROW(expectPossible(state.record, kFacts.lightSpeed_m_s));
    Changer changer(field, true);
    visitAll(state.record, changer);
    if (!changer.isChanged()) continue;
    if (changer.name() == "viewers") state.record.viewerCount = kMostViewers + 1;
    try {
      expectPossible(state.record, kFacts.lightSpeed_m_s);
      ADD_FAILURE() << changer.name() << " was accepted";
    } catch (const std::invalid_argument&) {
      refused.insert(changer.name());
    }
  }
  EXPECT_GT(refused.size(), 60U);
}

TEST(RecordFields, TheDigestNoticesEachField) {
  const std::size_t fields = countFields();
  const FrameDigest before = digestOf(frameForTwo().record);
  for (std::size_t field = 0; field < fields; ++field) {
    FrameState state = frameForTwo();
    Changer changer(field, false);
    visitAll(state.record, changer);
    EXPECT_NE(digestOf(state.record), before) << changer.name() << ", field " << field;
  }
}

TEST(RecordFields, TheSessionFileKeepsEachField) {
  const std::size_t fields = countFields();
  const FrameDigest before = digestOf(throughFile(frameForTwo()).record);
  for (std::size_t field = 0; field < fields; ++field) {
    FrameState state = frameForTwo();
    Changer changer(field, false);
    visitAll(state.record, changer);
    if (changer.stored() == Stored::notAtAll) continue;
    state.record.forgetBefore_s = FrameRecord().forgetBefore_s;  // which is not stored
    if (changer.name() == "has_turn") {                          // which one viewer has, and no other
      ViewerState &anna = state.record.viewers[0], &ben = state.record.viewers[1];
      (anna.hasTurn ? ben : anna).hasTurn = anna.hasTurn ? 0 : 1;
    }
    const FrameState read = throughFile(state);
    if (changer.name() == "is_worn") {
      EXPECT_EQ(read.record.headset.isWorn, 0);
      continue;
    }
    EXPECT_EQ(digestOf(read.record), digestOf(state.record)) << changer.name() << ", field " << field;
    EXPECT_NE(digestOf(read.record), before) << changer.name() << ", field " << field;
  }
}

// People's queries name these columns: a change of them is another version of the tables.
TEST(RecordFields, TheTablesHaveTheColumnsOfTheirVersion) {
  const TemporaryFolder folder;
  { Journal journal(folder / "game.db", factsForTwo(), false); }
  SQLite::Database database((folder / "game.db").string());
  std::ifstream lines(std::filesystem::path(CAROM_TESTS_DIR) / "app/data/session-columns.txt");
  std::string version;
  std::getline(lines, version);
  EXPECT_EQ(version, fmt::format("version: {}", kJournalVersion)) << "new columns are a new version";
  int tables = 0;
  for (std::string expected; std::getline(lines, expected); ++tables) {
    const std::string table = expected.substr(0, expected.find(':'));
    std::string found = table + ":";
    for (const std::string& name : column(database, "SELECT name FROM pragma_table_info('" + table + "')"))
      found += " " + name;
    EXPECT_EQ(found, expected);
  }
  EXPECT_EQ(tables, 6);
}

}  // namespace
}  // namespace carom
