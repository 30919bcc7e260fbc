#include "app/languages/po_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "app/toml/findings.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

constexpr std::size_t kMostForms = 6;  // Arabic has as many; no language has more

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isBlank(char c) { return c == ' ' || c == '\t'; }

std::string_view withoutBlanks(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

/// Returns the first thing in a file that no text file of ours has: a byte that is no UTF-8, or a control
/// sign.
std::optional<InputError> faultOfBytes(const std::string& path, std::string_view content) {
  const LineIndex lines(content);
  std::string_view rest = content;
  while (!rest.empty()) {
    const std::size_t offset = content.size() - rest.size();
    const auto byte = static_cast<unsigned char>(rest.front());
    const std::optional<char32_t> sign = takeCodePoint(rest);
    const bool isControl = sign && ((*sign < 0x20 && *sign != '\n' && *sign != '\r' && *sign != '\t') ||
                                    (*sign >= 0x7F && *sign < 0xA0));
    if (sign && !isControl) continue;
    const FilePlace at = lines.at(offset);
    std::string words =
        isControl
            ? fmt::format("the control sign U+{:04X}, expected text", static_cast<unsigned>(*sign))
            : fmt::format("the byte 0x{:02X} is not UTF-8, expected a file in UTF-8 (is it Latin-1?)", byte);
    return InputError(path, at.line, at.column, std::move(words));
  }
  return {};
}

/// Reads the lines of a file one by one.
class PoParser {
 public:
  PoParser(const std::filesystem::path& path, std::string_view content) : rest_(content) {
    file_.path = path;
  }

  PoFile parse() {
    while (!rest_.empty()) {
      ++file_.end.line;
      const std::size_t end = rest_.find('\n');
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      whole_ = line;
      takeLine(line);
    }
    finish();
    if (!faults_.empty()) throw InputErrors(std::move(faults_));
    return std::move(file_);
  }

 private:
  /// What the next string in quotation marks belongs to.
  enum class Part { none, context, id, plural, form };

  FilePlace placeOf(std::string_view here) const {
    return {file_.end.line, static_cast<int>(here.data() - whole_.data()) + 1};
  }

  /// Keeps a fault, unless its entry has one already.
  void fault(FilePlace at, const std::string& words) {
    if (isSpoilt_ || faults_.size() >= kMostFindings) return;
    isSpoilt_ = true;
    faults_.emplace_back(file_.path.string(), at.line, at.column, words);
  }
  void fault(std::string_view here, const std::string& words) { fault(placeOf(here), words); }

  void takeLine(std::string_view line) {
    if (withoutBlanks(line).empty()) return finish();
    if (line.starts_with("#~")) {
      line.remove_prefix(2);
      if (line.starts_with("|")) return;  // the English before an obsolete entry's: of no use any more
      takeWords(line, true);
    } else if (line.starts_with('#')) {
      takeComment(line);
    } else {
      takeWords(line, false);
    }
  }

  void takeComment(std::string_view line) {
    if (hasForms()) finish();
    if (line.starts_with("#,")) {
      line.remove_prefix(2);
      while (!line.empty()) {
        const std::size_t end = std::min(line.find(','), line.size());
        if (const auto flag = withoutBlanks(line.substr(0, end)); !flag.empty())
          entry_.flags.emplace_back(flag);
        line.remove_prefix(std::min(end + 1, line.size()));
      }
    } else if (line.starts_with("#|")) {
      entry_.before.emplace_back(line);
    } else {
      entry_.comments.emplace_back(line);
    }
    isBegun_ = true;
  }

  bool hasForms() const { return !entry_.forms.empty(); }

  /// Takes a keyword and its string, or a string that goes on.
  void takeWords(std::string_view line, bool isObsolete) {
    while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
    if (line.empty()) return;
    if (line.front() != '"') {
      const std::string_view keyword = line.substr(0, std::min(line.find_first_of(" \t\""), line.size()));
      begin(keyword, line, isObsolete);
      line.remove_prefix(keyword.size());
      while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
    }
    if (isSpoilt_) return;
    if (line.empty() || line.front() != '"')
      return fault(line.empty() ? whole_.substr(whole_.size()) : line,
                   "expected a string in quotation marks");
    if (!text_) return fault(line, "a string of its own, expected msgctxt, msgid or msgstr before it");
    if (isNew_) text_->at = placeOf(line);
    isNew_ = false;
    takeString(line);
  }

  /// Begins a part of an entry, and a new entry where it is the first.
  void begin(std::string_view keyword, std::string_view line, bool isObsolete) {
    const bool isForm = keyword.starts_with("msgstr");
    if (hasForms() && !isForm) finish();
    const Part before = part_;
    if (keyword == "msgctxt") {
      part_ = Part::context;
      if (before != Part::none)
        return fault(line, "msgctxt stands within an entry, expected it before msgid");
      text_ = &entry_.context.emplace();
    } else if (keyword == "msgid") {
      part_ = Part::id;
      if (before != Part::none && before != Part::context)
        return fault(line, "a second msgid, expected the msgstr of the first");
      text_ = &entry_.id;
    } else if (keyword == "msgid_plural") {
      part_ = Part::plural;
      if (before != Part::id) return fault(line, "msgid_plural stands alone, expected it behind a msgid");
      text_ = &entry_.plural.emplace();
    } else if (isForm) {
      part_ = Part::form;
      if (before != Part::id && before != Part::plural && before != Part::form)
        return fault(line, "msgstr stands alone, expected it behind a msgid");
      beginForm(keyword, line);
    } else {
      return fault(line, fmt::format("'{}' is no word of a PO file, expected msgctxt, msgid, msgid_plural, "
                                     "msgstr or a comment",
                                     keyword.substr(0, 40)));
    }
    if (before == Part::none) entry_.isObsolete = isObsolete;
    isNew_ = isBegun_ = true;
  }

  /// Begins "msgstr" or "msgstr[1]".
  void beginForm(std::string_view keyword, std::string_view line) {
    std::string_view number = keyword.substr(6);
    std::size_t form = 0;
    bool isRight = number.empty() ? !entry_.plural : number.size() == 3 && entry_.plural.has_value();
    if (!number.empty())
      isRight = isRight && number.front() == '[' && number.back() == ']' && isDigit(number[1]);
    if (isRight && !number.empty()) form = static_cast<std::size_t>(number[1] - '0');
    if (!isRight || form != entry_.forms.size() || form >= kMostForms) {
      return fault(line, fmt::format("'{}' stands here, expected {}", keyword.substr(0, 40),
                                     entry_.plural ? fmt::format("msgstr[{}]", entry_.forms.size())
                                     : hasForms()  ? "another entry"
                                                   : "msgstr"));
    }
    text_ = &entry_.forms.emplace_back();
  }

  /// Takes a line's string without its escapes.
  void takeString(std::string_view line) {
    std::size_t i = 1;
    for (; i < line.size() && line[i] != '"'; ++i) {
      if (line[i] != '\\') {
        text_->words += line[i];
        continue;
      }
      if (++i >= line.size()) break;
      const std::size_t sign = std::string_view("ntr\\\"").find(line[i]);
      if (sign == std::string_view::npos) {
        return fault(line.substr(i - 1),
                     "a backslash before a sign that needs none, expected \\n, \\t, \\\" or \\\\");
      }
      text_->words += "\n\t\r\\\""[sign];
    }
    if (i >= line.size())
      return fault(line, "the string has no end, expected a quotation mark on the same line");
    if (!withoutBlanks(line.substr(i + 1)).empty())
      fault(line.substr(i + 1), "something stands behind the string, expected the end of the line");
  }

  /// Puts the entry that has been read to the others.
  void finish() {
    PoEntry entry = std::exchange(entry_, {});
    const Part part = std::exchange(part_, Part::none);
    text_ = nullptr;
    const bool isBegun = std::exchange(isBegun_, false), isSpoilt = std::exchange(isSpoilt_, false);
    if (!isBegun || isSpoilt || part == Part::none) return;  // nothing, told, or comments alone
    if (entry.forms.empty()) {
      fault(file_.end, "the entry has no msgstr, expected one before the next entry or the end of the file");
      isSpoilt_ = false;
      return;
    }
    if (entry.id.words.empty() && !entry.context && !entry.isObsolete && !file_.head) {
      file_.head = std::move(entry);
      return;
    }
    if (file_.entries.size() >= kMostPoEntries) {
      throw InputErrors(
          {InputError(file_.path.string(), file_.end.line, 1,
                      fmt::format("more than {} entries, expected at most as many", kMostPoEntries))});
    }
    file_.entries.push_back(std::move(entry));
  }

  PoFile file_{.path = {}, .head = {}, .entries = {}, .end = {0, 1}};
  std::string_view rest_, whole_;
  PoEntry entry_;
  PoText* text_ = nullptr;
  Part part_ = Part::none;
  bool isNew_ = false, isBegun_ = false, isSpoilt_ = false;
  std::vector<InputError> faults_;
};

/// Returns the value of a line "Name: value" of a head.
std::string valueIn(std::string_view head, std::string_view name) {
  while (!head.empty()) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    const std::string_view line = head.substr(0, end);
    if (line.starts_with(name) && line.substr(name.size()).starts_with(':'))
      return std::string(withoutBlanks(line.substr(name.size() + 1)));
    head.remove_prefix(std::min(end + 1, head.size()));
  }
  return {};
}

