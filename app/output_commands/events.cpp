#include "app/output_commands/events.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "app/commands/session_options.h"
#include "app/journal/session_file.h"
#include "app/scenario/scenario.h"
#include "app/scenario/starting_histories.h"
#include "app/tables/csv_table.h"
#include "app/tables/event_table.h"
#include "app/tools/option_values.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

constexpr double kPlayed_s = 10.0;  // default duration of a scenario

/// The content of the table.
struct EventsSubject {
  std::string title;
  double c_m_s = 1.0;
  std::vector<std::string> pucks, flashes;  // names
  std::vector<GameEvent> events;
  std::vector<std::string> viewers;        // sessions only; then those of another room
  std::vector<std::vector<HeadAt>> heads;  // of each of them
};

EventsSubject subjectWithNames(const Scenario& scenario) {
  EventsSubject subject;
  subject.title = scenario.title;
  subject.c_m_s = scenario.billiard.lightSpeed_m_s;
  for (const Puck& puck : scenario.billiard.pucks) subject.pucks.push_back(puck.name);
  for (const Flash& flash : scenario.billiard.flashes) subject.flashes.push_back(flash.name);
  return subject;
}

void keepUntil(std::vector<GameEvent>& events, double until_s) {
  std::erase_if(events, [until_s](const GameEvent& event) { return !(event.at.t_s <= until_s); });
}

EventsSubject played(const Scenario& scenario, double until_s) {
  EventsSubject subject = subjectWithNames(scenario);
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(until_s);
  subject.events.assign(billiard.events().begin(), billiard.events().end());
  keepUntil(subject.events, until_s);
  return subject;
}

/// Adds the people of another room, as the frames told of them: when they saw it, too.
void addTold(EventsSubject& subject, const std::vector<std::vector<HeadAt>>& told,
             const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < told.size(); ++i) {
    if (told[i].empty()) continue;
    subject.viewers.push_back(names[i] + "_afar");
    subject.heads.push_back(told[i]);
  }
}

/// Returns the final state of the recorded game.
EventsSubject recorded(const EventsOptions& options) {
  SessionFile session(options.source, options.game);
  const Scenario scenario = session.scenario();
  sayGame(session, scenario.title);
  EventsSubject subject = subjectWithNames(scenario);
  subject.viewers = session.facts().viewers;
  subject.heads.resize(subject.viewers.size());
  std::vector<std::vector<HeadAt>> told(kMostViewers);
  std::vector<std::string> toldNames(kMostViewers);
  World world{startingHistories(scenario), {}};
  for (FrameState state; session.next(state);) {
    session.apply(state, world);
    for (const ToldMoment& moment : state.told) {
      if (moment.kind == ToldKind::ends) continue;
      told[moment.person].push_back({state.record.number, moment.head, moment.properTime_s});
      toldNames[moment.person] = moment.nameText();
    }
    for (std::size_t viewer = 0; viewer < subject.viewers.size(); ++viewer) {
      if (viewer >= state.record.viewerCount) break;
      const ObserverView& observer = state.record.viewers[viewer].observer;
      subject.heads[viewer].push_back(
          {state.record.number, observer.middle.observation, observer.properTime_s});
    }
  }
  const std::vector<HeadAt>& head = subject.heads.front();
  if (head.empty())
    throw std::runtime_error(
        fmt::format("session file {}: it ended before its first frame", options.source.string()));
  subject.events = std::move(world.events);
  // A lesson repeats a part of its game, so that its last frame need not be the latest on the board.
  double latest_s = head.front().event.t_s;
  for (const std::vector<HeadAt>& ofOne : subject.heads) {
    for (const HeadAt& at : ofOne) latest_s = std::max(latest_s, at.event.t_s);
  }
  keepUntil(subject.events, options.until_s.value_or(latest_s));
  addTold(subject, told, toldNames);
  return subject;
}

void keepPair(std::vector<GameEvent>& events, const std::pair<std::uint64_t, std::uint64_t>& pair) {
  std::erase_if(events,
                [&](const GameEvent& e) { return e.number != pair.first && e.number != pair.second; });
  if (events.size() == 2) return;
  throw std::runtime_error(fmt::format("--pair {} {}: expected the numbers of two of the events in the table",
                                       pair.first, pair.second));
}

std::string vectorText(const Vec3& v) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

/// A row of the table, the row after it, or null, and when each viewer saw its event.
struct SeenEvent {
  const EventRow& row;
  const EventRow* next;
  std::vector<std::optional<Reception>> seen;
};
using EventColumns = std::vector<CsvColumn<SeenEvent>>;

