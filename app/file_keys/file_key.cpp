#include "app/file_keys/file_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace carom {
namespace {

/// Returns the unit at the end of a key's name: "m/s²" of friction_m_s2.
std::string_view unitOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kUnits{{{"_kg_m2_s", "kg m²/s"},
                                                                                  {"_kg_m_s", "kg m/s"},
                                                                                  {"_m_s2", "m/s²"},
                                                                                  {"_rad_s", "rad/s"},
                                                                                  {"_m_s", "m/s"},
                                                                                  {"_ms", "ms"},
                                                                                  {"_kg", "kg"},
                                                                                  {"_hz", "Hz"},
                                                                                  {"_deg", "°"},
                                                                                  {"beta", "c"},
                                                                                  {"_m", "m"},
                                                                                  {"_s", "s"}}};
  for (const auto& [ending, unit] : kUnits) {
    if (name.ends_with(ending)) return unit;
  }
  return "";
}

}  // namespace

bool within(const Range& range, double value) {
  return (range.above ? value > range.least : value >= range.least) && value <= range.most;
}

std::string wordsFor(const Range& range, bool whole) {
  const char *above = range.above ? "above" : "from", *upTo = range.above ? "up to" : "to";
  if (whole) return fmt::format("a whole number {} {:.0f} {} {:.0f}", above, range.least, upTo, range.most);
  return fmt::format("a number {} {:g} {} {:g}", above, range.least, upTo, range.most);
}

const FileKey* findKey(const FileKey& table, std::string_view name) {
  const auto found = std::find_if(table.keys.begin(), table.keys.end(),
                                  [name](const FileKey& key) { return key.name == name; });
  return found == table.keys.end() ? nullptr : &*found;
}

namespace declare {
namespace {

FileKey key(std::string_view name, FileKey::Type type, std::string_view sentence) {
  return {.name = std::string(name), .type = type, .sentence = std::string(sentence)};
}

FileKey array(FileKey declared, std::size_t count, const Range& range,
              std::initializer_list<double> fallback) {
  declared.unit = unitOf(declared.name);
  declared.count = count;
  declared.range = range;
  declared.fallback = fallback;
  return declared;
}

}  // namespace

FileKey number(std::string_view name, const Range& range, std::string_view sentence,
               std::optional<double> fallback) {
  FileKey declared = array(key(name, FileKey::Type::number, sentence), 1, range, {});
  if (fallback) declared.fallback = {*fallback};
  return declared;
}

FileKey whole(std::string_view name, int least, int most, std::string_view sentence,
              std::optional<int> fallback) {
  const Range range{static_cast<double>(least), static_cast<double>(most)};
  FileKey declared = number(name, range, sentence, fallback);
  declared.type = FileKey::Type::whole;
  return declared;
}

FileKey flag(std::string_view name, std::string_view sentence, std::optional<bool> fallback) {
  FileKey declared = key(name, FileKey::Type::flag, sentence);
  if (fallback) declared.fallback = {*fallback ? 1.0 : 0.0};
  return declared;
}

FileKey text(std::string_view name, std::string_view sentence) {
  return key(name, FileKey::Type::text, sentence);
}

FileKey date(std::string_view name, std::string_view sentence) {
  return key(name, FileKey::Type::date, sentence);
}

FileKey choice(std::string_view name, std::span<const std::string_view> choices, std::string_view sentence,
               std::optional<std::size_t> fallback) {
  FileKey declared = key(name, FileKey::Type::choice, sentence);
  declared.choices.assign(choices.begin(), choices.end());
  if (fallback) declared.fallback = {static_cast<double>(*fallback)};
  return declared;
}

FileKey choice(std::string_view name, std::initializer_list<std::string_view> choices,
               std::string_view sentence, std::optional<std::size_t> fallback) {
  return choice(name, std::span(choices.begin(), choices.size()), sentence, fallback);
}

FileKey numbers(std::string_view name, std::size_t count, const Range& range, std::string_view sentence,
                std::initializer_list<double> fallback) {
  return array(key(name, FileKey::Type::numbers, sentence), count, range, fallback);
}

FileKey wholes(std::string_view name, std::size_t count, const Range& range, std::string_view sentence,
               std::initializer_list<double> fallback) {
  return array(key(name, FileKey::Type::wholes, sentence), count, range, fallback);
}

FileKey texts(std::string_view name, std::string_view sentence) {
  return key(name, FileKey::Type::texts, sentence);
}

FileKey points(std::string_view name, std::size_t count, std::string_view sentence) {
  return array(key(name, FileKey::Type::points, sentence), count, {}, {});
}

FileKey table(std::string_view name, std::string_view sentence, std::vector<FileKey> keys) {
  FileKey declared = key(name, FileKey::Type::table, sentence);
  declared.keys = std::move(keys);
  return declared;
}

FileKey tables(std::string_view name, std::string_view sentence, std::vector<FileKey> keys) {
  FileKey declared = table(name, sentence, std::move(keys));
  declared.type = FileKey::Type::tables;
  return declared;
}

FileKey required(FileKey key) {
  key.isRequired = true;
  return key;
}

FileKey inUnit(std::string_view unit, FileKey key) {
  key.unit = unit;
  return key;
}

FileKey fitting(std::string_view pattern, FileKey key) {
  key.pattern = pattern;
  return key;
}

FileKey ofLetters(std::size_t most, FileKey key) {
  key.letters = most;
  return key;
}

FileKey orOneOf(std::initializer_list<std::string_view> texts, FileKey number) {
  number.choices = texts;
  return number;
}

FileKey ofSize(std::size_t fewest, std::size_t most, FileKey key) {
  key.fewest = fewest;
  key.most = most;
  return key;
}

}  // namespace declare

}  // namespace carom
