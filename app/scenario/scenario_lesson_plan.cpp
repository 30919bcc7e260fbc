#include "app/scenario/scenario_lesson_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "app/toml/toml_values.h"
#include "cave/frame/bodies.h"
#include "cave/record/lesson_words.h"

namespace carom {
namespace {

constexpr double kLongest_s = 60.0;      // of an interval: a lesson is watched again and again
constexpr double kWithoutBoard_m = 1.5;  // half the length of a line on an open plane

LessonInterval readInterval(const TomlTable& lesson) {
  LessonInterval interval;
  interval.from_s = lesson.number("from_s");
  interval.until_s = lesson.number("until_s");
  interval.moment_s = lesson.number("moment_s");
  interval.keepsClocks = lesson.flag("keeps_clocks");
  interval.slowness = lesson.number("slowness");
  // A time that is absent or wrong in itself has been reported, and stands as the largest that there is.
  const auto isTime = [](double time_s) { return time_s < kNotNegative.most; };
  if (!isTime(interval.from_s) || !isTime(interval.until_s) || !isTime(interval.moment_s)) return interval;
  if (!(interval.until_s > interval.from_s && interval.until_s <= interval.from_s + kLongest_s)) {
    lesson.fault("until_s", fmt::format("until_s is {}, expected a time after from_s, above {} and up to {}",
                                        interval.until_s, interval.from_s, interval.from_s + kLongest_s));
  } else if (!(interval.moment_s >= interval.from_s && interval.moment_s <= interval.until_s)) {
    lesson.fault("moment_s", fmt::format("moment_s is {}, which lies outside what the lesson shows, expected "
                                         "a time from {} to {}",
                                         interval.moment_s, interval.from_s, interval.until_s));
  }
  return interval;
}

/// Reports that nothing has this name.
void refuseName(const TomlTable& table, std::string_view key, std::string_view kind, const std::string& name,
                const std::vector<std::string>& names) {
  const auto nearest = nearestWord(name, names);
  table.fault(key,
              fmt::format("there is no {} '{}', expected {}", kind, name,
                          nearest ? fmt::format("'{}'?", *nearest) : fmt::format("the name of a {}", kind)));
}

/// Reads lesson drawings of one kind.
template <typename Read>
auto readAll(const TomlTable& lesson, std::string_view key, const Read& read) {
  const std::size_t most = lesson.declared(key).most;
  std::vector<decltype(read(lesson))> all;
  for (const TomlTable& table : lesson.tables(key, kAnyNumber)) all.push_back(read(table));
  if (all.size() > most)
    lesson.fault(key, fmt::format("a lesson has {} tables [[lesson.{}]] here, expected {} at most",
                                  all.size(), key, most));
  return all;
}

/// Reads the drawings of one lesson.
class PlanReader {
 public:
  PlanReader(const LessonGame& game, const LessonInterval& interval) : game_(game), interval_(interval) {}

  LessonObserver observer(const TomlTable& table) const { return {table.text("name"), readBeta(table)}; }

  Stopwatch stopwatch(const TomlTable& table) const {
    Stopwatch watch;
    watch.name = table.text("name");
    watch.clock = static_cast<StopwatchClock>(table.choice("clock"));
    watch.starts = {interval_.from_s, Vec3(0.0)};
    if (table.has("stands_m")) watch.stands_m = toVec3(table.numbers<3>("stands_m"));
    if (watch.clock == StopwatchClock::seen) watch.seen_m = toVec3(table.numbers<3>("place_m"));
    if (watch.clock == StopwatchClock::seen || watch.clock == StopwatchClock::mine) return watch;
    if (watch.clock == StopwatchClock::frame && table.has("beta")) watch.beta = readBeta(table);
    if (table.has("starts")) watch.starts = flash(table, "starts");
    if (table.has("stops")) watch.stops = flash(table, "stops");
    watch.stopsWhenSeen = table.flag("stops_when_seen");
    return watch;
  }

  TickCounter counter(const TomlTable& table) const {
    TickCounter counter;
    counter.body = body(table);
    const std::string prefix = table.text("flashes");
    for (const Flash& flash : game_.billiard.flashes) {
      if (flash.name.starts_with(prefix)) counter.ticks.push_back(flash.at);
    }
    if (counter.ticks.empty() && !prefix.empty()) refuseName(table, "flashes", "flash", prefix, flashNames());
    return counter;
  }

  Gauge gauge(const TomlTable& table) const {
    return {body(table), static_cast<GaugeQuantity>(table.choice("shows"))};
  }

