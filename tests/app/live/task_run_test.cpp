// Every shipped task: a script that solves it, one that fails it, and what the session file has of both.
#include "app/live/task_run.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "app/journal/journal.h"
#include "app/operator/visitor_choices.h"
#include "app/play/game.h"
#include "app/scenario/starting_histories.h"
#include "app/temporary_folder.h"
#include "cave/texts/texts.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

/// A stroke as somebody makes it who stands where a visitor does: at the table's middle, 0.85 m above the
/// cloth.
struct Shot {
  std::size_t puck = 0;
  double azimuth_deg = 0.0;  ///< of its direction, anticlockwise from +x
  double u = 0.0;            ///< γβ for a puck at rest
};

/// One task of the shipped ones, played frame by frame by a person at rest.
class Played {
 public:
  Played(const Scenario& scenario, std::size_t task) : scenario_(scenario) {
    settings_.task = task;
    settings_.playing = fileOfGame(kTasks);
  }

  /// Plays on until something of the task is decided, and returns what it is.
  std::string play(const Shot& shot) {
    constexpr int kStrikes = 30;  // frame
    for (int frame = 0; frame < 60 * 30; ++frame) {
      const double t_s = frame / 60.0;
      const Event eye{t_s, {0.0, -1.6, 0.85}};
      const EyeView middle{eye, Vec3(0.0), Vec3(0.0)};
      decision_.beginFrame();
      FrameRecord& record = decision_.frame.record = {};
      record.display_s = t_s;
      record.viewers[0].observer = {Lorentz(scenario_.billiard.lightSpeed_m_s), middle, middle, middle, t_s};
      record.boardFromRoom = Lorentz(scenario_.billiard.lightSpeed_m_s);
      if (frame == kStrikes) strike(shot, eye);
      tasks_.look(settings_, world_, announcements_, decision_);
      game_.advance(t_s, decision_.frame);
      applyFrame(decision_.frame, world_);
      for (const TaskNews& news : decision_.tasks) told_.push_back(news);
      if (!told_.empty() && told_.back().event != "begun") return told_.back().event;
    }
    return "nothing";
  }
  const std::vector<TaskNews>& told() const { return told_; }
  const Decision& decision() const { return decision_; }

 private:
  void strike(const Shot& shot, const Event& eye) {
    const Puck& puck = scenario_.billiard.pucks[shot.puck];
    const double azimuth_rad = shot.azimuth_deg * std::numbers::pi / 180.0;
    const Vec2 along(std::cos(azimuth_rad), std::sin(azimuth_rad));
    const Stroke stroke{shot.puck, eye.t_s, eye.r_m - Vec3(0.0, 0.0, 0.2),
                        shot.u * puck.mass_kg * scenario_.billiard.lightSpeed_m_s * along, 0.0};
    tasks_.struck(0, stroke, game_.strike(stroke).t_s);
  }

  const Scenario& scenario_;
  const Rig rig_ = readRig(CAROM_CONFIG_DIR "/rigs/desk.toml");
  Announcements announcements_{rig_, scenario_, {}};
  Game game_{scenario_};
  World world_{startingHistories(scenario_), {}};
  TaskRun tasks_{scenario_};
  OperatorSettings settings_;
  Decision decision_;
  std::vector<TaskNews> told_;
};

struct Script {
  const char* task;
  Shot solves, fails;
};
const std::vector<Script> kScripts{
    {"The first hit", {0, 151.0, 0.3}, {0, 270.0, 0.3}},
    {"Where it will be", {0, 33.0, 0.3}, {0, 151.0, 0.1}},
    {"Carom", {0, 9.0, 0.3}, {0, 151.0, 0.1}},
    {"What is measured", {0, 36.0, 0.3}, {0, 151.0, 0.1}},
    {"Both at once", {0, 135.0, 0.3}, {0, 151.0, 0.3}},
    {"Faster than light", {0, 52.0, 0.6}, {0, 90.0, 0.4}},
    {"Slow clock", {0, 4.0, 0.3}, {0, 270.0, 0.05}},
    // Blue is farther away, so it has to be hit first. At 136° that is right for the table, but not for the
    // person.
    {"At once for you", {0, 134.0, 0.5}, {0, 136.0, 0.5}},
    {"Two cushions", {0, 54.0, 0.3}, {0, 151.0, 0.1}},
    {"Three cushions", {0, 54.0, 0.3}, {0, 28.0, 0.1}},
};

