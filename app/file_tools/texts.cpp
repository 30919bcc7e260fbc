#include "app/file_tools/texts.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "app/languages/language_files.h"
#include "app/languages/po_template.h"
#include "app/languages/scenario_texts.h"
#include "app/tools/option_values.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

void writeWhole(const std::filesystem::path& path, const PoFile& file) {
  WholeFile(path).commit(textOf(file));
}

void update(const std::filesystem::path& path, const std::vector<SourceText>& sources) {
  const UpdatedPo now = updated(readPo(path), sources);
  writeWhole(path, now.file);
  fmt::print("{}: {} texts, {} new, {} changed in English (fuzzy now), {} gone\n", path.string(),
             sources.size(), now.added, now.changed, now.gone);
}

}  // namespace

void writeTemplates(const std::filesystem::path& folder,
                    const std::optional<std::filesystem::path>& scenario) {
  std::error_code failed;  // writing says why
  std::filesystem::create_directories(folder, failed);
  if (scenario)
    return writeWhole(folder / (scenario->stem().string() + ".pot"), templateOf(scenarioTexts(*scenario)));
  writeWhole(folder / "carom.pot", templateOf(sourceTexts(texts::catalogue())));
  writeWhole(folder / "scenarios.pot", templateOf(shippedScenarioTexts()));
}

void updateLanguage(const std::string& code) {
  const std::filesystem::path folder = folderOfLanguage(code);
  update(folder / "carom.po", sourceTexts(texts::catalogue()));
  update(folder / "scenarios.po", shippedScenarioTexts());
}

void addTexts(CLI::App& app, int& status) {
  struct Line {
    std::optional<std::filesystem::path> folder, scenario;
    std::optional<std::string> code;
  };
  CLI::App* command =
      app.add_subcommand("texts", "Write templates for translators, or bring new English into a translation");
  const auto line = std::make_shared<Line>();
  CLI::Option* pot =
      command
          ->add_option("--pot", line->folder,
                       "Folder for the templates carom.pot (walls, console, pages) and scenarios.pot (the "
                       "shipped games and lessons)")
          ->type_name("DIR");
  command
      ->add_option(
          "--scenario", line->scenario,
          "With --pot: the template of this scenario alone; its translation is NAME.CODE.po beside it")
      ->type_name("FILE")
      ->needs(pot)
      ->transform(shipped({"scenarios"}));
  command
      ->add_option("--update", line->code,
                   "Bring new English into the PO files of this language: translations stay; those whose "
                   "English is another now are marked fuzzy and not shown; those of texts that are gone are "
                   "kept behind #~")
      ->type_name("CODE")
      ->excludes(pot);
  command->footer("Examples:\n  carom texts --pot templates\n  carom texts --update fr");
  command->callback([line, &status] {
    if (!line->folder && !line->code) throw CLI::RequiredError("--pot DIR or --update CODE");
    line->folder ? writeTemplates(*line->folder, line->scenario) : updateLanguage(*line->code);
    status = 0;
  });
}

}  // namespace carom
