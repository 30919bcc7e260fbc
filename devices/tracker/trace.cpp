#include "devices/tracker/trace.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "engine/text/input_error.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr std::string_view kPositionHeader = "time_s,x_m,y_m,z_m";
constexpr std::string_view kPoseHeader = "time_s,x_m,y_m,z_m,qx,qy,qz,qw";

// Bounds against files that are no traces.
constexpr std::size_t kLongestLine = 1024;    // bytes; a row needs about 200
constexpr std::size_t kMostRows = 4'000'000;  // eighteen hours at 60 Hz
constexpr double kFarthest_m = 1e6;
constexpr double kLatest_s = 1e11;  // three thousand years; calendar seconds are fine

// Reads a stream line by line and knows where it is.
class Lines {
 public:
  Lines(std::istream& in, const std::string& name) : in_(in), name_(name) {}

  /// The next line without its end (LF or CR LF); false after the last.
  bool next(std::string_view& line) {
    in_.getline(buffer_.data(), buffer_.size());
    const auto count = static_cast<std::size_t>(in_.gcount());
    ++number_;
    if (in_.bad()) fail(1, "the file cannot be read");
    if (in_.fail() && count + 1 == buffer_.size()) {
      fail(1,
           "the line is longer than " + std::to_string(kLongestLine) + " bytes, expected a row of numbers");
    }
    if (in_.fail()) return false;
    line = {buffer_.data(), in_.eof() ? count : count - 1};
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return true;
  }

  [[noreturn]] void fail(std::size_t column, std::string message) const {
    throw InputError(name_, number_, static_cast<int>(column), std::move(message));
  }

 private:
  std::istream& in_;
  const std::string& name_;
  int number_ = 0;
  std::array<char, kLongestLine + 1> buffer_{};
};

std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, kShown)) result += c >= ' ' && c < 127 ? c : '?';
  return result + (text.size() > kShown ? "…\"" : "\"");
}

struct Field {
  std::string_view text;
  std::size_t column;  // from 1
};

// Splits a row at commas, blanks around the fields taken off. Returns how many fields there are, which
// may be more than fit.
std::size_t split(std::string_view line, std::array<Field, 8>& fields) {
  std::size_t count = 0, begin = 0;
  while (true) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::size_t first = begin, last = end;
    while (first < last && (line[first] == ' ' || line[first] == '\t')) ++first;
    while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t')) --last;
    if (count < fields.size()) fields[count] = {line.substr(first, last - first), first + 1};
    ++count;
    if (end == line.size()) return count;
    begin = end + 1;
  }
}

double number(const Field& field, const Lines& lines, const char* what, double bound) {
  double value = 0.0;
  const char* const end = field.text.data() + field.text.size();
  const auto [stop, error] = std::from_chars(field.text.data(), end, value);
  if (error == std::errc::result_out_of_range) {
    lines.fail(field.column, std::string(what) + " " + quoted(field.text) + " is out of range");
  }
  if (error != std::errc() || stop != end) {
    lines.fail(field.column, std::string(what) + " is " + quoted(field.text) + ", expected a number");
  }
  if (!std::isfinite(value)) {
    lines.fail(field.column, std::string(what) + " is " + quoted(field.text) + ", expected a finite number");
  }
  if (std::abs(value) > bound) {
    lines.fail(field.column, std::string(what) + " is " + quoted(field.text) + ", expected at most " +
                                 std::to_string(static_cast<long long>(bound)));
  }
  return value;
}

// Skips comments; returns how many columns the header names.
std::size_t readHeader(Lines& lines) {
  std::string_view line;
  bool first = true;
  while (lines.next(line)) {
    if (first && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);  // byte order mark
    first = false;
    if (line.starts_with('#')) continue;
    if (line == kPositionHeader) return 4;
    if (line == kPoseHeader) return 8;
    lines.fail(1, "the header is " + quoted(line) + ", expected \"" + std::string(kPositionHeader) +
                      "\" or \"" + std::string(kPoseHeader) + "\"");
  }
  lines.fail(1, "the file ends without a header, expected \"" + std::string(kPositionHeader) + "\" or \"" +
                    std::string(kPoseHeader) + "\"");
}

