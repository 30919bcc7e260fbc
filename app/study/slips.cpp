#include "app/study/slips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/study/study_code.h"
#include "app/toml/findings.h"
#include "app/toml/input_file.h"

namespace carom {

namespace {

/// Returns the content of the file. Throws InputErrors if it is none that can be read.
std::string textOfSlips(const std::filesystem::path& file) {
  std::string refusal = refusalOf(file, InputKind::trace);
  if (refusal.empty()) return readText(file, InputKind::trace);
  const std::string what(limitOf(InputKind::trace).what);
  if (const std::size_t at = refusal.rfind(what); at != std::string::npos)
    refusal.replace(at, what.size(), "the slips that carom study codes writes");
  throw InputErrors({InputError(file.string(), 1, 1, refusal)});
}

}  // namespace

std::map<std::string, std::size_t> readSlips(const std::filesystem::path& file, std::size_t participants) {
  std::map<std::string, std::size_t> slips;
  std::vector<InputError> faults;
  const std::string text = textOfSlips(file);
  int line = 0;
  for (std::size_t from = 0; from < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string row = text.substr(from, end - from);
    from = end + 1;
    if (row.ends_with('\r')) row.pop_back();
    const auto fault = [&](const std::string& words) {
      if (faults.size() < kMostFindings) faults.emplace_back(file.string(), line + 1, 1, words);
    };
    if (line == 0) {
      if (row != "number,code") fault("expected the line number,code of carom study codes");
      continue;
    }
    const std::size_t comma = row.find(',');
    const auto number = comma == std::string::npos ? std::nullopt : wholeNumber(row.substr(0, comma));
    const auto code = comma == std::string::npos ? std::nullopt : codeOf(row.substr(comma + 1));
    if (!number || *number < 1.0 || *number > static_cast<double>(participants) ||
        *number != std::floor(*number))
      fault(fmt::format("there is no such number of a participant, expected 1 to {}", participants));
    else if (!code)
      fault("this is no code, expected one that carom study codes has drawn");
    else if (!slips.emplace(*code, static_cast<std::size_t>(*number)).second)
      fault("this code stands here twice, expected it once");
  }
  if (slips.empty() && faults.empty())
    faults.emplace_back(file.string(), 1, 1, "there is no code here, expected those of carom study codes");
  if (!faults.empty()) throw InputErrors(std::move(faults));
  return slips;
}

}  // namespace carom