std::vector<SeenEvent> seenEvents(const EventsSubject& subject, const std::vector<EventRow>& rows) {
  std::vector<SeenEvent> events;
  for (const EventRow& row : rows) {
    events.push_back({row, &row == &rows.back() ? nullptr : &row + 1, {}});
    for (const std::vector<HeadAt>& head : subject.heads)
      events.back().seen.push_back(receptionBy(head, row.event.at, subject.c_m_s));
  }
  return events;
}

/// Adds the columns of an event's time and place; `name` stands before each of their names.
void addPlace(EventColumns& columns, const std::string& name,
              const std::function<const Event&(const EventRow&)>& at) {
  columns.push_back({name + "t_s", [at](const SeenEvent& event) { return at(event.row).t_s; }});
  columns.push_back({name + "x_m", [at](const SeenEvent& event) { return at(event.row).r_m.x; }});
  columns.push_back({name + "y_m", [at](const SeenEvent& event) { return at(event.row).r_m.y; }});
  columns.push_back({name + "z_m", [at](const SeenEvent& event) { return at(event.row).r_m.z; }});
}

/// Adds the columns of the interval to the next row's event.
void addRelation(EventColumns& columns, double c_m_s) {
  const auto ofRelation = [](const auto& value) {
    return ifThere([](const SeenEvent& event) -> const std::optional<Relation>& { return event.row.toNext; },
                   value);
  };
  const auto lengthIf = [&](Separation separation, double unit_m) {
    return ofRelation([separation, unit_m](const Relation& relation) {
      return relation.separation == separation ? std::optional(relation.length_m / unit_m) : std::nullopt;
    });
  };
  const auto beta = [&](int axis) {
    return ofRelation([axis](const Relation& relation) {
      return relation.beta ? std::optional((*relation.beta)[axis]) : std::nullopt;
    });
  };
  columns.insert(
      columns.end(),
      {{"next", ifThere([](const SeenEvent& event) { return event.next; },
                        [](const EventRow& next) { return next.event.number; })},
       {"interval", ofRelation([](const Relation& relation) { return toString(relation.separation); })},
       {"proper_time_s", lengthIf(Separation::timelike, c_m_s)},
       {"distance_m", lengthIf(Separation::spacelike, 1.0)},
       {"beta_x", beta(0)},
       {"beta_y", beta(1)},
       {"beta_z", beta(2)}});
}

/// Adds the columns of when each viewer saw the event, and when its light arrived at each place.
void addReceptions(EventColumns& columns, const EventsSubject& subject, const EventsOptions& options) {
  for (std::size_t viewer = 0; viewer < subject.viewers.size(); ++viewer) {
    const std::string name = viewer == 0 ? "seen" : fmt::format("seen_by_{}", subject.viewers[viewer]);
    const auto ofReception = [viewer](const auto& value) {
      return ifThere(
          [viewer](const SeenEvent& event) -> const std::optional<Reception>& { return event.seen[viewer]; },
          value);
    };
    columns.push_back({name + "_frame", ofReception([](const Reception& seen) { return seen.frame; })});
    columns.push_back({name + "_t_s", ofReception([](const Reception& seen) { return seen.t_s; })});
    columns.push_back(
        {name + "_proper_time_s", ofReception([](const Reception& seen) { return seen.properTime_s; })});
  }
  for (std::size_t i = 0; i < options.places_m.size(); ++i) {
    columns.push_back({fmt::format("place_{}_t_s", i + 1),
                       [c_m_s = subject.c_m_s, place_m = options.places_m[i]](const SeenEvent& event) {
                         return receptionAt(place_m, event.row.event.at, c_m_s).t_s;
                       }});
  }
}

EventColumns columnsOf(const EventsSubject& subject, const EventsOptions& options) {
  const auto ofGame = [](const auto& value) {
    return [value](const SeenEvent& event) { return value(event.row.event); };
  };
  EventColumns columns{
      {"number", ofGame([](const GameEvent& event) { return event.number; })},
      {"kind", ofGame([](const GameEvent& event) { return nameOf(event.kind); })},
      {"who", [](const SeenEvent& event) { return event.row.who; }},
      {"cushion", ofGame([](const GameEvent& event) { return event.cushion ? nameOf(*event.cushion) : ""; })},
      {"heat_j", ofGame([](const GameEvent& event) { return event.heat_j; })},
      {"without_delay", ofGame([](const GameEvent& event) { return event.withoutDelay; })}};
  addPlace(columns, "", [](const EventRow& row) -> const Event& { return row.event.at; });
  columns.push_back({"order", [](const SeenEvent& event) { return event.row.order; }});
  addPlace(columns, "moving_", [](const EventRow& row) -> const Event& { return row.moving; });
  columns.push_back({"moving_order", [](const SeenEvent& event) { return event.row.movingOrder; }});
  addRelation(columns, subject.c_m_s);
  addReceptions(columns, subject, options);
  const auto spin = [&](std::size_t turn) {  // afterwards, in the order of `who`
    return ofGame([turn](const GameEvent& event) {
      return turn < event.turns.size() ? std::optional(event.turns[turn].spinAfter_kg_m2_s) : std::nullopt;
    });
  };
  columns.insert(columns.end(),
                 {{"first_spin_kg_m2_s", spin(0)},
                  {"second_spin_kg_m2_s", spin(1)},
                  {"side_on_side", ofGame([](const GameEvent& event) { return event.sideOnSide; })}});
  return columns;
}

