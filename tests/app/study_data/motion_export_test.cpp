// The paths of a lesson as BIDS has them: the samples of its time, from its beginning, and its phases.
#include "app/study_data/motion_export.h"

#include <gtest/gtest.h>

#include <string>

#include <nlohmann/json.hpp>

#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::contentOf;
using test::TemporaryFolder;

TEST(MotionExport, WritesTheSamplesOfItsTimeAndItsPhases) {
  SQLite::Database session(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  session.exec(
      "CREATE TABLE sample(time_s REAL, sensor INTEGER, x_m REAL, y_m REAL, z_m REAL, qw REAL, qx REAL, qy "
      "REAL,"
      " qz REAL, tracker TEXT);"
      "INSERT INTO sample VALUES"
      "(99.75, 0, 9, 9, 9, 1, 0, 0, 0, 'the cave''s'), (100, 0, 0.5, 1.75, -2, 1, 0, 0, 0, 'the cave''s'),"
      "(100.25, 1, 5, 6, 7, 0, 1, 0, 0, 'the cave''s'), (100.5, 0, 1, 1.75, -2, 0, 0, 0, 1, 'the cave''s'),"
      "(101, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 'the cave''s'),"
      "(101.25, 0, 9, 9, 9, 1, 0, 0, 0, 'the cave''s');"
      "CREATE TABLE frame(number INTEGER, display_s REAL, lesson_phase INTEGER);"
      "INSERT INTO frame VALUES(6, 99, 3), (7, 100, 1), (8, 100.25, 1), (9, 100.5, 2), (10, 101, 3), (11, "
      "102, 1)");
  SessionGame game;
  game.from_s = 100.0;
  game.to_s = 101.0;
  const TemporaryFolder folder;
  exportMotion(session, {"7KQ2MD", "light-clock", 1, 7}, game, 11, folder / "");
  const auto at = folder / "sub-7KQ2MD" / "motion";
  const std::string start = (at / "sub-7KQ2MD_task-lightclock_").string(),
                    head = start + "tracksys-thecavess0_";
  EXPECT_EQ(contentOf(head + "motion.tsv"),
            "0\t0.5\t1.75\t-2\t1\t0\t0\t0\n0.5\t1\t1.75\t-2\t0\t0\t0\t1\n"
            "1\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\n");
  EXPECT_EQ(contentOf(start + "tracksys-thecavess1_motion.tsv"), "0.25\t5\t6\t7\t0\t1\t0\t0\n");
  const auto facts = nlohmann::json::parse(contentOf(head + "motion.json"));
  EXPECT_EQ(facts.at("TaskName").get<std::string>(), "light-clock");
  EXPECT_EQ(facts.at("SamplingFrequency").get<double>(), 2.0);
  EXPECT_EQ(facts.at("MotionChannelCount").get<int>(), 8);
  const std::string channels = contentOf(head + "channels.tsv");
  EXPECT_EQ(channels.substr(0, channels.find("thecavess0_y")),
            "name\tcomponent\ttype\ttracked_point\tunits\nt\tn/a\tLATENCY\tn/a\ts\n"
            "thecavess0_x\tx\tPOS\tthecavess0\tm\n");
  EXPECT_NE(channels.find("thecavess0_quat_z\tquat_z\tORNT\tthecavess0\tn/a\n"), std::string::npos)
      << channels;
  EXPECT_EQ(contentOf(start + "events.tsv"),
            "onset\tduration\ttrial_type\n0\t1\tlightclock\n0\t0\tasks\n0.5\t0\tshows\n1\t0\texplains\n");
}

}  // namespace
}  // namespace carom