  LessonLabel label(const TomlTable& table) const {
    constexpr std::size_t kMostLetters = 12;
    LessonLabel label{table.text("text"), toVec3(table.numbers<3>("at_m")), table.flag("explains")};
    const auto letters = std::count_if(label.words.begin(), label.words.end(),
                                       [](char byte) { return (byte & 0xc0) != 0x80; });
    if (static_cast<std::size_t>(letters) > kMostLetters)
      table.fault("text",
                  fmt::format("the label has {} letters, expected at most {}", letters, kMostLetters));
    return label;
  }

  LessonArrow arrow(const TomlTable& table) const {
    LessonArrow arrow;
    arrow.explains = table.flag("explains");
    if (table.has("body") == table.has("at_m"))
      table.fault("body", "an arrow points to a body or to a place, expected either body or at_m");
    if (table.has("body")) arrow.body = body(table);
    if (table.has("at_m")) arrow.at_m = toVec3(table.numbers<3>("at_m"));
    return arrow;
  }

  ClothLine line(const TomlTable& table) const {
    return {toVec3(table.numbers<3>("from_m")), toVec3(table.numbers<3>("to_m"))};
  }

  SimultaneityLine simultaneous(const TomlTable& table) const {
    SimultaneityLine line;
    line.with = flash(table, "with");
    if (table.has("beta")) line.beta = readBeta(table);
    const double end_m = game_.billiard.board ? 0.5 * game_.billiard.board->length_m : kWithoutBoard_m;
    line.from_m = table.numberOr("from_m", -end_m);
    line.to_m = table.numberOr("to_m", end_m);
    return line;
  }

 private:
  static Vec3 readBeta(const TomlTable& table) {
    const Vec3 beta = toVec3(table.numbers<3>("beta"));
    checkSpeed(table, beta);
    return beta;
  }

  /// Reads the name of a body and returns its number in the scene.
  std::size_t body(const TomlTable& table) const {
    const std::string name = table.text("body");
    const auto found = std::find(game_.bodies.begin(), game_.bodies.end(), name);
    if (found == game_.bodies.end() && !name.empty()) refuseName(table, "body", "body", name, game_.bodies);
    return kFirstPuck + static_cast<std::size_t>(found - game_.bodies.begin());
  }

  std::vector<std::string> flashNames() const {
    std::vector<std::string> names;
    for (const Flash& flash : game_.billiard.flashes) names.push_back(flash.name);
    return names;
  }

  /// Reads the name of a flash and returns its event.
  Event flash(const TomlTable& table, std::string_view key) const {
    const std::string name = table.text(key);
    const auto& flashes = game_.billiard.flashes;
    const auto found =
        std::find_if(flashes.begin(), flashes.end(), [&](const Flash& flash) { return flash.name == name; });
    if (found == flashes.end()) {
      if (!name.empty()) refuseName(table, key, "flash", name, flashNames());
      return {};
    }
    const bool known = interval_.until_s > interval_.from_s;  // otherwise it has been reported
    if (known && found->at.t_s > interval_.until_s)
      table.fault(
          key, fmt::format("the flash '{}' is at {} s, expected one that the lesson shows, up to {} s", name,
                           found->at.t_s, interval_.until_s));
    return found->at;
  }

  const LessonGame& game_;
  LessonInterval interval_;
};

}  // namespace

LessonPlan readLessonPlan(const TomlTable& lesson, const LessonGame& game) {
  LessonPlan plan;
  plan.interval = readInterval(lesson);
  const PlanReader read(game, plan.interval);
  plan.observers = readAll(lesson, "observer", [&](const TomlTable& table) { return read.observer(table); });
  const int most = static_cast<int>(std::max<std::size_t>(plan.observers.size(), 1));
  plan.explainedFor = static_cast<std::size_t>(lesson.integer("explained_for", most) - 1);
  plan.offersSpacetime = lesson.flag("offers_spacetime");
  plan.holds = lesson.flag("hold");
  plan.stopwatches =
      readAll(lesson, "stopwatch", [&](const TomlTable& table) { return read.stopwatch(table); });
  plan.counters = readAll(lesson, "counter", [&](const TomlTable& table) { return read.counter(table); });
  plan.gauges = readAll(lesson, "gauge", [&](const TomlTable& table) { return read.gauge(table); });
  plan.labels = readAll(lesson, "label", [&](const TomlTable& table) { return read.label(table); });
  plan.arrows = readAll(lesson, "arrow", [&](const TomlTable& table) { return read.arrow(table); });
  plan.lines = readAll(lesson, "line", [&](const TomlTable& table) { return read.line(table); });
  plan.simultaneous =
      readAll(lesson, "simultaneous", [&](const TomlTable& table) { return read.simultaneous(table); });
  return plan;
}

}  // namespace carom