std::string receptionsText(const EventsSubject& subject, const EventRow& row, const EventsOptions& options) {
  std::string text;
  for (std::size_t viewer = 0; viewer < subject.viewers.size(); ++viewer) {
    const auto seen = receptionBy(subject.heads[viewer], row.event.at, subject.c_m_s);
    text += seen ? fmt::format("   {:>6} {:>9.4f} {:>9.4f}", *seen->frame, seen->t_s, *seen->properTime_s)
                 : fmt::format("   {:>6} {:>9} {:>9}", "-", "-", "-");
  }
  for (const Vec3& place_m : options.places_m)
    text += fmt::format("   {:>9.4f}", receptionAt(place_m, row.event.at, subject.c_m_s).t_s);
  return text;
}

std::string pairText(const EventRow& row, const EventRow& next, double c_m_s, bool moves) {
  const Relation& relation = *row.toNext;
  std::string text = fmt::format("  {:>3} to {:>3}   ", row.event.number, next.event.number);
  switch (relation.separation) {
    case Separation::timelike:
      text += fmt::format(
          "timelike: proper time {:.4f} s for a clock that moves from one to the other at v/c = {}",
          relation.length_m / c_m_s, vectorText(*relation.beta));
      break;
    case Separation::lightlike:
      return text + "lightlike: light that leaves one arrives at the other\n";
    case Separation::spacelike:
      text += fmt::format("spacelike: simultaneous, {:.4f} m apart, for an observer moving at v/c = {}",
                          relation.length_m, vectorText(*relation.beta));
      break;
  }
  if (moves && relation.separation == Separation::spacelike) {
    const EventRow& first = row.movingOrder > next.movingOrder ? next : row;
    text += row.movingOrder == next.movingOrder
                ? std::string("; simultaneous in the moving frame")
                : fmt::format("; in the moving frame {} comes first", first.event.number);
  }
  return text + '\n';
}

std::string tableOf(const EventsSubject& subject, const std::vector<EventRow>& rows,
                    const EventsOptions& options) {
  const bool moves = options.movingBeta != Vec3(0.0);
  std::string text = fmt::format("{}, light at {} m/s: {} event{}\n", subject.title, subject.c_m_s,
                                 rows.size(), rows.size() == 1 ? "" : "s");
  if (moves) {
    text += fmt::format(
        "moving frame ('): v/c = {} on the board, its origin the board's\n",
        fmt::format("({}, {}, {})", options.movingBeta.x, options.movingBeta.y, options.movingBeta.z));
  }
  for (std::size_t i = 0; i < options.places_m.size(); ++i)
    text += fmt::format("place {}: at rest at {} m\n", i + 1, vectorText(options.places_m[i]));
  if (rows.empty()) return text;

  text += fmt::format("\n{:>4}  {:<12}  {:<20} {:>7}   {:>5} {:>9} {:>8} {:>8} {:>8}", "n", "what", "who",
                      "cushion", "order", "t s", "x m", "y m", "z m");
  if (moves) {
    text += fmt::format("   {:>6} {:>9} {:>8} {:>8} {:>8}", "order'", "t' s", "x' m", "y' m", "z' m");
  }
  for (const std::string& viewer : subject.viewers) {
    // Of one person it is known who saw it.
    const std::string who = subject.viewers.size() > 1 ? viewer + ":" : "seen:";
    text += fmt::format("   {:>6} {:>9} {:>9}", who, "t s", "proper s");
  }
  for (std::size_t i = 1; i <= options.places_m.size(); ++i)
    text += fmt::format("   {:>9}", fmt::format("place {} s", i));
  text += '\n';
  for (const EventRow& row : rows) {
    const Event &at = row.event.at, &moving = row.moving;
    text += fmt::format("{:>4}  {:<13} {:<20} {:>7}   {:>5} {:>9.4f} {:>8.4f} {:>8.4f} {:>8.4f}",
                        row.event.number,
                        fmt::format("{}{}{}", nameOf(row.event.kind), row.event.withoutDelay ? "*" : "",
                                    row.event.sideOnSide ? "=" : ""),
                        row.who, row.event.cushion ? nameOf(*row.event.cushion) : "", row.order, at.t_s,
                        at.r_m.x, at.r_m.y, at.r_m.z);
    if (moves) {
      text += fmt::format("   {:>6} {:>9.4f} {:>8.4f} {:>8.4f} {:>8.4f}", row.movingOrder, moving.t_s,
                          moving.r_m.x, moving.r_m.y, moving.r_m.z);
    }
    text += receptionsText(subject, row, options) + '\n';
  }
  if (std::any_of(rows.begin(), rows.end(), [](const EventRow& row) { return row.event.withoutDelay; })) {
    text +=
        "* without delay: they were in contact already, and the kick did not wait for a signal from this "
        "event\n";
  }
  if (std::any_of(rows.begin(), rows.end(), [](const EventRow& row) { return row.event.sideOnSide; }))
    text += "= side on side: several corners touched at one time, and this event is in their middle\n";
  if (rows.size() > 1) text += "\neach event and the next:\n";
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    text += pairText(rows[i], rows[i + 1], subject.c_m_s, moves);
  return text;
}

}  // namespace

