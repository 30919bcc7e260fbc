#include "app/output_commands/page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/session_options.h"
#include "app/output_commands/words_in.h"
#include "app/page/page_file.h"
#include "app/stage/scenario_scene.h"
#include "app/tools/option_values.h"
#include "cave/scene/kept_light.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

constexpr double kUsual_s = 20.0;  // of a game without a session

/// Returns the language that was asked for, or the one that the visitor read at first.
std::string languageOf(const PageOptions& options) {
  if (!options.language.empty()) return options.language;
  const SessionFile session(options.source, options.visit.game, true);
  const std::string& as = options.visit.as;
  return session.facts().languages.firstOf(as.empty() ? 0 : session.viewerNamed(as));
}

void checkRange(const PageOptions& options) {
  const VisitOptions& visit = options.visit;
  if (visit.from_s && visit.until_s && !(*visit.from_s < *visit.until_s))
    throw CLI::ValidationError("--from", "is not before --until");
  if (!isScenario(options.source)) return;
  if (visit.game || !visit.as.empty() || visit.from_s || visit.hasStillEyes)
    throw CLI::ValidationError(
        "page", "--game, --as, --from and --still-eyes are for sessions, expected --until alone");
  if (visit.until_s.value_or(0.0) > kLongestGame_s)
    throw CLI::ValidationError(
        "--until", fmt::format("is more than a page plays, expected at most {} s", kLongestGame_s));
}

}  // namespace

int runPage(const PageOptions& options) {
  WholeFile out(options.page);
  const WordsIn words(isScenario(options.source) ? options.language : languageOf(options));
  const Visit visit = isScenario(options.source)
                          ? visitOf(options.source, options.visit.until_s.value_or(kUsual_s))
                          : visitOf(options.source, options.visit);
  openMeshes(visit.scenario);
  Scene scene = sceneOf(visit.scenario, visit.tessellation);
  lightScene(scene, folderOfLight());
  const std::string page = pageOf(visit, scene);
  out.commit(page);
  log::note(fmt::format("The page is in {}: {} frames, {:.2f} MB. Any browser opens it.",
                        options.page.string(), visit.frames.size(), 1e-6 * static_cast<double>(page.size())));
  return 0;
}

void addPage(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "page",
      "Make a page for browsers that shows a recorded visit again, or a game, from any observer's eyes");
  auto options = std::make_shared<PageOptions>();
  VisitOptions& visit = options->visit;
  command->add_option("SOURCE", options->source, "Session file, or a scenario that nobody has played yet")
      ->required()
      ->transform(shipped({"scenarios"}));
  command->add_option("-o,--output", options->page, "The page: one file, which holds all it needs")
      ->required()
      ->type_name("PAGE.html");
  addGame(*command, visit.game);
  command
      ->add_option("--as", visit.as,
                   "Of several who shared the room, the one whose visit it is; by default the first")
      ->type_name("NAME");
  command->add_option("--from", visit.from_s, "Session time at which it begins; by default that of the game")
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command
      ->add_option(
          "--until", visit.until_s,
          fmt::format("Session time at which it ends; of a scenario, board time, by default {} s", kUsual_s))
      ->type_name("S")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  command->add_option("--every", visit.every, "Keep the frames whose numbers are multiples of this")
      ->type_name("K")
      ->capture_default_str()
      ->check(CLI::Range(1L, 1000000L));
  command->add_flag("--still-eyes", visit.hasStillEyes,
                    "Leave out the way of the visitor's head: it stays where it was longest");
  addLanguage(*command, options->language);
  command->footer(
      "The page holds the visit alone: no other game of the session, no tracker's samples, no file's place.\n"
      "Examples:\n  carom page game.db -o visit.html\n  carom page game.db --from 30 --until 90 --still-eyes "
      "-o visit.html\n"
      "  carom page two-cushions -o two-cushions.html");
  command->callback([options, &status] {
    checkRange(*options);
    status = runPage(*options);
  });
}

}  // namespace carom
