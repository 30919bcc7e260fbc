#include "app/output_commands/export.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>

#include "app/commands/session_options.h"
#include "app/journal/session_file.h"
#include "app/output_commands/export_spacetime.h"
#include "app/play/game.h"
#include "app/replay/recorded_source.h"
#include "app/replay/replay_visitor_source.h"
#include "app/replay/soft_replay_source.h"
#include "app/report/sculpture_file.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/scenario/starting_histories.h"
#include "app/stage/scenario_scene.h"
#include "app/tables/csv_table.h"
#include "app/tools/option_values.h"
#include "cave/frame/pacer.h"
#include "engine/light/point_emission.h"
#include "engine/linked/promise.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

/// An output folder that appears complete, by `commit`, or not at all.
class WholeFolder {
 public:
  explicit WholeFolder(const std::filesystem::path& folder) : folder_(folder.lexically_normal()) {
    if (!folder_.has_filename()) folder_ = folder_.parent_path();
    std::error_code failed;
    if (std::filesystem::exists(folder_, failed) && !std::filesystem::is_empty(folder_, failed)) {
      throw std::runtime_error(fmt::format(
          "--paraview {}: it is there already, expected a new folder or an empty one", folder.string()));
    }
    part_ = folder_;
    part_ += fmt::format(".part-{}", ::getpid());
    std::filesystem::create_directories(part_, failed);
    if (failed) fail(failed.message());
  }
  ~WholeFolder() {
    std::error_code ignored;
    if (!part_.empty()) std::filesystem::remove_all(part_, ignored);
  }
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::ofstream out(part_ / name, std::ios::binary);
    out << text;
    out.close();
    if (!out) fail(name + " cannot be written");
  }
  void commit() {
    std::error_code failed;
    std::filesystem::rename(part_, folder_, failed);
    if (failed) fail(failed.message());
    part_.clear();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(
        fmt::format("--paraview {}: {}, expected a folder that can be written", folder_.string(), what));
  }
  std::filesystem::path folder_, part_;
};

/// The session that is exported.
struct Recorded {
  Recorded(const std::filesystem::path& file, std::optional<std::size_t> number)
      : session(file, number),
        rig(readRig(session.facts().rig, session.facts().rigText)),
        scenario(session.scenario()),
        game(wholeGame(session, startingHistories(scenario))) {
    sayGame(session, scenario.title);
    if (!session.frames())
      throw std::runtime_error(
          fmt::format("session file {}: it ended before its first frame", file.string()));
    for (const Puck& puck : scenario.billiard.pucks) names.push_back(puck.name);
    for (const ScriptedBody& body : scenario.bodies) names.push_back(body.name);
    for (std::size_t body = 1; body <= names.size(); ++body)
      centres.emplace_back(game.world.histories[body], Vec3(0.0));
  }

  SessionFile session;
  Rig rig;
  Scenario scenario;
  RecordedGame game;
  std::vector<std::string> names;      ///< of bodies 1, 2, …
  std::vector<PointEmission> centres;  ///< of the same bodies
};

using TakeFrame = std::function<void(const SeenFrame&)>;

void eachFrameSeen(Recorded& recorded, const std::string& as, const TakeFrame& take) {
  const std::size_t viewer = as.empty() ? 0 : recorded.session.viewerNamed(as);
  recorded.session.goTo(0);
  for (FrameState frame; recorded.session.next(frame);) take({frame.record, viewer});
}

void eachFrameOf(const std::filesystem::path& observer, const Recorded& recorded, const TakeFrame& take) {
  SimulatedClock clock;
  ReplayVisitorSource source(recorded.rig, recorded.scenario,
                             {.trace = observer, .beta = {}, .mayStay = false}, recorded.game,
                             std::chrono::steady_clock::now());
  Pacer pacer(clock, recorded.rig.display_hz, recorded.rig.displayLatency_s);
  OperatorSettings settings;
  Decision decision;
  while (!decision.frame.record.last) {
    source.next(pacer.next(), {}, settings, decision);
    take(decision.frame.record);
    pacer.awaitTick(0.0);
    pacer.swapped();
  }
}

