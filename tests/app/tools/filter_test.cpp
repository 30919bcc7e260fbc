// `carom filter`: row for row the head filter of a session, causal, and exact in what it takes and writes.

#include "app/tools/filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "app/program.h"
#include "devices/filter/head_filter.h"
#include "devices/tracker/trace.h"
#include "places.h"

namespace carom {
namespace {

using test::contentOf;
using test::exact;
using test::runCarom;
using test::TemporaryFolder;

const std::string kWalk = CAROM_CONFIG_DIR "/traces/walk.csv";
const std::string kHeader = "time_s,x_m,y_m,z_m,celerity_x_m_s,celerity_y_m_s,celerity_z_m_s,sigma_m_s";

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The rows that `carom filter --csv` makes of a trace.
std::vector<std::string> filtered(const TemporaryFolder& folder, const std::string& trace) {
  const auto result = runCarom(folder, {"filter", trace, "--csv", "-"});
  EXPECT_EQ(result.status, 0) << result.err;
  return linesOf(result.out);
}

TEST(Filter, IsTheFilterOfASession) {
  const TemporaryFolder folder;
  const auto rows = filtered(folder, kWalk);
  const std::vector<TrackerSample> samples = readTrace(kWalk);
  ASSERT_EQ(rows.size(), samples.size() + 1);
  EXPECT_EQ(rows[0], kHeader);
  HeadFilter filter;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    filter.add(samples[i].time_s, samples[i].pose);
    const HeadEstimate head = filter.at(samples[i].time_s);
    std::string expected = exact(samples[i].time_s);
    for (const double value :
         {head.pose.position_m.x, head.pose.position_m.y, head.pose.position_m.z, head.celerity_m_s.x,
          head.celerity_m_s.y, head.celerity_m_s.z, head.sigma_m_s}) {
      EXPECT_TRUE(std::isfinite(value));
      expected += ',' + exact(value);
    }
    ASSERT_EQ(rows[i + 1], expected) << "row " << i;
  }
}

// A row is made of itself and the rows before it: what comes later changes nothing.
TEST(Filter, IsCausal) {
  const TemporaryFolder folder;
  const auto whole = filtered(folder, kWalk);
  const auto lines = linesOf(contentOf(kWalk));
  std::string part;
  for (std::size_t i = 0; i < 400; ++i) part += lines[i] + '\n';
  const auto rows = filtered(folder, folder.file("part.csv", part));
  ASSERT_GT(rows.size(), 300u);
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i], whole[i]) << i;
}

// Positions alone; a gap, a glitch: a row for each row all the same.
TEST(Filter, GivesARowForEachRow) {
  const TemporaryFolder folder;
  std::string trace = "time_s,x_m,y_m,z_m\n";
  int count = 0;
  for (int i = 0; i < 600; ++i) {
    if (i > 200 && i < 260) continue;  // a second is missing
    const double x_m = i == 100 ? 5.0 : 0.01 * std::sin(0.02 * i);
    trace += exact(i / 60.0) + ',' + exact(x_m) + ",1.7,0\n";
    ++count;
  }
  const auto rows = filtered(folder, folder.file("trace.csv", trace));
  ASSERT_EQ(rows.size(), count + 1u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(std::count(rows[i].begin(), rows[i].end(), ','), 7);
    double t_s, x_m;
    ASSERT_EQ(std::sscanf(rows[i].c_str(), "%lf,%lf", &t_s, &x_m), 2);
    EXPECT_LT(std::abs(x_m), 0.02) << rows[i];  // the glitch is no place of the head
  }
}

TEST(Filter, WritesAFileOrASummary) {
  const TemporaryFolder folder;
  const auto file = folder / "out.csv";
  const auto quiet = runCarom(folder, {"filter", kWalk, "--csv", file});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(linesOf(contentOf(file)), filtered(folder, kWalk));
  const auto summary = runCarom(folder, {"filter", kWalk, "--light-speed", "2"});
  EXPECT_EQ(summary.status, 0);
  for (const char* part :
       {"60.0 Hz", "dropouts", "rest noise", "RMS", "lag", "light at 2 m/s", "unfiltered"}) {
    EXPECT_NE(summary.out.find(part), std::string::npos) << part << " in\n" << summary.out;
  }
}

TEST(Filter, ASingleRowIsEnough) {
  const TemporaryFolder folder;
  const auto trace = folder.file("one.csv", "time_s,x_m,y_m,z_m\n3,0,1.7,0\n");
  EXPECT_EQ(filtered(folder, trace).size(), 2u);
  EXPECT_EQ(runCarom(folder, {"filter", trace}).status, 0);
}

TEST(Filter, NamesTheFaultAndWritesNothing) {
  const TemporaryFolder folder;
  const auto trace = folder.file("bad.csv", "time_s,x_m,y_m,z_m\n0,0,0,0\n0.1,0,1x,0\n");
  const auto result = runCarom(folder, {"filter", trace, "--csv", folder / "out.csv"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err.rfind("error: " + trace.string() + ":3:7: y_m is \"1x\"", 0), 0u) << result.err;
  EXPECT_EQ(folder.entries(), 1);  // the trace
  const auto missing = runCarom(folder, {"filter", folder / "none.csv"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("none.csv:1:1: "), std::string::npos) << missing.err;
  for (const char* speed : {"0", "-1", "nan", "1,42"}) {
    EXPECT_EQ(runCarom(folder, {"filter", kWalk, "--light-speed", speed}).status, 2) << speed;
  }
}

}  // namespace
}  // namespace carom
