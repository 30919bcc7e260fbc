// Faults of a rig's traces are found before a session starts.

#include "app/rig/traces.h"

#include <gtest/gtest.h>

#include "app/program.h"
#include "app/toml/toml_file.h"

namespace carom {
namespace {

using test::runCarom;
using test::TemporaryFolder;

std::string rigTracking(const std::string& trackers) {
  return "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"one\"\n" + trackers +
         "[[wall]]\nname = \"front\"\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\nupper_left = [-1, "
         "2, -1]\n"
         "pixels = [100, 100]\n";
}

std::string recorded(const std::string& name, const std::string& source) {
  return "[[tracker]]\nname = \"" + name + "\"\nkind = \"recorded\"\nsource = \"" + source + "\"\n";
}

TEST(Traces, EveryFaultIsNamedByCheck) {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.csv", "time_s,x_m,y_m,z_m\n0.0,0,1.7,0\n0.1,0,nan,0\n");
  const std::string two = folder.file("two.csv", "time,x\n");
  const std::string rig =
      folder.file("rig.toml", rigTracking(recorded("one", "one.csv") + recorded("two", "two.csv")));
  const auto result = runCarom(folder, {"check", rig});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("error: " + one + ":3:7: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("error: " + two + ":1:1: "), std::string::npos) << result.err;
}

TEST(Traces, WholeOnesPass) {
  const TemporaryFolder folder;
  folder.file("one.csv", "time_s,x_m,y_m,z_m\n0.0,0,1.7,0\n0.1,0,1.7,0\n");
  const std::string rig = folder.file("rig.toml", rigTracking(recorded("one", "one.csv")));
  EXPECT_NO_THROW(openTraces(readRig(rig)));
  const auto result = runCarom(folder, {"check", rig});
  EXPECT_EQ(result.status, 0) << result.err;
}

}  // namespace
}  // namespace carom