void writeText(std::string& text, std::string_view mark, std::string_view keyword, std::string_view words) {
  const std::size_t feed = words.find('\n');
  if (feed == std::string_view::npos || feed + 1 == words.size()) {
    text += fmt::format("{}{} {}\n", mark, keyword, quotedPo(words));
    return;
  }
  text += fmt::format("{}{} \"\"\n", mark, keyword);
  while (!words.empty()) {
    const std::size_t end = std::min(words.find('\n'), words.size() - 1) + 1;
    text += fmt::format("{}{}\n", mark, quotedPo(words.substr(0, end)));
    words.remove_prefix(end);
  }
}

void writeEntry(std::string& text, const PoEntry& entry) {
  const std::string_view mark = entry.isObsolete ? "#~ " : "";
  for (const std::string& comment : entry.comments) text += comment + '\n';
  if (!entry.flags.empty()) text += fmt::format("#, {}\n", fmt::join(entry.flags, ", "));
  for (const std::string& line : entry.before) text += line + '\n';
  if (entry.context) writeText(text, mark, "msgctxt", entry.context->words);
  writeText(text, mark, "msgid", entry.id.words);
  if (entry.plural) writeText(text, mark, "msgid_plural", entry.plural->words);
  for (std::size_t form = 0; form < entry.forms.size(); ++form)
    writeText(text, mark, entry.plural ? fmt::format("msgstr[{}]", form) : "msgstr", entry.forms[form].words);
}

}  // namespace

