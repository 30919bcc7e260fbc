#include "app/tables/json_text.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace carom {

namespace {

void write(const Json& value, int depth, std::string& out);

void writeMembers(const Json& value, int depth, std::string& out) {
  const bool ownLines = depth == 0 || (value.is_array() && !value.empty() && value.front().is_object());
  std::string gap(static_cast<std::size_t>(depth) + 2, ' ');
  gap.front() = '\n';
  std::string_view comma = "";
  for (auto member = value.begin(); member != value.end(); ++member) {
    out += comma;
    out += ownLines ? gap : comma.empty() ? "" : " ";
    if (value.is_object()) out += Json(member.key()).dump() + ": ";
    write(*member, depth + 1, out);
    comma = ",";
  }
}

void write(const Json& value, int depth, std::string& out) {
  if (value.is_structured()) {
    out += value.is_object() ? '{' : '[';
    writeMembers(value, depth, out);
    out += value.is_object() ? '}' : ']';
  } else if (value.is_number_float()) {
    const double number = value.get<double>();
    if (!std::isfinite(number)) throw std::logic_error("a number of the results is not finite");
    fmt::format_to(std::back_inserter(out), "{:.17g}", number);
  } else {
    out += value.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

}  // namespace

std::string jsonText(const Json& value) {
  std::string out;
  write(value, 0, out);
  out += '\n';
  return out;
}

}  // namespace carom
