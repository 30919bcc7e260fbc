#include "app/tools/force.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "app/hand/hand_laws.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/tables/csv_table.h"
#include "app/toml/config_folder.h"
#include "app/tools/live_display.h"
#include "app/tools/option_values.h"
#include "devices/force/force_loop.h"
#include "devices/force/recorded_hand.h"
#include "devices/force/simulated_force.h"
#include "devices/setup/force_factory.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

/// What the command works with: a device and the law of its hand.
struct Feeling {
  ForceSetup setup;
  ForceLimits limits;
  RoomAxes axes;
  ForceLaw law;
};

const ForceSetup& forceOf(const Rig& rig, const ForceOptions& options) {
  for (const ViewerSetup& viewer : rig.viewers) {
    if (viewer.force) return *viewer.force;
  }
  throw InputError(options.rig.string(), 1, 1,
                   "no hand of this rig has a force device, expected [hand.force]");
}

/// Returns the puck that is held, or the one that the cue strikes: the scenario's first.
const Puck& puckOf(const Scenario& scenario, const ForceOptions& options) {
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  if (pucks.empty())
    throw InputError(options.scenario.string(), 1, 1, "there is no puck to feel, expected one at least");
  if (!options.hold) return pucks.front();
  std::string names;
  for (const Puck& puck : pucks) {
    if (puck.name == *options.hold) return puck;
    names += (names.empty() ? "" : ", ") + puck.name;
  }
  throw std::runtime_error(fmt::format("there is no puck '{}' in {}, expected one of {}", *options.hold,
                                       options.scenario.string(), names));
}

Feeling feelingOf(const ForceOptions& options) {
  const Rig rig = readRig(options.rig);
  const Scenario scenario = readScenario(options.scenario);
  Feeling feeling{forceOf(rig, options), {}, rig.axes, {}};
  feeling.limits = limitsOf(feeling.setup);
  const std::string lowered = loweredStiffness(feeling.setup);
  if (!lowered.empty()) log::warn(lowered);
  const HandLaws laws(feeling.setup, rig.axes, scenario.billiard);
  const Puck& puck = puckOf(scenario, options);
  feeling.law =
      options.hold ? laws.held(puck.mass_kg, options.atSpeed * rig.axes.right) : laws.cue(puck.mass_kg);
  return feeling;
}

/// A tick of a run.
struct Tick {
  ForceReport report;
  double stored_j = 0.0;
  CueForce cue;
};

/// Returns the columns of the rows of a run; with those of a puck that is held, if it is.
std::vector<CsvColumn<Tick>> columnsOf(bool holds) {
  std::vector<CsvColumn<Tick>> columns{
      {"time_s", [](const Tick& tick) { return tick.report.time_s; }},
      {"x_m", [](const Tick& tick) { return tick.report.position_m.x; }},
      {"y_m", [](const Tick& tick) { return tick.report.position_m.y; }},
      {"z_m", [](const Tick& tick) { return tick.report.position_m.z; }},
      {"force_x_n", [](const Tick& tick) { return tick.report.force_n.x; }},
      {"force_y_n", [](const Tick& tick) { return tick.report.force_n.y; }},
      {"force_z_n", [](const Tick& tick) { return tick.report.force_n.z; }},
      {"scale", [](const Tick& tick) { return tick.cue.scale; }},
      {"energy_j", [](const Tick& tick) { return tick.report.energy_j; }},
      {"stored_j", [](const Tick& tick) { return tick.stored_j; }},
      {"stroke_beta", [](const Tick& tick) { return tick.cue.beta(glm::length(tick.report.draw_m)); }}};
  if (!holds) return columns;
  columns.push_back({"proxy_beta", [](const Tick& tick) { return tick.report.proxyBeta; }});
  columns.push_back({"shown_kg", [](const Tick& tick) { return tick.report.shown_kg; }});
  return columns;
}

/// Writes the rows of a run: one a tick.
class Rows {
 public:
  Rows(const ForceLaw& law, bool holds)
      : law_(law), columns_(columnsOf(holds)), text_(csvHead<Tick>(columns_)) {}

  void add(const ForceReport& report, double stored_j) {
    text_ += csvLine<Tick>(columns_, {report, stored_j, law_.cue});
  }

  const std::string& text() const { return text_; }

 private:
  const ForceLaw& law_;
  std::vector<CsvColumn<Tick>> columns_;
  std::string text_;
};

