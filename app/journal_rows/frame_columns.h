#pragma once
// The columns of a frame's record, its knots and its events in a session file: the fields listed in
// cave/record/record_fields.h. Writing and reading visit the same lists; `row(name, value)` is called for
// each column.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "cave/record/record_fields.h"

namespace carom {

/// A column's name, in parts.
struct ColumnName {
  ColumnName(const char* whole) : name(whole) {}  // NOLINT(google-explicit-constructor)
  ColumnName(std::string_view before, const char* middle, const char* end)
      : prefix(before), name(middle), suffix(end) {}

  std::string_view prefix, name, suffix;

  std::string text() const { return fmt::format("{}{}{}", prefix, name, suffix); }
};

/// Gives a row the columns of the fields that it visits.
template <typename Row>
class Columns : public FieldVisitor {
 public:
  /// `ofFrame`: in the table `frame`, which has the first viewer's fields among those of the frame.
  explicit Columns(Row& row, bool ofFrame = false) : row_(row), ofFrame_(ofFrame) {}

  template <typename Value>
  void operator()(const char* name, Value& value, const FieldKind& kind) {
    const bool isColumn = kind.stored == Stored::asColumn || (kind.stored == Stored::ofOthers && !ofFrame_);
    if (!isColumn) return;
    if constexpr (Compound<Value>) {
      // The event between the first viewer's eyes has no prefix.
      const bool isPlain = ofFrame_ && prefix == "middle_" && *name == 0;
      eachNumber(value, kind, [&](const char* suffix, auto& number) {
        row_(ColumnName(isPlain ? "" : prefix, name, suffix), number);
      });
    } else {
      put(ColumnName(prefix, name, ""), value);
    }
  }
  /// Flags are one number with a bit for each, in the order of their rows.
  template <typename Flags, typename NamedFlag, std::size_t count>
  void operator()(const char* name, Flags& flags, const std::array<NamedFlag, count>& named) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (flags.*named[i].value) bits |= std::uint64_t{1} << i;
    }
    row_(name, bits);
    if constexpr (!std::is_const_v<Flags>) {
      constexpr std::uint64_t kMost = (std::uint64_t{1} << count) - 1;
      if (bits > kMost)
        throw std::runtime_error(fmt::format("{} is {}, expected 0 to {}", name, bits, kMost));
      for (std::size_t i = 0; i < count; ++i) flags.*named[i].value = bits >> i & 1U;
    }
  }
  template <PartOf<Turns> AnEventsTurns>
  void turns(AnEventsTurns& turns) {
    std::array<Turn, 2> both;
    auto count = static_cast<std::uint8_t>(turns.size());
    std::copy(turns.begin(), turns.end(), both.begin());
    row_("turns", count);
    visitWith("first_", both[0], *this);
    visitWith("second_", both[1], *this);
    for (std::size_t i = 0; i < both.size(); ++i) {
      prefix = i == 0 ? "first_" : "second_";
      visitSpin(both[i], *this);
    }
    prefix = {};
    if constexpr (!std::is_const_v<AnEventsTurns>) {
      if (count > both.size()) throw std::runtime_error("no such event can be");
      for (std::uint8_t turn = 0; turn < count; ++turn) turns.push_back(both[turn]);
    }
  }

 private:
  template <typename Value>
  void put(const ColumnName& name, Value& value) {
    row_(name, value);
  }
  /// Stores a flag as 0 or 1.
  template <PartOf<bool> Flag>
  void put(const ColumnName& name, Flag& flag) {
    std::uint8_t stored = flag ? 1 : 0;
    row_(name, stored);
    if (stored > 1) throw std::runtime_error("no such event can be");
    if constexpr (!std::is_const_v<Flag>) flag = stored == 1;
  }
  /// Stores a choice plus 1; 0 is none.
  template <typename Choice>
  requires requires(const Choice& choice) { choice.has_value(); }
  void put(const ColumnName& name, Choice& choice) {
    std::uint8_t stored = choice ? static_cast<std::uint8_t>(1 + static_cast<int>(*choice)) : 0;
    row_(name, stored);
    if constexpr (!std::is_const_v<Choice>) {
      if (stored > 0) choice = static_cast<typename Choice::value_type>(stored - 1);
    }
  }

  Row& row_;
  bool ofFrame_;
};

/// Gives a row the columns of a viewer after the first, of a headset, a knot or an event.
template <typename Row, typename Part>
void putColumns(Row& row, Part& part) {
  Columns<Row> columns(row);
  visit(part, columns);
}

/// Gives a row the columns of the table `frame`.
template <typename Row, PartOf<FrameRecord> Record>
void putFrame(Row& row, Record& record) {
  Columns<Row> columns(row, true);
  visit(record, columns);
  visit(record.viewers.front(), columns);
}

}  // namespace carom
