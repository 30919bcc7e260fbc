// What a spacetime diagram holds: flashes with their names and light, and an observer who never goes back in
// time.
#include "app/report/spacetime_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/report/chart_file.h"
#include "app/temporary_folder.h"
#include "cave/mesh_input/vtk_messages.h"
#include "engine/billiard/billiard.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

DiagramSubject subjectOfLesson(const char* name) {
  const Scenario scenario = readScenario(std::string(CAROM_CONFIG_DIR "/scenarios/") + name + ".toml");
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(5.0);
  DiagramSubject subject = subjectOf(scenario);
  subject.lines.assign(billiard.worldLines().begin(), billiard.worldLines().end());
  subject.events.assign(billiard.events().begin(), billiard.events().end());
  for (const double t_s : {0.0, 5.0}) subject.mine.push_back({t_s, Vec3(0.0, -1.7, 1.0)});
  return subject;
}

glm::dvec2 markOf(const Chart& chart, const std::string& name) {
  const auto found = std::find_if(chart.lines.begin(), chart.lines.end(),
                                  [&](const ChartLine& line) { return line.name == name; });
  if (found == chart.lines.end() || found->points.size() != 1) {
    ADD_FAILURE() << "no mark " << name;
    return {};
  }
  return found->points.front();
}

// In "Which one can be the cause?" the light of A reaches B's place before B flashes, and C's place after C.
TEST(SpacetimeChart, NamesTheFlashesOfALesson) {
  const DiagramSubject subject = subjectOfLesson("cause");
  const Chart chart = spacetimeChart(subject, {});
  const glm::dvec2 a = markOf(chart, "flash: A"), b = markOf(chart, "flash: B") - a,
                   c = markOf(chart, "flash: C") - a;
  EXPECT_NEAR(a.x, -1.2, 1e-12);
  EXPECT_NEAR(a.y, 0.9 * subject.c_m_s, 1e-12);
  EXPECT_GT(b.y, std::abs(b.x)) << "B is in A's light cone";
  EXPECT_GT(c.y, 0.0);
  EXPECT_LT(c.y, std::abs(c.x)) << "C is elsewhere";
  const auto light = std::count_if(chart.lines.begin(), chart.lines.end(), [&](const ChartLine& line) {
    return line.points.size() == 3 && line.points[1] == a;
  });
  EXPECT_EQ(light, 1);
}

// The near end of a pushed rod leaves at once, the far one later than light; both are drawn beside the
// centre.
TEST(SpacetimeChart, ShowsBothSidesOfWhatIsSoft) {
  DiagramSubject subject = subjectOfLesson("solid");
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/solid.toml");
  const std::size_t before = spacetimeChart(subject, {}).lines.size();
  subject.softSides = softSides(scenario.billiard, 'x', 2.2);
  ASSERT_EQ(subject.softSides.size(), 2u);
  const auto leaves_s = [](const std::vector<Event>& line) {
    const auto moved = [&](const Event& event) { return event.r_m.x - line.front().r_m.x > 1e-3; };
    return std::find_if(line.begin(), line.end(), moved)->t_s;
  };
  for (const SoftSides& rod : subject.softSides) {
    const double length_m = rod.lines[1].front().r_m.x - rod.lines[0].front().r_m.x;
    EXPECT_NEAR(length_m, 0.8, 1e-12);
    EXPECT_NEAR(leaves_s(rod.lines[0]), 1.0, 0.02);
    EXPECT_GT(leaves_s(rod.lines[1]), 1.0 + length_m / subject.c_m_s);
  }
  EXPECT_EQ(spacetimeChart(subject, {}).lines.size(), before + 4);
}

TEST(SpacetimeChart, AnObserverWhoIsPutElsewhereBeginsAnew) {
  DiagramSubject subject;
  subject.c_m_s = 1.42;
  const auto at = [](double t_s, double x_m) { return Event{t_s, Vec3(x_m, 0.0, 0.0)}; };
  continueLine(subject.mine, subject.c_m_s, at(1.0, 0.0));
  continueLine(subject.mine, subject.c_m_s, at(1.5, 0.7));
  continueLine(subject.mine, subject.c_m_s,
               at(1.5, 0.9));  // time stands still while a person walks round what they see
  EXPECT_EQ(subject.mine.size(), 2U);
  continueLine(subject.mine, subject.c_m_s, at(0.3, 0.0));  // the lesson begins again
  ASSERT_EQ(subject.mine.size(), 1U);
  EXPECT_EQ(subject.mine.front().t_s, 0.3);
  continueLine(subject.mine, subject.c_m_s, at(0.4, 0.1));
  continueLine(subject.mine, subject.c_m_s, at(1.0, -0.9));  // with another velocity, from another place
  ASSERT_EQ(subject.mine.size(), 1U);
  EXPECT_EQ(subject.mine.front().t_s, 1.0);
}

TEST(SpacetimeChart, HasTheWorldLineAndTheNowOfEverybodyInTheRoom) {
  DiagramSubject subject;
  subject.c_m_s = 1.42;
  FrameRecord record;
  record.viewerCount = 2;
  const std::vector<std::string> names{"anna", "ben"};
  for (const double t_s : {0.0, 1.0, 2.0}) {
    for (std::size_t viewer = 0; viewer < 2; ++viewer) {
      record.viewers[viewer].observer.middle.observation = {t_s, Vec3(static_cast<double>(viewer), 0.0, 0.0)};
      record.viewers[viewer].observer.headFromBoard = Lorentz(1.42);
    }
    follow(subject, record, names);
  }
  ASSERT_EQ(subject.others.size(), 1U);
  EXPECT_EQ(subject.others[0].name, "ben");
  EXPECT_EQ(subject.others[0].line.size(), 3U);
  const Chart chart = spacetimeChart(subject, {});
  const auto named = [&](const std::string& name) {
    return std::count_if(chart.lines.begin(), chart.lines.end(),
                         [&](const ChartLine& line) { return line.name == name; });
  };
  EXPECT_EQ(named("me"), 1);
  EXPECT_EQ(named("ben"), 1);
  EXPECT_EQ(named("ben: line of simultaneity"), 1);
  EXPECT_EQ(named("my line of simultaneity"), 1);
}

TEST(SpacetimeChart, LinesOfOnePointAndOfNoneAreWrittenWithoutAComplaint) {
  const test::TemporaryFolder folder;
  const test::LogLines lines;
  sendVtkMessagesToLog();
  Chart chart;
  chart.title = "one frame";
  for (const std::size_t points : {0U, 1U, 2U}) {
    ChartLine& line = chart.lines.emplace_back();
    line.name = "line" + std::to_string(points);
    for (std::size_t i = 0; i < points; ++i) line.points.emplace_back(0.1 * static_cast<double>(i), 0.5);
  }
  testing::internal::CaptureStderr();
  writeChart(chart, folder / "chart.svg");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(lines.said().empty()) << lines.said().front();
  EXPECT_NE(test::contentOf(folder / "chart.svg").find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace carom
