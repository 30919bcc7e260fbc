#include "app/toml/toml_file.h"

// toml++ asserts what malformed files can violate; without its assertions it reports them as errors.
#ifndef NDEBUG
#define NDEBUG
#endif

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "app/toml/config_folder.h"
#include "app/toml/findings.h"
#include "app/toml/toml_scan.h"

namespace carom {

namespace {

FilePlace placeOf(const toml::source_region& region) {
  return {std::max(1, static_cast<int>(region.begin.line)),
          std::max(1, static_cast<int>(region.begin.column))};
}

std::string_view kindOf(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

/// Returns the declared value of a key that is left out.
template <class T>
std::optional<T> fallbackOf(const FileKey& declared) {
  if (declared.fallback.empty()) return {};
  return static_cast<T>(declared.fallback.front());
}

}  // namespace

struct TomlFile::Document {
  std::filesystem::path file;
  std::filesystem::path searchRoot;  // empty: none
  std::optional<std::string> kept;
  std::map<std::filesystem::path, std::filesystem::path>
      found;  // files that keys name: many pucks may share a mesh
  toml::table root;
  FindingList faults;
  std::map<const toml::table*, std::shared_ptr<TomlTable::State>> opened;
  std::optional<TomlTable> rootTable;
};

struct TomlTable::State {
  TomlFile::Document& document;
  const toml::table& table;
  const FileKey& keys;  // the declaration
  FilePlace place;
  std::vector<std::string> asked;
  std::vector<std::string> missing;
  std::optional<std::size_t>
      judged;  // number of keys that had been asked for when the unknown ones were noted