class ShippedTasks : public testing::Test {
 protected:
  const test::LogLines log_;
  const Scenario scenario_ = readScenario(fileOfGame(kTasks));
};

TEST_F(ShippedTasks, EachIsSolvedByAScriptAndFailedByOne) {
  ASSERT_EQ(scenario_.tasks.size(), 10U);
  ASSERT_EQ(kScripts.size(), scenario_.tasks.size());
  for (std::size_t i = 0; i < kScripts.size(); ++i) {
    const auto& [name, solves, fails] = kScripts[i];
    SCOPED_TRACE(name);
    EXPECT_EQ(scenario_.tasks[i].name, name);
    Played solved(scenario_, i);
    EXPECT_EQ(solved.play(solves), "solved");
    const double energy_j = 0.2 * 1.42 * 1.42 * (std::hypot(1.0, solves.u) - 1.0);
    ASSERT_EQ(solved.told().size(), 2U);
    EXPECT_NEAR(solved.told().back().energy_j, energy_j, 1e-12);
    EXPECT_EQ(solved.told().back().stars, 3) << energy_j << " J, and there are few better ways";
    const auto* const best = std::get_if<KeepTaskBest>(&solved.decision().commands.back());
    ASSERT_NE(best, nullptr);
    EXPECT_EQ(best->task, i);
    Played failed(scenario_, i);
    EXPECT_EQ(failed.play(fails), "failed");
    EXPECT_EQ(failed.told().back().stars, 0);
  }
}

TEST_F(ShippedTasks, AStrokeWithoutStrengthSolvesNothing) {
  for (std::size_t i = 0; i < scenario_.tasks.size(); ++i) {
    Played idle(scenario_, i);
    EXPECT_EQ(idle.play({0, 0.0, 0.0}), "failed") << "it moves nothing";
  }
}

TEST_F(ShippedTasks, TheSessionFileHasThem) {
  const test::TemporaryFolder folder;
  const auto file = folder / "tasks.db";
  SessionFacts facts{"carom", "room.toml", "tasks.toml", "", "", 1.42};
  facts.viewers = {"anna"};
  {
    Journal journal(file, facts, false);
    for (const Shot& shot : {kScripts[0].solves, kScripts[0].fails}) {
      Played played(scenario_, 0);
      played.play(shot);
      for (const TaskNews& news : played.told()) journal.addTask(7, news);
    }
  }
  SQLite::Database database(file.string());
  SQLite::Statement rows(database, "SELECT frame, task, viewer, event, stars, energy_j FROM task");
  std::vector<std::string> events;
  while (rows.executeStep()) {
    EXPECT_EQ(rows.getColumn(0).getInt(), 7);
    EXPECT_EQ(rows.getColumn(1).getString(), "The first hit");
    EXPECT_EQ(rows.getColumn(2).getString(), "anna");
    events.push_back(rows.getColumn(3).getString());
    EXPECT_EQ(rows.getColumn(4).getInt(), events.back() == "solved" ? 3 : 0);
    EXPECT_EQ(rows.getColumn(5).getDouble() > 0.0, events.back() != "begun");
  }
  EXPECT_EQ(events, (std::vector<std::string>{"begun", "solved", "begun", "failed"}));
}

TEST(Stars, AreByTheEnergySpent) {
  Task task;
  task.stars_j = {0.1, 0.3};
  EXPECT_EQ(starsFor(task, 0.1), 3);
  EXPECT_EQ(starsFor(task, 0.11), 2);
  EXPECT_EQ(starsFor(task, 0.3), 2);
  EXPECT_EQ(starsFor(task, 0.31), 1);
}

}  // namespace
}  // namespace carom
