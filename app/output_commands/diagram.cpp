#include "app/output_commands/diagram.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <stdexcept>

#include "app/commands/session_options.h"
#include "app/journal/session_file.h"
#include "app/output_commands/words_in.h"
#include "app/report/spacetime_chart.h"
#include "app/scenario/starting_histories.h"
#include "app/tools/option_values.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr double kShown_s = 5.0;  // default duration of a scenario
// × the present event's time, because a diagram shows some of the future.
constexpr double kPlayedBeyond = 1.5;
constexpr double kEyes_m = 1.7;  // initial eye height above the floor in a scenario

/// Returns the diagram of a scenario, in which the room keeps its initial velocity.
DiagramSubject subjectOf(const Scenario& scenario, char along, double until_s) {
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(kPlayedBeyond * until_s);
  DiagramSubject subject = subjectOf(scenario);
  subject.lines.assign(billiard.worldLines().begin(), billiard.worldLines().end());
  for (const ScriptedBody& body : scenario.bodies) subject.lines.push_back(body.worldLine);
  subject.softSides = softSides(scenario.billiard, along, kPlayedBeyond * until_s);
  subject.events.assign(billiard.events().begin(), billiard.events().end());
  subject.beta = scenario.observer.beta;
  const Vec3 eyes_m = scenario.observer.position_m + Vec3(0.0, 0.0, kEyes_m);
  for (const double t_s : {0.0, until_s})
    subject.mine.push_back({t_s, eyes_m + subject.beta * (subject.c_m_s * t_s)});
  return subject;
}

/// Returns the diagram of a recorded session, to its end or to a board time.
DiagramSubject subjectOf(const DiagramOptions& options) {
  SessionFile session(options.source, options.game);
  const Scenario scenario = session.scenario();
  sayGame(session, scenario.title);
  DiagramSubject subject = subjectOf(scenario);
  World world{startingHistories(scenario), {}};
  for (FrameState state; session.next(state);) {
    const Event& here = state.record.viewers.front().observer.middle.observation;
    if (options.until_s && here.t_s > *options.until_s) break;
    session.apply(state, world);
    follow(subject, state.record, session.facts().viewers);
  }
  if (subject.mine.empty())
    throw std::runtime_error(
        fmt::format("session file {}: no frame of it is that early", options.source.string()));
  subject.lines.assign(world.histories.begin() + 1,
                       world.histories.end());  // without the resting body
  followTold(subject, world.people, options.from_s.value_or(-std::numeric_limits<double>::infinity()));
  subject.events = world.events;
  subject.knownUntil_s = subject.mine.back().t_s;
  BilliardSetup played = scenario.billiard;
  const std::vector<Stroke> byHand = session.strokes(played.pucks);
  played.strokes.insert(played.strokes.end(), byHand.begin(), byHand.end());
  subject.softSides = softSides(played, options.along, subject.knownUntil_s);
  return subject;
}

/// Returns the language that was asked for, or that of a session's first viewer.
std::string languageOf(const DiagramOptions& options) {
  if (!options.language.empty()) return options.language;
  return SessionFile(options.source, options.game, true).facts().languages.firstOf(0);
}

}  // namespace

int runDiagram(const DiagramOptions& options) {
  const WordsIn words(isScenario(options.source) ? options.language : languageOf(options));
  const DiagramSubject subject =
      isScenario(options.source)
          ? subjectOf(readScenario(options.source), options.along, options.until_s.value_or(kShown_s))
          : subjectOf(options);
  const Chart chart = spacetimeChart(subject, {options.along, options.from_s});
  writeChart(chart, options.figure);
  const glm::dvec2 shown_s = chart.yRange / subject.c_m_s;
  log::note(fmt::format("The diagram is in {}.", options.figure.string()));
  log::note(
      fmt::format("It shows {:.4g} to {:.4g} s of board time, the present event at {:.4g} s; --from and "
                  "--until choose others.",
                  shown_s.x, shown_s.y, subject.mine.back().t_s));
  return 0;
}

void addDiagram(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("diagram", "Draw the spacetime diagram of a scenario or of a recorded session");
  auto options = std::make_shared<DiagramOptions>();
  command->add_option("SOURCE", options->source, "Scenario or session file")
      ->required()
      ->transform(shipped({"scenarios"}));
  addGame(*command, options->game);
  command->add_option("-o,--output", options->figure, "The figure: FIG.svg or FIG.png")
      ->required()
      ->type_name("FIG");
  command->add_option("--along", options->along, "Board axis drawn across, with time upwards: x or y")
      ->capture_default_str()
      ->check(CLI::IsMember({'x', 'y'}));
  command
      ->add_option("--from", options->from_s,
                   "Board time at the lower edge; by default 5 s before the present event")
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command
      ->add_option("--until", options->until_s,
                   "Board time of the present event; by default 5 s, or the end of a session")
      ->type_name("S")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  addLanguage(*command, options->language);
  command->footer("Example:\n  carom diagram three-pucks -o three-pucks.svg");
  command->callback([options, &status] {
    if (options->from_s && options->until_s && !(*options->from_s < *options->until_s)) {
      throw CLI::ValidationError("--from", "is not before --until");
    }
    status = runDiagram(*options);
  });
}

}  // namespace carom