TrackerSample readRow(std::string_view line, std::size_t columns, const Lines& lines) {
  std::array<Field, 8> fields;
  const std::size_t count = split(line, fields);
  if (count != columns) {
    const std::size_t column =
        count > columns && columns < fields.size() ? fields[columns].column : line.size() + 1;
    lines.fail(column,
               "the row has " + std::to_string(count) + " columns, expected " + std::to_string(columns));
  }
  TrackerSample sample;
  sample.time_s = number(fields[0], lines, "time_s", kLatest_s);
  sample.pose.position_m = {number(fields[1], lines, "x_m", kFarthest_m),
                            number(fields[2], lines, "y_m", kFarthest_m),
                            number(fields[3], lines, "z_m", kFarthest_m)};
  if (columns == 4) return sample;
  const glm::dquat q(number(fields[7], lines, "qw", 2.0), number(fields[4], lines, "qx", 2.0),
                     number(fields[5], lines, "qy", 2.0), number(fields[6], lines, "qz", 2.0));
  const double norm = glm::length(q);
  if (!(norm > 0.9 && norm < 1.1)) {
    lines.fail(fields[4].column,
               "the quaternion has length " + std::to_string(norm) + ", expected a rotation, of length 1");
  }
  sample.pose.orientation = q / norm;
  sample.hasOrientation = true;
  return sample;
}

}  // namespace

std::vector<TrackerSample> readTrace(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (const std::string refusal = refusalOf(file, InputKind::trace); !refusal.empty())
    throw InputError(name, 1, 1, refusal);
  std::ifstream in(file, std::ios::binary);
  return readTrace(in, name);
}

std::vector<TrackerSample> readTrace(std::istream& in, const std::string& name) {
  Lines lines(in, name);
  const std::size_t columns = readHeader(lines);
  std::vector<TrackerSample> samples;
  std::string_view line;
  while (lines.next(line)) {
    if (samples.size() == kMostRows) lines.fail(1, "more than " + std::to_string(kMostRows) + " rows");
    const TrackerSample sample = readRow(line, columns, lines);
    if (!samples.empty() && !(sample.time_s > samples.back().time_s)) {
      std::array<Field, 8> fields;
      split(line, fields);
      lines.fail(fields[0].column, "time_s " + quoted(fields[0].text) +
                                       " is not after that of the row before, expected increasing times");
    }
    samples.push_back(sample);
  }
  if (samples.empty()) lines.fail(1, "the trace has no rows, expected at least one");
  return samples;
}

TraceWriter::TraceWriter(std::filesystem::path file, bool hasOrientation, const std::string& comments)
    : file_(std::move(file)), part_(file_), hasOrientation_(hasOrientation) {
  part_ += ".part";
  out_.open(part_, std::ios::binary | std::ios::trunc);
  if (!out_) throw std::runtime_error(part_.string() + ": cannot be opened for writing");
  for (std::size_t begin = 0; begin < comments.size();) {
    const std::size_t end = std::min(comments.find('\n', begin), comments.size());
    out_ << "# " << std::string_view(comments).substr(begin, end - begin) << '\n';
    begin = end + 1;
  }
  out_ << (hasOrientation_ ? kPoseHeader : kPositionHeader) << '\n';
}

TraceWriter::~TraceWriter() {
  if (!out_.is_open()) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void TraceWriter::add(const TrackerSample& sample) {
  const glm::dvec3& p = sample.pose.position_m;
  const glm::dquat& q = sample.pose.orientation;
  const std::array<double, 8> values = {sample.time_s, p.x, p.y, p.z, q.x, q.y, q.z, q.w};
  const std::size_t columns = hasOrientation_ ? 8 : 4;
  std::array<char, 32> text;
  for (std::size_t i = 0; i < columns; ++i) {
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), values[i]);
    out_.write(text.data(), end - text.data());
    out_.put(i + 1 < columns ? ',' : '\n');
  }
}

void TraceWriter::commit() {
  out_.close();
  if (!out_) {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    throw std::runtime_error(part_.string() + ": cannot be written");
  }
  std::filesystem::rename(part_, file_);
}

}  // namespace carom