int runEvents(const EventsOptions& options) {
  const bool isPlayed = isScenario(options.source);
  EventsSubject subject = isPlayed ? played(readScenario(options.source), options.until_s.value_or(kPlayed_s))
                                   : recorded(options);
  if (isPlayed && !options.until_s)
    log::note(
        fmt::format("The scenario was played for {:g} s of board time; --until S plays on.", kPlayed_s));
  if (options.pair) keepPair(subject.events, *options.pair);
  const std::vector<EventRow> rows =
      eventRows(subject.events, subject.pucks, subject.flashes, options.movingBeta, subject.c_m_s);
  WholeFile out(options.csv.value_or("-"));
  out.commit(options.csv ? csvText(columnsOf(subject, options), seenEvents(subject, rows))
                         : tableOf(subject, rows, options));
  return 0;
}

namespace {

/// What the command line says, before it is known to be possible.
struct EventsLine {
  EventsOptions options;
  std::vector<double> velocity{0.0, 0.0, 0.0};
  std::vector<std::tuple<double, double, double>> places;
  std::vector<std::uint64_t> pair;
};

/// Returns the options. Throws CLI::ValidationError at a velocity that is not below that of light or a place
/// that is too far away.
EventsOptions optionsOf(const EventsLine& line) {
  EventsOptions options = line.options;
  options.movingBeta = toVec3(line.velocity);
  if (!(glm::dot(options.movingBeta, options.movingBeta) < 1.0))
    throw CLI::ValidationError("--velocity", "is not below the speed of light, expected a magnitude under 1");
  for (const auto& [x, y, z] : line.places) {
    options.places_m.emplace_back(x, y, z);
    if (!(glm::length(options.places_m.back()) <= kFurthest))
      throw CLI::ValidationError("--place", "is no place, expected numbers between -1e9 and 1e9");
  }
  if (!line.pair.empty()) options.pair = {line.pair[0], line.pair[1]};
  return options;
}

}  // namespace

void addEvents(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("events", "List what happened, in any frame, and what light told of it");
  auto line = std::make_shared<EventsLine>();
  command->add_option("SOURCE", line->options.source, "Session file or scenario")
      ->required()
      ->transform(shipped({"scenarios"}));
  addGame(*command, line->options.game);
  command
      ->add_option("--velocity", line->velocity,
                   "Velocity v/c on the board of another frame, in which the events are listed as well")
      ->expected(3)
      ->type_name("BX BY BZ")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      ->add_option("--until", line->options.until_s,
                   "Board time of the last event; by default 10 s, or the end of a session")
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command
      ->add_option(
          "--place", line->places,
          "Place on the board (m) of an observer at rest: when the light of each event reaches them. May "
          "be given several times")
      ->type_name("X Y Z")
      ->allow_extra_args(false);
  command->add_option("--pair", line->pair, "Compare only the two events with these numbers")
      ->expected(2)
      ->type_name("A B");
  command
      ->add_option(
          "--csv", line->options.csv,
          "Write the events to this file, one row each; - is standard output. By default, a table is "
          "printed")
      ->type_name("FILE");
  command->footer(
      "For a session, the list also tells in which drawn frame and when the light of each event reached the\n"
      "observer's head; where several shared the room, that of each.\n"
      "Examples:\n  carom events game.db --velocity 0.5 0 0\n"
      "  carom events two-cushions --until 2 --velocity 0.5 0 0 --place 0 -1 0.3 --csv events.csv");
  command->callback([line, &status] { status = runEvents(optionsOf(*line)); });
}

}  // namespace carom