/// The head of a frame in the form of the arguments of `carom observe`.
struct Observation {
  explicit Observation(const ObserverView& observer)
      : event(observer.middle.observation),
        beta(betaFromU(observer.headFromBoard.inverse().u())),
        headFromBoard(Lorentz::boost(uFromBeta(beta), observer.headFromBoard.lightSpeed_m_s()).inverse()) {}

  Event event;
  Vec3 beta;
  Lorentz headFromBoard;  ///< without a rotation
};

/// The light that a frame's eye receives from one body.
struct SeenLight {
  Event emission;
  Vec3 seen_m;  ///< from the eye, in the head's frame
  double doppler = 1.0;
  double properTime_s = 0.0;  ///< of the body
};

struct SeenRow {
  const SeenFrame& frame;
  const Observation& eye;
  std::string body;
  std::optional<SeenLight> light;  ///< none if it has not arrived
};

/// Returns the value of a column that is empty while the light has not arrived.
template <typename Value>
auto ofLight(const Value& value) {
  return ifThere([](const SeenRow& row) -> const std::optional<SeenLight>& { return row.light; }, value);
}

const std::vector<CsvColumn<SeenRow>>& columns() {
  static const std::vector<CsvColumn<SeenRow>> kColumns{
      {"frame", [](const SeenRow& row) { return row.frame.record.number; }},
      {"display_s", [](const SeenRow& row) { return row.frame.record.display_s; }},
      {"proper_time_s", [](const SeenRow& row) { return row.frame.self.observer.properTime_s; }},
      {"t_s", [](const SeenRow& row) { return row.eye.event.t_s; }},
      {"x_m", [](const SeenRow& row) { return row.eye.event.r_m.x; }},
      {"y_m", [](const SeenRow& row) { return row.eye.event.r_m.y; }},
      {"z_m", [](const SeenRow& row) { return row.eye.event.r_m.z; }},
      {"beta_x", [](const SeenRow& row) { return row.eye.beta.x; }},
      {"beta_y", [](const SeenRow& row) { return row.eye.beta.y; }},
      {"beta_z", [](const SeenRow& row) { return row.eye.beta.z; }},
      {"body", [](const SeenRow& row) { return row.body; }},
      {"status", [](const SeenRow& row) { return row.light ? "seen" : "unseen"; }},
      {"emission_t_s", ofLight([](const SeenLight& light) { return light.emission.t_s; })},
      {"emission_x_m", ofLight([](const SeenLight& light) { return light.emission.r_m.x; })},
      {"emission_y_m", ofLight([](const SeenLight& light) { return light.emission.r_m.y; })},
      {"emission_z_m", ofLight([](const SeenLight& light) { return light.emission.r_m.z; })},
      {"seen_x_m", ofLight([](const SeenLight& light) { return light.seen_m.x; })},
      {"seen_y_m", ofLight([](const SeenLight& light) { return light.seen_m.y; })},
      {"seen_z_m", ofLight([](const SeenLight& light) { return light.seen_m.z; })},
      {"distance_m", ofLight([](const SeenLight& light) { return glm::length(light.seen_m); })},
      {"doppler", ofLight([](const SeenLight& light) { return light.doppler; })},
      {"body_proper_time_s", ofLight([](const SeenLight& light) { return light.properTime_s; })}};
  return kColumns;
}

/// Returns what the eye sees of the head of a person of another room.
std::optional<SeenLight> lightOf(const ToldPath& path, const Observation& eye, double c_m_s) {
  const auto person = path.at([&](const Event& event) { return afterLightOf_s(event, eye.event, c_m_s); });
  if (!person) return std::nullopt;
  const Displacement fromEye = person->head - eye.event;
  return SeenLight{person->head, (eye.headFromBoard * fromEye).dr_m,
                   dopplerFactor(fromEye, person->u, eye.headFromBoard.inverse().u()), person->properTime_s};
}

