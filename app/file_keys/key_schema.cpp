#include "app/file_keys/key_schema.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using Json = nlohmann::ordered_json;
using Type = FileKey::Type;

Json schemaOfNumber(const FileKey& key, bool whole) {
  Json schema{{"type", whole ? "integer" : "number"}};
  if (std::isfinite(key.range.least))
    schema[key.range.above ? "exclusiveMinimum" : "minimum"] = key.range.least;
  if (std::isfinite(key.range.most)) schema["maximum"] = key.range.most;
  return schema;
}

Json schemaOfText(const FileKey& key) {
  if (!key.choices.empty()) return {{"enum", key.choices}};
  Json schema{{"type", "string"}, {"minLength", 1}};
  if (key.letters != kAnyNumber) schema["maxLength"] = key.letters;
  if (!key.pattern.empty()) schema["pattern"] = key.pattern;
  return schema;
}

Json arrayOf(Json items, std::size_t fewest, std::size_t most) {
  Json schema{{"type", "array"}, {"items", std::move(items)}};
  if (fewest > 0) schema["minItems"] = fewest;
  if (most != kAnyNumber) schema["maxItems"] = most;
  return schema;
}

/// Returns the schema that a combination of keys fits.
Json schemaOfCombination(const FileKey::Combination& combination) {
  Json schema = Json::object();
  if (!combination.with.empty()) schema["required"] = combination.with;
  Json none = Json::array();
  for (const std::string_view name : combination.without) none.push_back({{"required", {name}}});
  if (!none.empty()) schema["not"] = {{"anyOf", none}};
  return schema;
}

Json schemaOfKey(const FileKey& key);

/// Returns the schema of a table, without the key `without` if that is not empty.
Json schemaOfTable(const FileKey& table, const std::string& without) {
  Json schema{{"type", "object"}, {"additionalProperties", false}};
  Json required = Json::array(), properties = Json::object();
  for (const FileKey& key : table.keys) {
    if (key.name == without) continue;
    if (key.isRequired) required.push_back(key.name);
    properties[key.name] = schemaOfKey(key);
  }
  if (!required.empty()) schema["required"] = required;
  schema["properties"] = properties;
  for (const auto& rule : table.rules) {
    Json any = Json::array();
    for (const FileKey::Combination& combination : rule) any.push_back(schemaOfCombination(combination));
    schema["allOf"].push_back({{"anyOf", any}});
  }
  return schema;
}

Json schemaOfTables(const FileKey& key) {
  Json schema = arrayOf(schemaOfTable(key, ""), key.fewest, key.most);
  if (key.notInFirst.empty()) return schema;
  schema["additionalItems"] = schema["items"];
  schema["items"] = Json::array({schemaOfTable(key, key.notInFirst)});
  return schema;
}

Json schemaOfValue(const FileKey& key) {
  switch (key.type) {
    case Type::number:
    case Type::whole:
      if (!key.choices.empty()) return {{"anyOf", {schemaOfNumber(key, false), {{"enum", key.choices}}}}};
      return schemaOfNumber(key, key.type == Type::whole);
    case Type::flag:
      return {{"type", "boolean"}};
    case Type::date:
      return {{"type", "string"}, {"format", "date"}};
    case Type::text:
    case Type::choice:
      return schemaOfText(key);
    case Type::numbers:
    case Type::wholes:
      return arrayOf(schemaOfNumber(key, key.type == Type::wholes), key.count, key.count);
    case Type::texts:
      return arrayOf(schemaOfText(key), key.fewest, key.most);
    case Type::points:
      return arrayOf(arrayOf(schemaOfNumber(key, false), key.count, key.count), key.fewest, key.most);
    case Type::monitors:
      return {{"anyOf",
               {schemaOfNumber(key, true), schemaOfText(key), arrayOf(schemaOfText(key), 1, kAnyNumber)}}};
    case Type::table:
      return schemaOfTable(key, "");
    case Type::tables:
      break;
  }
  return schemaOfTables(key);
}

Json fallbackOf(const FileKey& key) {
  if (key.type == Type::flag) return key.fallback.front() != 0.0;
  if (key.type == Type::choice) return key.choices[static_cast<std::size_t>(key.fallback.front())];
  Json values = Json::array();
  for (const double value : key.fallback) {
    const bool isWhole = value == std::floor(value) && std::abs(value) < kFurthest;
    values.push_back(isWhole ? Json(static_cast<long long>(value)) : Json(value));
  }
  return key.type == Type::numbers || key.type == Type::wholes ? values : values.front();
}