/// Returns the number of ticks from the first row of a trace to its last.
long ticksIn(const std::vector<HandRow>& hand, const ForceLimits& limits) {
  constexpr double kRounding = 1e-6;
  return 1 + static_cast<long>(
                 std::floor((hand.back().time_s - hand.front().time_s) / limits.period_s + kRounding));
}

/// Throws InputError if a trace takes more ticks than rows can be kept.
void checkLength(const std::vector<HandRow>& hand, const ForceLimits& limits,
                 const std::filesystem::path& file) {
  constexpr double kMostTicks = 4e6;
  const double lasts_s = hand.back().time_s - hand.front().time_s;
  if (lasts_s > kMostTicks * limits.period_s)
    throw InputError(file.string(), 2, 1,
                     fmt::format("the trace lasts {:g} s, expected at most {:g} s at this device's rate",
                                 lasts_s, kMostTicks * limits.period_s));
}

/// The hand is where the trace says, whatever the force. The port's sum is that of the trapezoidal rule.
void runPositions(const std::vector<HandRow>& hand, Feeling& feeling, Rows& rows) {
  ForceLoop loop(feeling.limits);
  ForceDeviceState device;
  double stored_j = 0.0;
  for (long tick = 0, ticks = ticksIn(hand, feeling.limits); tick < ticks; ++tick) {
    const double now_s = hand.front().time_s + static_cast<double>(tick) * feeling.limits.period_s;
    const HandRow now = handAt(hand, now_s);
    const glm::dvec3 moved_m = tick == 0 ? glm::dvec3(0.0) : now.place_m - device.position_m;
    device.position_m = now.place_m;
    device.pressed = now.pressed;
    device.time_s = feeling.law.posted_s = now_s;
    const glm::dvec3 before_n = device.held_n;
    device.held_n = loop.tick(now_s, device, feeling.law).force_n;
    stored_j -= 0.5 * glm::dot(before_n + device.held_n, moved_m);
    rows.add(loop.report(), stored_j);
  }
}

/// The hand wants to be where the trace says, and holds the simulated device.
void runPushes(const std::vector<HandRow>& hand, Feeling& feeling, Rows& rows) {
  ForceLoop loop(feeling.limits);
  SimulatedForce device(feeling.limits);
  for (long tick = 0, ticks = ticksIn(hand, feeling.limits); tick < ticks; ++tick) {
    const double now_s = hand.front().time_s + static_cast<double>(tick) * feeling.limits.period_s;
    const HandRow wish = handAt(hand, now_s);
    device.wish(wish.place_m);
    device.press(wish.pressed);
    feeling.law.posted_s = now_s;
    device.write(loop.tick(now_s, device.read(now_s), feeling.law));
    rows.add(loop.report(), device.port_j());
  }
}

int runRecorded(const ForceOptions& options, Feeling& feeling) {
  WholeFile out(options.csv);
  const std::filesystem::path& file = options.positions ? *options.positions : *options.pushes;
  const std::vector<HandRow> hand = readHandRows(file);
  checkLength(hand, feeling.limits, file);
  Rows rows(feeling.law, options.hold.has_value());
  if (options.positions)
    runPositions(hand, feeling, rows);
  else
    runPushes(hand, feeling, rows);
  out.commit(rows.text());
  return 0;
}

const char* limitWords(const ForceReport& report) {
  switch (report.limit) {
    case ForceReport::Limit::force:
      return "the strongest force";
    case ForceReport::Limit::slew:
      return "how fast a force may change";
    case ForceReport::Limit::passivity:
      return "passivity";
    case ForceReport::Limit::none:
      break;
  }
  return "nothing";
}

std::string tableOf(const Feeling& feeling, const ForceReport& report, const std::string& news) {
  const glm::dvec3 &r = report.position_m, &f = report.force_n;
  std::string text = fmt::format("{}: {}\n", nameOf(feeling.setup),
                                 report.active ? "the button is held" : "no button is held");
  text += fmt::format("place     {:8.1f} {:8.1f} {:8.1f} mm\n", 1e3 * r.x, 1e3 * r.y, 1e3 * r.z);
  const double scale = feeling.law.cue.scale;  // 0 while no button is held
  text += fmt::format("force     {:8.3f} {:8.3f} {:8.3f} N, s = {:.3g}{}\n", f.x, f.y, f.z, scale,
                      scale > 0.0 ? fmt::format(" (1 N here is {:.2g} N)", 1.0 / scale) : "");
  text += fmt::format("rate      {:8.1f} Hz\nport      {:8.4f} J\n", report.rate_hz, report.port_j);
  text += fmt::format("limited by {}\n", limitWords(report));
  if (report.falls > 0)
    text += fmt::format("fell to 0 N {} times, at last because {}\n", report.falls, toString(report.fall));
  return news.empty() ? text : text + news + '\n';
}