std::string rowsOf(const Recorded& recorded, const SeenFrame& frame, const Observation& eye) {
  std::string csv;
  const auto add = [&](const std::string& body, const std::optional<SeenLight>& light) {
    csv += csvLine<SeenRow>(columns(), {frame, eye, body, light});
  };
  for (std::size_t i = 0; i < recorded.names.size(); ++i) {
    std::optional<SeenLight> light;
    if (const auto seen = recorded.centres[i].seenAt(eye.event, eye.headFromBoard))
      light = {seen->event, seen->seen.dr_m, seen->doppler, seen->properTime_s};
    add(recorded.names[i], light);
  }
  for (const ToldPath& path : recorded.game.world.people) {
    if (path.moments().empty()) {
      add("", {});
    } else {
      add(std::string(path.moments().front().nameText()) + "_afar",
          lightOf(path, eye, recorded.scenario.billiard.lightSpeed_m_s));
    }
  }
  return csv;
}

/// Writes the files of a ParaView series.
class Series {
 public:
  Series(const std::filesystem::path& folder, const Recorded& recorded)
      : folder_(folder),
        scene_(sceneOf(recorded.scenario, {})),
        bodies_(seenBodies(
            recorded.scenario,
            std::span(recorded.game.world.histories).subspan(1, recorded.scenario.billiard.pucks.size()))) {
    if (!hasSoftPucks(recorded.scenario)) return;
    game_.emplace(recorded.scenario, recorded.session.strokes(recorded.scenario.billiard.pucks));
    world_.histories = startingHistories(recorded.scenario);
  }

  void add(const SeenFrame& seen, const Observation& eye) {
    const FrameRecord& frame = seen.record;
    if (game_) playTo(eye.event.t_s, seen.self.observer);
    const std::string name = fmt::format("seen_{:06}.vtp", frame.number);
    folder_.write(name, vtpText(seenMesh(scene_, bodies_, eye.event, eye.headFromBoard)));
    index_ +=
        fmt::format("    <DataSet timestep=\"{:.17g}\" part=\"0\" file=\"{}\"/>\n", frame.display_s, name);
  }
  void commit() {
    folder_.write("seen.pvd",
                  "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" +
                      index_ + "  </Collection>\n</VTKFile>\n");
    folder_.commit();
  }

 private:
  /// Plays the soft pucks on: their rows are not in the session file (app/replay/soft_replay_source.h).
  void playTo(double t_s, const ObserverView& observer) {
    game_->advance(t_s, played_);
    game_->forget(world_, {&observer, 1}, played_);
    applyFrame(played_, world_);
    for (std::size_t body = 0; body < std::min(bodies_.size(), world_.soft.size()); ++body)
      bodies_[body].rows = world_.soft[body].rows.rowCount() > 0 ? &world_.soft[body].rows : nullptr;
  }

  WholeFolder folder_;
  Scene scene_;
  std::vector<SeenBody> bodies_;
  std::optional<Game> game_;  // with soft pucks
  FrameState played_;
  World world_;
  std::string index_;
};

/// Prints the progress once per second.
class Progress {
 public:
  void at(std::uint64_t frame) {
    const auto now = std::chrono::steady_clock::now();
    if (now - said_ < std::chrono::seconds(1)) return;
    said_ = now;
    log::note(fmt::format("frame {}", frame));
  }

 private:
  std::chrono::steady_clock::time_point said_ = std::chrono::steady_clock::now();
};

}  // namespace

int runExport(const ExportOptions& options) {
  Recorded recorded(options.session, options.game);
  std::optional<WholeFile> csv;
  std::optional<Series> series;
  if (options.csv) csv.emplace(*options.csv).add(csvHead<SeenRow>(columns()));
  if (options.paraview) {
    openMeshes(recorded.scenario);
    series.emplace(*options.paraview, recorded);
  }
  std::uint64_t frames = 0;
  Progress progress;
  const auto take = [&](const SeenFrame& frame) {
    if (frame.record.number % options.every != 0) return;
    const Observation eye(frame.self.observer);
    if (csv) csv->add(rowsOf(recorded, frame, eye));
    if (series) series->add(frame, eye);
    ++frames;
    progress.at(frame.record.number);
  };
  if (options.observer) {
    eachFrameOf(*options.observer, recorded, take);
  } else {
    eachFrameSeen(recorded, options.as, take);
  }
  if (series) series->commit();
  if (csv) csv->commit();
  log::note(fmt::format("{} frame{} exported.", frames, frames == 1 ? "" : "s"));
  if (options.paraview)
    log::note(fmt::format("ParaView opens {}.", (*options.paraview / "seen.pvd").string()));
  return 0;
}

