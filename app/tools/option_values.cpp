#include "app/tools/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "app/file_keys/language_name.h"
#include "app/toml/config_folder.h"

namespace carom {

CLI::Validator numberIn(const Range& range, const std::string& expected) {
  return CLI::Validator(
      [range, expected](std::string& text) {
        const std::size_t sign = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
        double value = 0.0;
        const char* end = text.data() + text.size();
        const auto [stop, failed] = std::from_chars(text.data() + sign, end, value);
        const bool whole = failed == std::errc() && stop == end;
        const bool fits =
            whole && value <= range.most && (range.above ? value > range.least : value >= range.least);
        return fits ? std::string() : fmt::format("'{}' is wrong, expected {}", text, expected);
      },
      "");
}

CLI::Validator shipped(const std::vector<std::string>& kinds) {
  return CLI::Validator(
      [kinds](std::string& text) {
        std::filesystem::path file = text;
        std::vector<std::string> names;
        for (const std::string& kind : kinds) {
          if (file == text) file = shippedFile(text, kind);
          for (const std::string& name : shippedNames(kind)) names.push_back(name);
        }
        std::error_code failed;
        const bool isName = file == text && !file.has_parent_path() && !file.has_extension();
        text = file.string();
        if (!isName || std::filesystem::exists(file, failed)) return std::string();
        const auto nearest = nearestWord(text, names);
        return fmt::format("there is no file '{}', expected {}", text,
                           nearest ? fmt::format("'{}'?", *nearest)
                                   : fmt::format("a file, or one of {}", fmt::join(names, ", ")));
      },
      "");
}

CLI::Validator numberOf(const std::vector<std::pair<std::string, int>>& names) {
  return CLI::Validator(
      [names](std::string& text) {
        std::string known;
        for (const auto& [name, number] : names) {
          if (text == name) {
            text = std::to_string(number);
            return std::string();
          }
          known += (known.empty() ? "" : ", ") + name;
        }
        return fmt::format("'{}' is wrong, expected one of {}", text, known);
      },
      "");
}

CLI::Option* addLanguage(CLI::App& command, std::string& language) {
  return command
      .add_option(
          "--language", language,
          "Language of the words on walls and in windows: a code that carom list tells, such as fr, or "
          "a PO file. Default: as the session or the rig says, else English")
      ->type_name("CODE|FILE.po")
      ->transform(CLI::Validator(
          [](std::string& text) {
            text = languageNamed(text, {});
            return refusalOfLanguage(text);
          },
          ""));
}

void addJson(CLI::App& command, std::optional<std::filesystem::path>& json) {
  command.add_option("--json", json, "Write the result to this file as JSON; - is standard output")
      ->type_name("FILE");
}

}  // namespace carom