Json schemaOfKey(const FileKey& key) {
  Json schema = schemaOfValue(key);
  schema["description"] = key.sentence;
  if (!key.fallback.empty()) schema["default"] = fallbackOf(key);
  return schema;
}

/// Returns the number of a kind of things with it: "2 to 4 texts".
std::string sizeOf(const FileKey& key, std::string_view things) {
  if (key.most == kAnyNumber)
    return key.fewest > 1 ? fmt::format("{} or more {}", key.fewest, things) : std::string(things);
  return key.fewest == 0 ? fmt::format("at most {} {}", key.most, things)
                         : fmt::format("{} to {} {}", key.fewest, key.most, things);
}

std::string rangeOf(const FileKey& key) {
  const bool isLimited = key.range.least != -kFurthest || key.range.most != kFurthest;
  std::string words;
  if (isLimited && key.range.above) {
    words = fmt::format(" above {:g}", key.range.least);
    if (key.range.most < kFurthest) words += fmt::format(" up to {:g}", key.range.most);
  } else if (isLimited) {
    words = fmt::format(" from {:g}", key.range.least);
    if (key.range.most < kFurthest) words += fmt::format(" to {:g}", key.range.most);
  }
  return key.unit.empty() ? words : fmt::format("{} ({})", words, key.unit);
}

/// Returns what a key's value may be, in words.
std::string valueOf(const FileKey& key) {
  const std::string letters =
      key.letters == kAnyNumber ? "" : fmt::format(" of at most {} letters", key.letters);
  const std::string choices =
      key.choices.empty() ? "" : fmt::format("`\"{}\"`", fmt::join(key.choices, "\"`, `\""));
  switch (key.type) {
    case Type::number:
      return "a number" + rangeOf(key) + (choices.empty() ? "" : ", or " + choices);
    case Type::whole:
      return "a whole number" + rangeOf(key);
    case Type::flag:
      return "`true` or `false`";
    case Type::date:
      return "a date, such as 2031-12-31";
    case Type::text:
      return "a text" + letters;
    case Type::choice:
      return choices;
    case Type::numbers:
      return fmt::format("{} numbers{}", key.count, rangeOf(key));
    case Type::wholes:
      return fmt::format("{} whole numbers{}", key.count, rangeOf(key));
    case Type::texts:
      return choices.empty() ? "[" + sizeOf(key, "texts") + "]" + letters : "an array of " + choices;
    case Type::points:
      return fmt::format("[{}]{}", sizeOf(key, fmt::format("points of {} numbers", key.count)), rangeOf(key));
    case Type::monitors:
      return fmt::format("a whole number{}, a text, or an array of texts", rangeOf(key));
    case Type::table:
      return "a table";
    case Type::tables:
      break;
  }
  return sizeOf(key, "tables");
}

/// Returns what holds where a key is left out; a text of JSON is one of TOML.
std::string leftOut(const FileKey& key) {
  if (key.isRequired) return "required";
  return key.fallback.empty() ? "" : fmt::format("`{}`", fallbackOf(key).dump());
}

/// Appends the section of a table and those of the tables in it.
void addTable(const FileKey& table, const std::string& path, std::string& page) {
  if (!path.empty()) {
    const bool isOne = table.type == Type::table;
    page += fmt::format("\n## {}{}{}\n\n{}\n", isOne ? "[" : "[[", path, isOne ? "]" : "]]", table.sentence);
  }
  page += "\n| key | value | left out | meaning |\n| --- | --- | --- | --- |\n";
  for (const FileKey& key : table.keys)
    page += fmt::format("| `{}` | {} | {} | {} |\n", key.name, valueOf(key), leftOut(key), key.sentence);
  for (const FileKey& key : table.keys) {
    if (!key.keys.empty()) addTable(key, path.empty() ? key.name : path + "." + key.name, page);
  }
}

}  // namespace

std::string schemaOf(const FileKey& file) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", file.sentence}};
  schema.update(schemaOfTable(file, ""));
  return schema.dump(2) + "\n";
}

std::string pageOf(const FileKey& file) {
  std::string page = fmt::format("# Keys of a {}\n", file.name);
  addTable(file, "", page);
  return page;
}

}  // namespace carom