  const FileKey& declared(std::string_view key) const {
    const FileKey* found = findKey(keys, key);
    if (!found) throw std::logic_error(fmt::format("the key {} of {} is not declared", key, keys.name));
    return *found;
  }
  const FileKey& declared(std::string_view key, std::initializer_list<FileKey::Type> types) const {
    const FileKey& found = declared(key);
    if (std::find(types.begin(), types.end(), found.type) == types.end())
      throw std::logic_error(fmt::format("the key {} of {} is declared as another type", key, keys.name));
    return found;
  }
  const toml::node* find(std::string_view key) {
    declared(key);
    if (std::find(asked.begin(), asked.end(), key) == asked.end()) asked.emplace_back(key);
    return table.get(key);
  }
  void fault(FilePlace where, std::string message) {
    document.faults.add({Finding::Kind::error, where, std::move(message)});
  }
  void wrong(std::string_view key, const toml::node& node, std::string_view expected) {
    fault(placeOf(node.source()), fmt::format("{} is {}, expected {}", key, kindOf(node), expected));
  }
  /// Returns the key's value, or null, with a fault noted if it is required.
  const toml::node* ask(std::string_view key, bool optional) {
    const toml::node* node = find(key);
    const bool noted = std::find(missing.begin(), missing.end(), key) != missing.end();
    if (!node && !optional && !noted) missing.emplace_back(key);
    return node;
  }
  static std::shared_ptr<State> open(TomlFile::Document& document, const toml::table& table,
                                     const FileKey& keys) {
    auto& state = document.opened[&table];
    if (!state)
      state = std::make_shared<State>(State{document, table, keys, placeOf(table.source()), {}, {}, {}});
    return state;
  }
  /// Returns the table that the node of a key is.
  TomlTable inner(std::string_view key, const toml::table& value) const {
    return TomlTable(open(document, value, declared(key)));
  }
  std::optional<double> numberOf(std::string_view name, const toml::node& node, const Range& range,
                                 bool whole);
  void noteUnknownAndMissing();
};

std::optional<double> TomlTable::State::numberOf(std::string_view name, const toml::node& node,
                                                 const Range& range, bool whole) {
  std::optional<double> value;
  if (const auto* integer = node.as_integer()) value = static_cast<double>(integer->get());
  if (const auto* floating = node.as_floating_point(); floating && !whole) value = floating->get();
  if (!value) {
    wrong(name, node, wordsFor(range, whole));
  } else if (!within(range, *value)) {
    fault(placeOf(node.source()), fmt::format("{} is {}, expected {}", name, *value, wordsFor(range, whole)));
    value.reset();
  } else if (range.above && range.least == 0.0 && *value < kSmallest) {
    fault(placeOf(node.source()), fmt::format("{} is {}, too small to calculate with, expected at least {}",
                                              name, *value, kSmallest));
    value.reset();
  }
  return value;
}

void TomlTable::State::noteUnknownAndMissing() {
  if (missing.empty() && asked.size() == judged) return;  // nothing has been read since the last time
  judged = asked.size();
  for (auto&& [key, value] : table) {
    if (std::find(asked.begin(), asked.end(), key.str()) != asked.end()) continue;
    const auto nearest = document.faults.isLong() ? std::nullopt : nearestWord(key.str(), asked);
    const bool absent = nearest && !table.contains(*nearest);
    fault(placeOf(key.source()),
          absent ? fmt::format("unknown key '{}', expected '{}'?", printable(key.str()), *nearest)
                 : fmt::format("unknown key '{}', expected one of {}", printable(key.str()),
                               fmt::join(asked, ", ")));
    if (absent) std::erase(missing, *nearest);
  }
  for (const std::string& key : missing) fault(place, fmt::format("{} is missing here", key));
  missing.clear();
}

const FileKey& TomlTable::declared(std::string_view key) const { return state_->declared(key); }

bool TomlTable::has(std::string_view key) const { return state_->find(key) != nullptr; }

bool TomlTable::isNumber(std::string_view key) const {
  const toml::node* node = state_->find(key);
  return node && node->is_number();
}

bool TomlTable::isOneOfTexts(std::string_view key) const {
  const FileKey& declared = state_->declared(key);
  const toml::node* node = state_->find(key);
  const auto* value = node ? node->as_string() : nullptr;
  return value &&
         std::find(declared.choices.begin(), declared.choices.end(), value->get()) != declared.choices.end();
}

double TomlTable::number(std::string_view key) const {
  const FileKey& declared = state_->declared(key, {FileKey::Type::number});
  return readNumber(key, declared.range, fallbackOf<double>(declared));
}

double TomlTable::numberOr(std::string_view key, double fallback, std::optional<double> most) const {
  Range range = state_->declared(key, {FileKey::Type::number}).range;
  range.most = most.value_or(range.most);
  return readNumber(key, range, fallback);
}

std::optional<double> TomlTable::rightNumber(std::string_view key) const {
  const Range& range = state_->declared(key, {FileKey::Type::number}).range;
  const toml::node* node = state_->ask(key, false);
  return node ? state_->numberOf(key, *node, range, false) : std::nullopt;
}

int TomlTable::integer(std::string_view key, std::optional<int> most) const {
  const FileKey& declared = state_->declared(key, {FileKey::Type::whole, FileKey::Type::monitors});
  Range range = declared.range;
  if (most) range.most = *most;
  const toml::node* node = state_->ask(key, !declared.fallback.empty());
  const auto value = node ? state_->numberOf(key, *node, range, true) : std::nullopt;
  return static_cast<int>(value.value_or(fallbackOf<double>(declared).value_or(range.least)));
}

std::size_t TomlTable::choice(std::string_view key, std::optional<std::size_t> fallback) const {
  const FileKey& declared = state_->declared(key, {FileKey::Type::choice});
  const std::vector<std::string_view>& names = declared.choices;
  if (!fallback) fallback = fallbackOf<std::size_t>(declared);
  const toml::node* node = state_->ask(key, fallback.has_value());
  if (!node) return fallback.value_or(0);
  const auto* value = node->as_string();
  const auto found = value ? std::find(names.begin(), names.end(), value->get()) : names.end();
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string given = value ? fmt::format("'{}'", printable(value->get())) : std::string(kindOf(*node));
  state_->fault(placeOf(node->source()),
                fmt::format("{} is {}, expected '{}'", key, given, fmt::join(names, "' or '")));
  return fallback.value_or(0);
}

void TomlTable::readNumbers(std::string_view key, std::span<double> result) const {
  const FileKey& declared = state_->declared(key, {FileKey::Type::numbers, FileKey::Type::wholes});
  if (declared.count != result.size())
    throw std::logic_error(fmt::format("the key {} is declared as {} numbers", key, declared.count));
  std::copy(declared.fallback.begin(), declared.fallback.end(), result.begin());
  const toml::node* node = state_->ask(key, !declared.fallback.empty());
  if (!node) return;
  const toml::array* array = node->as_array();
  if (!array) return state_->wrong(key, *node, fmt::format("an array of {} numbers", result.size()));
  if (array->size() != result.size()) {
    return state_->fault(placeOf(node->source()), fmt::format("{} has {} values, expected {} numbers", key,
                                                              array->size(), result.size()));
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto value = state_->numberOf(fmt::format("{}[{}]", key, i), (*array)[i], declared.range,
                                        declared.type == FileKey::Type::wholes);
    if (value) result[i] = *value;
  }
}

double TomlTable::readNumber(std::string_view key, const Range& range, std::optional<double> fallback) const {
  if (fallback && !has(key)) return *fallback;
  const toml::node* node = state_->ask(key, false);
  const auto value = node ? state_->numberOf(key, *node, range, false) : std::nullopt;
  return value.value_or(fallback.value_or(range.most));
}

bool TomlTable::flag(std::string_view key, std::optional<bool> fallback) const {
  if (!fallback) fallback = fallbackOf<bool>(state_->declared(key, {FileKey::Type::flag}));
  const toml::node* node = state_->ask(key, fallback.has_value());
  if (!node) return fallback.value_or(false);
  if (const auto* value = node->as_boolean()) return value->get();
  state_->wrong(key, *node, "true or false");
  return fallback.value_or(false);
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> fallback) const {
  state_->declared(key, {FileKey::Type::text, FileKey::Type::monitors});
  const toml::node* node = state_->ask(key, fallback.has_value());
  if (!node) return fallback.value_or("");
  const auto* value = node->as_string();
  if (value && !value->get().empty()) return printable(value->get());
  if (value) {
    fault(key, fmt::format("{} is empty, expected a text", key));
  } else {
    state_->wrong(key, *node, "a text in quotes");
  }
  return fallback.value_or("");
}

std::optional<std::chrono::year_month_day> TomlTable::date(std::string_view key) const {
  const FileKey& declared = state_->declared(key, {FileKey::Type::date});
  const toml::node* node = state_->ask(key, !declared.isRequired);
  if (!node) return {};
  const auto* value = node->as_date();
  if (!value) {
    state_->wrong(key, *node, "a date without quotes, such as 2031-12-31");
    return {};
  }
  const toml::date& day = value->get();
  return std::chrono::year(day.year) / static_cast<unsigned>(day.month) / static_cast<unsigned>(day.day);
}

std::vector<PlacedText> TomlTable::texts(std::string_view key) const {
  state_->declared(key, {FileKey::Type::texts, FileKey::Type::monitors});
  std::vector<PlacedText> result;
  const toml::node* node = state_->find(key);
  if (!node) return result;
  const toml::array* array = node->as_array();
  if (!array) {
    state_->wrong(key, *node, "an array of texts");
    return result;
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    const toml::node& element = (*array)[i];
    const auto* value = element.as_string();
    result.push_back({value ? printable(value->get()) : "", placeOf(element.source())});
    if (!value) {
      state_->wrong(fmt::format("{}[{}]", key, i), element, "a text in quotes");
    } else if (value->get().empty()) {
      fault(placeOf(element.source()), fmt::format("{}[{}] is empty, expected a text", key, i));
    }
  }
  return result;
}

std::vector<PlacedText> TomlTable::oneOrMoreTexts(std::string_view key) const {
  const toml::node* node = state_->find(key);
  if (!node || !node->is_string()) return texts(key);
  return {{text(key), placeOf(node->source())}};
}

std::optional<std::vector<PlacedPoint>> TomlTable::points(std::string_view key) const {
  const std::size_t count = state_->declared(key, {FileKey::Type::points}).count;
  const toml::node* node = state_->ask(key, false);
  if (!node) return {};
  const char* axes = count == 2 ? "[x, y]" : "[x, y, z]";
  const toml::array* array = node->as_array();
  if (!array) {
    state_->wrong(key, *node, fmt::format("an array of places {}", axes));
    return {};
  }
  std::vector<PlacedPoint> result;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const std::string name = fmt::format("{}[{}]", key, i);
    const toml::node& element = (*array)[i];
    const toml::array* coordinates = element.as_array();
    // The points after a wrong one are often wrong in the same way: one fault tells it.
    if (!coordinates) {
      state_->wrong(name, element, fmt::format("a place {}", axes));
      return {};
    }
    if (coordinates->size() != count) {
      state_->fault(placeOf(element.source()),
                    fmt::format("{} has {} values, expected a place {}", name, coordinates->size(), axes));
      return {};
    }
    PlacedPoint& point = result.emplace_back();
    point.place = placeOf(element.source());
    for (std::size_t k = 0; k < count; ++k) {
      const auto value = state_->numberOf(fmt::format("{}[{}]", name, k), (*coordinates)[k], {}, false);
      point.at.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  }
  return result;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  state_->declared(key, {FileKey::Type::table});
  const toml::node* node = state_->find(key);
  if (!node) return {};
  if (const toml::table* table = node->as_table()) return state_->inner(key, *table);
  state_->wrong(key, *node, fmt::format("one table [{}]", key));
  return {};
}

std::optional<TomlTable> TomlTable::requiredTable(std::string_view key) const {
  state_->ask(key, false);
  return table(key);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, std::optional<std::size_t> allowed) const {
  const std::size_t most = allowed.value_or(state_->declared(key, {FileKey::Type::tables}).most);
  std::vector<TomlTable> result;
  const toml::node* node = state_->find(key);
  if (!node) return result;
  const toml::array* array = node->as_array();
  if (!array) {
    state_->wrong(key, *node, fmt::format("tables [[{}]]", key));
    return result;
  }
  if (array->size() > most) {
    const FilePlace at = placeOf((*array)[most].source());
    throw InputErrors(
        {InputError(state_->document.file.string(), at.line, at.column,
                    fmt::format("{} tables [[{}]], expected at most {}", array->size(), key, most))});
  }
  for (const toml::node& element : *array) {
    if (const toml::table* table = element.as_table()) {
      result.push_back(state_->inner(key, *table));
    } else {
      state_->wrong(key, element, fmt::format("tables [[{}]]", key));
    }
  }
  return result;
}

void TomlTable::refuse(std::string_view key, const std::string& why) const {
  if (state_->find(key)) fault(key, fmt::format("{} {}", key, why));
}

FilePlace TomlTable::place(std::string_view key) const {
  const toml::node* node = state_->table.get(key);
  return node ? placeOf(node->source()) : state_->place;
}

FilePlace TomlTable::place() const { return state_->place; }

bool TomlTable::isKept() const { return state_->document.kept.has_value(); }

void TomlTable::fault(FilePlace where, std::string message) const {
  state_->fault(where, std::move(message));
}

TomlFile::TomlFile(const std::filesystem::path& file, const FileKey& keys,
                   const std::optional<std::string>& kept, const std::filesystem::path& root)
    : document_(std::make_unique<Document>()) {
  document_->file = file;
  document_->searchRoot = root;
  document_->kept = kept;
  const std::string text = kept ? *kept : readText(file, InputKind::toml);
  if (const auto wrong = faultBeforeParsing(text))
    throw InputErrors({InputError(file.string(), wrong->at.line, wrong->at.column, wrong->text)});
  try {
    document_->root = toml::parse(std::string_view(text), std::string_view(file.native()));
  } catch (const toml::parse_error& error) {
    const FilePlace where = placeOf(error.source());
    throw InputErrors({InputError(file.string(), where.line, where.column, printable(error.description()))});
  }
  document_->rootTable = TomlTable(TomlTable::State::open(*document_, document_->root, keys));
}

TomlFile::~TomlFile() = default;

const TomlTable& TomlFile::root() const { return *document_->rootTable; }

bool TomlFile::contains(std::string_view key) const { return document_->root.contains(key); }

void TomlFile::throwFaults() const {
  for (const auto& [table, state] : document_->opened) state->noteUnknownAndMissing();
  if (document_->faults.empty()) return;
  std::vector<InputError> faults;
  for (Finding& fault : toldOf(document_->faults.all()))
    faults.emplace_back(document_->file.string(), fault.at.line, fault.at.column, std::move(fault.text));
  throw InputErrors(std::move(faults));
}

/// Returns the folder below which the files lie that this one may name; empty if it may name any.
std::optional<std::filesystem::path> TomlFile::folderOfNamed(Reach reach) const {
  const Document& document = *document_;
  const std::filesystem::path folder = document.file.parent_path();
  if (!document.kept) return reach == Reach::anywhere ? std::nullopt : std::optional(folder);
  // A recorded text is this computer's if it is still in its file.
  if (!refusalOf(document.file, InputKind::toml).empty()) return configFolder();
  const bool isHere = reach == Reach::anywhere && contentOf(document.file, InputKind::toml) == *document.kept;
  return isHere ? std::nullopt : std::optional(folder);
}

std::filesystem::path TomlFile::handedFile(const std::filesystem::path& given) const {
  for (const auto& candidate : {document_->file.parent_path() / given, configFolder() / given}) {
    const auto below = document_->searchRoot / candidate.lexically_normal().relative_path();
    if (std::filesystem::exists(below) && liesBelow(below, document_->searchRoot)) return below;
  }
  return configFolder() / given;
}

std::filesystem::path TomlFile::existingFile(const TomlTable& table, std::string_view key, InputKind kind,
                                             Reach reach) const {
  const std::filesystem::path given = table.text(key);
  if (given.empty()) return {};  // has been reported
  if (const auto known = document_->found.find(given); known != document_->found.end()) return known->second;
  std::error_code failed;
  std::filesystem::path file = document_->file.parent_path() / given;
  if (!document_->searchRoot.empty()) {
    file = handedFile(given);
  } else if (!std::filesystem::exists(file, failed)) {
    file = configFolder() / given;
  }
  if (!std::filesystem::exists(file, failed)) {
    table.fault(key, fmt::format("{} '{}' is no file, expected one beside this file or in {}", key,
                                 given.string(), configFolder().string()));
    return {};
  }
  const auto folder = document_->searchRoot.empty() ? folderOfNamed(reach) : document_->searchRoot;
  if (folder && !liesBelow(file, *folder) && !liesBelow(file, configFolder())) {
    table.fault(key, fmt::format("{} '{}' is {}, expected a file below this folder or in {}", key,
                                 given.string(), outsideWords(file, *folder), configFolder().string()));
    return {};
  }
  const std::string refusal = refusalOf(file, kind);
  if (refusal.empty()) return document_->found[given] = file;
  table.fault(key, fmt::format("{} '{}': {}", key, given.string(), refusal));
  return {};
}

}  // namespace carom
