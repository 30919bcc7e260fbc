#include "devices/force/recorded_hand.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "engine/text/input_error.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr std::string_view kHeader = "time_s,x_m,y_m,z_m,pressed";
constexpr std::array<const char*, 5> kNames{"time_s", "x_m", "y_m", "z_m", "pressed"};
constexpr double kFarthest_m = 1e3, kLatest_s = 1e9;
constexpr std::size_t kMostRows = 4'000'000;

/// Takes the text up to the next `end` off the front of `text`.
std::string_view takeUntil(char end, std::string_view& text) {
  const std::size_t at = std::min(text.find(end), text.size());
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return taken;
}

/// One line of the file, for messages.
struct Line {
  const std::string& name;
  int number;

  [[noreturn]] void fail(const std::string& message) const { throw InputError(name, number, 1, message); }
};

double numberIn(std::string_view field, std::size_t column, const Line& line) {
  while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
  while (!field.empty() && (field.back() == ' ' || field.back() == '\r')) field.remove_suffix(1);
  double value = 0.0;
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  const double most = column == 0 ? kLatest_s : kFarthest_m;
  if (error != std::errc() || stop != end || !(std::abs(value) <= most)) {
    std::string shown;
    for (const char c : field.substr(0, 40)) shown += c >= ' ' && c < 127 ? c : '?';
    line.fail(std::string(kNames[column]) + " is '" + shown + "', expected a number from " +
              std::to_string(static_cast<long long>(-most)) + " to " +
              std::to_string(static_cast<long long>(most)));
  }
  return value;
}

HandRow rowIn(std::string_view text, const Line& line) {
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  if (commas + 1 != kNames.size())
    line.fail("the row has " + std::to_string(commas + 1) + " columns, expected " +
              std::to_string(kNames.size()));
  std::array<double, 5> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = numberIn(takeUntil(',', text), i, line);
  if (values[4] != 0.0 && values[4] != 1.0) line.fail("pressed is neither 0 nor 1");
  return {values[0], {values[1], values[2], values[3]}, values[4] == 1.0};
}

}  // namespace

std::vector<HandRow> readHandRows(std::string_view text, const std::string& name) {
  std::vector<HandRow> rows;
  bool hasHeader = false;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // byte order mark
  for (Line line{name, 1}; !text.empty(); ++line.number) {
    std::string_view content = takeUntil('\n', text);
    if (!content.empty() && content.back() == '\r') content.remove_suffix(1);
    if (!hasHeader && content.starts_with('#')) continue;
    if (!hasHeader && content != kHeader)
      line.fail("this is no header, expected '" + std::string(kHeader) + "'");
    if (!std::exchange(hasHeader, true) || (content.empty() && text.empty())) continue;
    rows.push_back(rowIn(content, line));
    if (rows.size() > kMostRows) line.fail("there are more rows than " + std::to_string(kMostRows));
    if (rows.size() > 1 && !(rows.back().time_s > rows[rows.size() - 2].time_s))
      line.fail("time_s does not increase, expected a later time than in the row before");
  }
  if (rows.empty())
    Line{name, 1}.fail("there are no rows, expected a header '" + std::string(kHeader) + "' and rows");
  return rows;
}

std::vector<HandRow> readHandRows(const std::filesystem::path& file) {
  return readHandRows(contentOf(file, InputKind::trace), file.string());
}

HandRow handAt(const std::vector<HandRow>& rows, double time_s) {
  const auto next = std::upper_bound(rows.begin(), rows.end(), time_s,
                                     [](double at_s, const HandRow& row) { return at_s < row.time_s; });
  if (next == rows.begin()) return rows.front();
  const HandRow& before = *(next - 1);
  if (next == rows.end()) return before;
  const double share = (time_s - before.time_s) / (next->time_s - before.time_s);
  return {time_s, before.place_m + share * (next->place_m - before.place_m), before.pressed};
}

}  // namespace carom