bool PoEntry::isFuzzy() const { return std::ranges::find(flags, "fuzzy") != flags.end(); }

bool PoEntry::isTranslated() const {
  return !isFuzzy() && !isObsolete && !forms.empty() &&
         std::ranges::none_of(forms, [](const PoText& form) { return form.words.empty(); });
}

PoFile parsePo(const std::filesystem::path& path, std::string_view content) {
  if (const auto fault = faultOfBytes(path.string(), content)) throw InputErrors({*fault});
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  return PoParser(path, content).parse();
}

PoFile readPo(const std::filesystem::path& path) {
  return parsePo(path, readText(path, InputKind::translation));
}

std::optional<PoHeader> headerOf(const PoFile& file) {
  if (!file.head) return {};
  const std::string& words = file.head->forms.front().words;
  std::string charset = valueIn(words, "Content-Type");
  const std::size_t sign = charset.find("charset=");
  charset = sign == std::string::npos ? "" : charset.substr(sign + 8);
  return PoHeader{valueIn(words, "Language"), charset, valueIn(words, "Plural-Forms"),
                  file.head->forms.front().at};
}

std::string textOf(const PoFile& file) {
  std::string text;
  if (file.head) writeEntry(text, *file.head);
  for (const PoEntry& entry : file.entries) {
    if (!text.empty()) text += '\n';
    writeEntry(text, entry);
  }
  return text;
}

std::string quotedPo(std::string_view words) {
  std::string quoted = "\"";
  for (const char c : words) {
    switch (c) {
      case '\n':
        quoted += "\\n";
        break;
      case '\t':
        quoted += "\\t";
        break;
      case '\r':
        quoted += "\\r";
        break;
      case '"':
      case '\\':
        quoted += '\\';
        [[fallthrough]];
      default:
        quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace carom