/// Shows a device while its button is held: the law's force sets in over five seconds.
int runLive(const ForceOptions& options, Feeling& feeling) {
  using Clock = std::chrono::steady_clock;
  constexpr double kSetsIn_s = 5.0, kDraw_m = 0.1, kDraw_rad_s = 1.0;
  const EndOnSignals ends;
  const Clock::time_point start = Clock::now();
  const std::unique_ptr<ForceChannel> channel = createForce(feeling.setup, feeling.axes, start);
  LiveDisplay display;
  std::string news;
  double shown_s = 0.0, pressed_s = 0.0;
  const double scale = feeling.law.cue.scale;
  for (bool isOver = false; !isOver;) {
    constexpr std::timespec kPause{0, 10'000'000};
    ::nanosleep(&kPause, nullptr);
    const double now_s = std::chrono::duration<double>(Clock::now() - start).count();
    const ForceReport& report = channel->report();
    if (!report.active) pressed_s = now_s;
    feeling.law.cue.scale = scale * std::clamp((now_s - pressed_s) / kSetsIn_s, 0.0, 1.0);
    feeling.law.posted_s = channel->now_s(now_s);
    if (feeling.setup.kind == ForceKind::simulated) {  // it presses and draws by itself
      feeling.law.held = true;
      feeling.law.wish_m = -0.5 * kDraw_m * (1.0 - std::cos(kDraw_rad_s * now_s)) * feeling.axes.right;
    }
    channel->post(feeling.law);
    for (const std::string& line : channel->takeNews()) news = line;
    isOver = EndOnSignals::isAsked() || (options.seconds && now_s >= *options.seconds);
    if (!isOver && now_s < shown_s + display.period_s()) continue;
    display.show(tableOf(feeling, channel->report(), news), now_s);
    shown_s = now_s;
  }
  return 0;
}

}  // namespace

int runForce(const ForceOptions& options) {
  Feeling feeling = feelingOf(options);
  return options.positions || options.pushes ? runRecorded(options, feeling) : runLive(options, feeling);
}

void addForce(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("force", "Try the force device of a rig, or its loop on a recorded hand");
  auto options = std::make_shared<ForceOptions>();
  options->scenario = configFolder() / "scenarios/three-pucks.toml";
  command->add_option("RIG", options->rig, "Rig file with a [hand.force]")
      ->required()
      ->transform(shipped({"rigs"}));
  command
      ->add_option(
          "--scenario", options->scenario,
          "Scenario whose pucks the cue strikes: its first puck is felt, and its heaviest one sets the scale")
      ->transform(shipped({"scenarios"}))
      ->capture_default_str();
  CLI::Option* positions = command->add_option(
      "--positions", options->positions,
      "Run the loop on a hand that is where this trace says (time_s,x_m,y_m,z_m,pressed)");
  CLI::Option* pushes = command->add_option(
      "--pushes", options->pushes,
      "Run it with the simulated device in a hand that wants to be where this trace says");
  positions->excludes(pushes)->type_name("TRACE");
  pushes->type_name("TRACE");
  command
      ->add_option(
          "--csv", options->csv,
          "Write place, force, scale, energies and the stroke's speed, a row a tick; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
  CLI::Option* hold =
      command->add_option("--hold", options->hold, "Hold the puck of this name in the place of the cue")
          ->type_name("NAME");
  command->add_option("--at-speed", options->atSpeed, "Speed at which the held puck flies, in units of c")
      ->type_name("B")
      ->capture_default_str()
      ->needs(hold)
      ->check(numberIn({.least = 0.0, .most = 0.995}, "a speed from 0 to 0.995"));
  command->add_option("--seconds", options->seconds, "End after this many seconds; by default, Ctrl-C ends")
      ->type_name("T")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  command->footer(
      "Without a trace it shows the device: hold its button, and the force sets in slowly.\n"
      "energy_j is what the draw holds, stored_j what the hand has put into the device, scale is s: 1 N in "
      "the "
      "hand is\n"
      "1/s N at the cue. With --hold there are proxy_beta, the speed of the held puck, and shown_kg, the "
      "mass that it "
      "showed\n"
      "in the last second.\n"
      "Example:\n  carom force my-room --positions draw.csv --csv force.csv");
  command->callback([options, &status] { status = runForce(*options); });
}

}  // namespace carom
