#include "app/output_commands/export_spacetime.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands/session_options.h"
#include "app/journal/session_file.h"
#include "app/replay/recorded_source.h"
#include "app/report/sculpture_file.h"
#include "app/scenario/scenario.h"
#include "app/scenario/starting_histories.h"
#include "app/stage/scenario_scene.h"
#include "app/tools/option_values.h"
#include "engine/billiard/billiard.h"
#include "engine/sculpture/game_sculpture.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr double kSculpted_s = 10.0, kLongest_s = 600.0;
constexpr std::size_t kMostPucks = 100;
constexpr double kLeastWall_m = 1.2e-3;  // what printers with a nozzle of 0.4 mm can build

/// The game whose sculpture is made.
struct SculptureSubject {
  BilliardSetup setup;
  std::vector<WorldLine> lines;  // one for each puck
  std::vector<GameEvent> events;
  Span span;
};

Span spanOf(const ExportSpacetimeOptions& options, double ends_s) {
  const double until_s = options.until_s.value_or(options.from_s ? *options.from_s + kSculpted_s : ends_s);
  const Span span{options.from_s.value_or(std::max(0.0, until_s - kSculpted_s)), until_s};
  if (!(span.from_s < span.until_s))
    throw std::runtime_error(
        fmt::format("--from {:g} --until {:g}: nothing lies between, expected --from before --until",
                    span.from_s, span.until_s));
  if (span.until_s - span.from_s > kLongest_s)
    throw std::runtime_error(
        fmt::format("--from {:g} --until {:g}: {:g} s are too long for a model, expected at most {:g} s",
                    span.from_s, span.until_s, span.until_s - span.from_s, kLongest_s));
  return span;
}

/// Adds the bodies that move as told.
void addBodies(const Scenario& scenario, SculptureSubject& subject) {
  for (const ScriptedBody& body : scenario.bodies) {
    subject.setup.pucks.push_back(outlineOf(body));
    subject.lines.push_back(body.worldLine);
  }
}

SculptureSubject playedGame(const ExportSpacetimeOptions& options) {
  const Scenario scenario = readScenario(options.source);
  SculptureSubject subject;
  subject.setup = scenario.billiard;
  subject.span = spanOf(options, kSculpted_s);
  Billiard billiard(subject.setup);
  billiard.advanceTo(subject.span.until_s);
  subject.lines.assign(billiard.worldLines().begin(), billiard.worldLines().end());
  subject.events.assign(billiard.events().begin(), billiard.events().end());
  addBodies(scenario, subject);
  return subject;
}

SculptureSubject recordedGame(const ExportSpacetimeOptions& options) {
  SessionFile session(options.source, options.game);
  const Scenario scenario = session.scenario();
  sayGame(session, scenario.title);
  const RecordedGame game = wholeGame(session, startingHistories(scenario));
  SculptureSubject subject;
  subject.setup = scenario.billiard;
  const auto first = game.world.histories.begin() + 1;
  subject.lines.assign(first, first + static_cast<std::ptrdiff_t>(subject.setup.pucks.size()));
  subject.events = game.world.events;
  subject.span = spanOf(options, game.known_s);
  addBodies(scenario, subject);
  return subject;
}

/// Keeps the pucks that are nearest to the middle of the board at the beginning, and says so.
void keepNearest(SculptureSubject& subject) {
  const std::size_t count = subject.setup.pucks.size();
  if (count <= kMostPucks) return;
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> away_m;
  for (const WorldLine& line : subject.lines)
    away_m.push_back(glm::length(Vec2(line.at(subject.span.from_s).event.r_m)));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return away_m[a] < away_m[b]; });
  order.resize(kMostPucks);
  std::sort(order.begin(), order.end());
  SculptureSubject kept;
  for (const std::size_t puck : order) {
    kept.setup.pucks.push_back(subject.setup.pucks[puck]);
    kept.lines.push_back(subject.lines[puck]);
  }
  const auto isKept = [&](const Turn& turn) {
    return std::binary_search(order.begin(), order.end(), turn.puck);
  };
  std::erase_if(subject.events, [&](const GameEvent& event) {
    return !event.turns.empty() && std::none_of(event.turns.begin(), event.turns.end(), isKept);
  });
  subject.setup.pucks = std::move(kept.setup.pucks);
  subject.lines = std::move(kept.lines);
  log::note(
      fmt::format("Of {} pucks, the {} nearest to the middle of the board are shown.", count, kMostPucks));
}

void say(const GameSculpture& made, const ExportSpacetimeOptions& options, const Span& span) {
  Vec3 low(1e9), high(-1e9);
  double volume = 0.0;
  std::size_t triangles = 0, tubes = 0;
  for (const SculpturePart& part : made.parts) {
    if (part.kind == SculpturePartKind::tube) ++tubes;
    if (part.kind != SculpturePartKind::cushion) volume += volume_m3(part.solid);
    triangles += part.solid.triangles.size();
    for (const Vec3& point : part.solid.points) low = glm::min(low, point), high = glm::max(high, point);
  }
  const Vec3 size_mm = (high - low) * (made.scale * 1000.0);
  log::note(fmt::format("{}: {} tube{}, {:g} to {:g} s, {:.0f} × {:.0f} × {:.0f} mm, {} triangles.",
                        options.out.string(), tubes, tubes == 1 ? "" : "s", span.from_s, span.until_s,
                        size_mm.x, size_mm.y, size_mm.z, triangles));
  log::note(fmt::format(
      "A metre of the board, and a metre of light ({:.3g} s), is {:.1f} mm. Its parts have {:.1f} cm³; "
      "the thinnest is {:.2f} mm.",
      1.0 / made.lightSpeed_m_s, 1000.0 * made.scale, 1e6 * volume * std::pow(made.scale, 3),
      1000.0 * made.leastWall_m));
  if (made.thickened > 0)
    log::note(fmt::format(
        "{} of the tubes would be thinner than {:.1f} mm at this size, and were thickened. A larger "
        "--size shows them as they are.",
        made.thickened, 1000.0 * kLeastWall_m));
  if (made.withoutTube > 0)
    log::note(fmt::format("{} bod{} left out: soft, or not there between these moments.", made.withoutTube,
                          made.withoutTube == 1 ? "y is" : "ies are"));
}

}  // namespace

int runExportSpacetime(const ExportSpacetimeOptions& options) {
  SculptureSubject subject = isScenario(options.source) ? playedGame(options) : recordedGame(options);
  keepNearest(subject);
  const bool prints = isForPrinters(options.out);
  const GameSculpture made =
      sculptureOf({subject.setup, subject.lines, subject.events},
                  {subject.span, options.beta, options.size_m, prints ? kLeastWall_m : 0.0, !prints});
  writeSculpture(made, options.out);
  say(made, options, subject.span);
  return 0;
}

}  // namespace carom