namespace {

/// What the command line says of a model of spacetime.
struct ModelLine {
  ExportSpacetimeOptions options;
  std::vector<double> velocity{0.0, 0.0, 0.0};
};

std::shared_ptr<ModelLine> addModelOptions(CLI::App& command) {
  auto line = std::make_shared<ModelLine>();
  ExportSpacetimeOptions* model = &line->options;
  CLI::Option* out =
      command
          .add_option("--spacetime", model->out,
                      "Write the game as a body in spacetime, time upwards and light at 45 degrees: .glb for "
                      "Blender or the web, .stl or .3mf for a printer")
          ->type_name("FILE")
          ->check([](const std::string& name) {
            return isSculptureFile(name) ? std::string() : "is no kind of model, expected .glb, .stl or .3mf";
          });
  const auto add = [&](const char* name, auto& value, const char* about, const char* type) {
    return command.add_option(name, value, about)->type_name(type)->needs(out);
  };
  add("--from", model->from_s, "Board time at which it begins; by default 10 s before its end", "S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  add("--until", model->until_s,
      "Board time at which it ends; by default the end of the session, or 10 s of a scenario", "S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  add("--velocity", line->velocity, "Velocity v/c on the board of the frame in which it is shown", "BX BY BZ")
      ->expected(3)
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  add("--size", model->size_m, "Its longest side, metres; by default 0.15", "M")
      ->check(numberIn({.least = 0.01, .most = 10.0}, "a length from 0.01 to 10 m"));
  return line;
}

/// Returns the options of the model. Throws CLI::ValidationError at a velocity that is not below that of
/// light.
ExportSpacetimeOptions modelOf(const ModelLine& line, const ExportOptions& options) {
  ExportSpacetimeOptions model = line.options;
  model.source = options.session;
  model.game = options.game;
  model.beta = toVec3(line.velocity);
  if (!(glm::dot(model.beta, model.beta) < 1.0))
    throw CLI::ValidationError("--velocity", "is not below the speed of light, expected a magnitude under 1");
  return model;
}

}  // namespace

void addExport(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "export", "Write what was seen in a session as numbers or meshes, or its spacetime as a model");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("SOURCE", options->session, "Session file; with --spacetime also a scenario")
      ->required()
      ->transform(shipped({"scenarios"}));
  addGame(*command, options->game);
  command
      ->add_option("--observer", options->observer,
                   "Trace of another observer's head, in the room: what they see of the same game")
      ->type_name("TRACE")
      ->transform(shipped({"traces"}));
  command
      ->add_option("--as", options->as,
                   "Of several who shared the room, the one whose view is written; by default the first")
      ->type_name("NAME")
      ->excludes(command->get_option("--observer"));
  command->add_option("--every", options->every, "Only frames whose numbers are multiples of this")
      ->type_name("N")
      ->check(CLI::Range(1L, 1000000000L));
  command
      ->add_option(
          "--csv", options->csv,
          "Write a row for each frame and body to this file: the observer's event, where and when the light "
          "left the body's centre, where it is seen and how it is shifted; - is standard output")
      ->type_name("FILE");
  command
      ->add_option("--paraview", options->paraview,
                   "New folder for the whole seen scene of each frame: ParaView opens DIR/seen.pvd")
      ->type_name("DIR");
  const auto model = addModelOptions(*command);
  command->footer(
      "What was seen is as carom observe has it, for the point between the eyes; board frame, seconds and "
      "metres. A "
      "frame's "
      "meshes take some megabytes: --every 30 is two a second.\n"
      "Examples:\n  carom export game.db --csv seen.csv\n"
      "  carom export game.db --observer walk --every 30 --paraview seen\n"
      "  carom export two-cushions --spacetime two.stl --until 4");
  command->callback([options, model, &status] {
    const bool seen = options->csv || options->paraview;
    if (!seen && model->options.out.empty()) {
      throw CLI::ValidationError("export",
                                 "nothing is to be written, expected --csv, --paraview or --spacetime");
    }
    if (seen) status = runExport(*options);
    if (!model->options.out.empty()) status = runExportSpacetime(modelOf(*model, *options));
  });
}

}  // namespace carom
