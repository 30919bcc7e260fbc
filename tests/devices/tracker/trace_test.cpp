#include "devices/tracker/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "devices/walk_trace.h"
#include "engine/text/input_error.h"
#include "places.h"

namespace carom {
namespace {

const std::string kPositions = "time_s,x_m,y_m,z_m\n";
const std::string kPoses = "time_s,x_m,y_m,z_m,qx,qy,qz,qw\n";

std::vector<TrackerSample> read(const std::string& text) {
  std::istringstream in(text);
  return readTrace(in, "t.csv");
}

// What reading the text fails with.
std::string failure(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

struct Fault {
  const char* name;
  std::string text;
  std::string place;  // expected
  std::string word;   // expected in the message
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class Faults : public testing::TestWithParam<Fault> {};

TEST_P(Faults, AreNamedWithTheirPlace) {
  const std::string what = failure(GetParam().text);
  EXPECT_TRUE(what.starts_with(GetParam().place + ": ")) << what;
  EXPECT_NE(what.find(GetParam().word), std::string::npos) << what;
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
}

INSTANTIATE_TEST_SUITE_P(
    Trace, Faults,
    testing::Values(
        Fault{"Empty", "", "t.csv:1:1", "header"}, Fault{"OnlyComments", "# a\n# b\n", "t.csv:3:1", "header"},
        Fault{"OtherHeader", "# a\nt,x,y,z\n0,0,0,0\n", "t.csv:2:1", "time_s,x_m,y_m,z_m"},
        Fault{"NoRows", kPositions, "t.csv:2:1", "no rows"},
        Fault{"TooFewColumns", kPositions + "0,1,2\n", "t.csv:2:6", "3 columns, expected 4"},
        Fault{"TooManyColumns", kPositions + "0,1,2,3,4\n", "t.csv:2:9", "5 columns, expected 4"},
        Fault{"FarTooManyColumns", kPoses + "0,0,0,0,0,0,0,1,5,6\n", "t.csv:2:20", "10 columns, expected 8"},
        Fault{"HalfAPose", kPoses + "0,1,2,3\n", "t.csv:2:8", "4 columns, expected 8"},
        Fault{"BlankLine", kPositions + "0,1,2,3\n\n1,1,2,3\n", "t.csv:3:1", "columns"},
        Fault{"CommentAmongRows", kPositions + "0,1,2,3\n# x\n", "t.csv:3:4", "columns"},
        Fault{"Junk", kPositions + "0,1,0/05,3\n", "t.csv:2:5", "y_m is \"0/05\", expected a number"},
        Fault{"JunkAfterBlank", kPositions + "0,1,  2m,3\n", "t.csv:2:7", "y_m is \"2m\""},
        Fault{"EmptyField", kPositions + "0,,2,3\n", "t.csv:2:3", "x_m is \"\""},
        Fault{"Hexadecimal", kPositions + "0,0x10,2,3\n", "t.csv:2:3", "expected a number"},
        Fault{"NotANumber", kPositions + "0,1,2,nan\n", "t.csv:2:7", "finite"},
        Fault{"Infinite", kPositions + "0,-inf,2,3\n", "t.csv:2:3", "finite"},
        Fault{"Overflow", kPositions + "0,1e999,2,3\n", "t.csv:2:3", "out of range"},
        Fault{"FarAway", kPositions + "0,1e7,2,3\n", "t.csv:2:3", "at most 1000000"},
        Fault{"TimeBack", kPositions + "1,0,0,0\n2,0,0,0\n1.5,0,0,0\n", "t.csv:4:1", "increasing"},
        Fault{"TimeEqual", kPositions + "1,0,0,0\n1,0,0,0\n", "t.csv:3:1", "increasing"},
        Fault{"ZeroQuaternion", kPoses + "0,1,2,3,0,0,0,0\n", "t.csv:2:9", "quaternion"},
        Fault{"LongQuaternion", kPoses + "0,1,2,3,1,1,0,0\n", "t.csv:2:9", "quaternion"},
        Fault{"NulByte", kPositions + std::string("0,1,2,3\0\n", 9), "t.csv:2:7", "z_m"},
        Fault{"LongLine", kPositions + std::string(2000, '1'), "t.csv:2:1", "longer"}),
    [](const auto& fault) { return std::string(fault.param.name); });

TEST(Trace, ReadsWhatPeopleWrite) {
  const auto samples = read("\xef\xbb\xbf# made by hand\r\n" + std::string("time_s,x_m,y_m,z_m\r\n") +
                            "-1, 1e-3,\t-2 ,3\r\n0.5,0,0,0");  // a byte order mark, blanks, no last newline
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].time_s, -1.0);
  EXPECT_EQ(samples[0].pose.position_m, glm::dvec3(0.001, -2.0, 3.0));
  EXPECT_FALSE(samples[0].hasOrientation);
  EXPECT_EQ(samples[0].pose.orientation, glm::dquat(1.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(samples[1].time_s, 0.5);
}

TEST(Trace, NormalisesQuaternions) {
  const auto samples = read(kPoses + "0,0,0,0,0,0.69,0,0.69\n");
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_TRUE(samples[0].hasOrientation);
  EXPECT_NEAR(samples[0].pose.orientation.y, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(samples[0].pose.orientation.w, std::sqrt(0.5), 1e-15);
}

TEST(Trace, ReadsALineOfAnyAllowedLength) {
  const std::string padding(1024 - 7, ' ');
  EXPECT_EQ(read(kPositions + "0,1,2,3" + padding + "\n").size(), 1u);
  EXPECT_EQ(read(kPositions + "0,1,2,3" + padding).size(), 1u);
  EXPECT_NE(failure(kPositions + "0,1,2,3 " + padding).find("longer"), std::string::npos);
}

TEST(Trace, MissingFilesAndFoldersAreNamed) {
  for (const std::string file : {"/nowhere/at/all.csv", "/tmp"}) {
    try {
      readTrace(file);
      FAIL() << file;
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), file);
      EXPECT_TRUE(std::string(error.what()).starts_with(file + ":1:1: ")) << error.what();
    }
  }
}

// Random bytes and random damage to a good trace: an error or a trace, never anything else.
TEST(Trace, SurvivesDamage) {
  std::mt19937_64 random(20240117);
  const std::string good = kPoses + "0,1,2,3,0,0,0,1\n0.25,1.5,-2e-3,3,0,0,0,1\n";
  for (int round = 0; round < 20000; ++round) {
    std::string text = good;
    for (std::uint64_t i = 0, n = 1 + random() % 4; i < n; ++i) {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    try {
      for (const TrackerSample& sample : read(text)) {
        ASSERT_TRUE(
            std::isfinite(sample.pose.position_m.x + sample.pose.position_m.y + sample.pose.position_m.z));
        ASSERT_NEAR(glm::length(sample.pose.orientation), 1.0, 1e-12);
      }
    } catch (const InputError&) {
    }
  }
}

class TraceFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("trace_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(TraceFile, WritesWhatReadsBackToTheSameBits) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-3.0, 3.0);
  std::vector<TrackerSample> written;
  for (int i = 0; i < 100; ++i) {
    TrackerSample sample{i / 60.0, 0, {}, true};
    sample.pose.position_m = {uniform(random), uniform(random) * 1e-9, uniform(random)};
    sample.pose.orientation =
        glm::normalize(glm::dquat(uniform(random), uniform(random), uniform(random), uniform(random)));
    written.push_back(sample);
  }
  const auto file = folder_ / "a.csv";
  TraceWriter writer(file, true, "one\ntwo");
  for (const TrackerSample& sample : written) writer.add(sample);
  EXPECT_FALSE(std::filesystem::exists(file));
  writer.commit();
  const auto samples = readTrace(file);
  ASSERT_EQ(samples.size(), written.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].time_s, written[i].time_s);
    EXPECT_EQ(samples[i].pose.position_m, written[i].pose.position_m);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(samples[i].pose.orientation[k], written[i].pose.orientation[k], 3e-16);  // normalised again
    }
  }
}

TEST_F(TraceFile, WithoutCommitNothingIsLeft) {
  { TraceWriter(folder_ / "a.csv", false).add({}); }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  EXPECT_THROW(TraceWriter(folder_ / "no" / "a.csv", false), std::runtime_error);
}

// The shipped trace is the one that make_walk_trace writes (to a few micrometres: libm differs between CPUs).
TEST(Trace, TheShippedWalkIsThatOfTheSimulatedPerson) {
  const auto shipped = readTrace(CAROM_CONFIG_DIR "/traces/walk.csv");
  const auto made = walkTrace();
  ASSERT_EQ(shipped.size(), made.size());
  for (std::size_t i = 0; i < shipped.size(); ++i) {
    ASSERT_NEAR(shipped[i].time_s, made[i].time_s, 2e-6);
    ASSERT_TRUE(glm::distance(shipped[i].pose.position_m, made[i].pose.position_m) < 4e-6) << i;
    ASSERT_TRUE(std::abs(glm::dot(shipped[i].pose.orientation, glm::normalize(made[i].pose.orientation))) >
                1.0 - 1e-9)
        << i;
    // Within a CAVE of 3 m × 3 m, at the height of a head.
    ASSERT_LT(std::abs(shipped[i].pose.position_m.x), 1.2);
    ASSERT_LT(std::abs(shipped[i].pose.position_m.z), 1.2);
    ASSERT_NEAR(shipped[i].pose.position_m.y, 1.7, 0.15);
  }
}

}  // namespace
}  // namespace carom
