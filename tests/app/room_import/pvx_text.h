#pragma once
// A small room file of ParaView and its variants.

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "app/fault_names.h"
#include "app/import_faults.h"
#include "app/room_import/pvx_file.h"
#include "app/temporary_folder.h"

namespace carom::test::pvx {

inline Room read(const std::string& text) {
  const TemporaryFolder folder;
  return readPvx(folder.file("room.pvx", text));
}

inline std::string machine(const std::string& attributes) {
  return "<pvx>\n<Machine " + attributes + "/>\n</pvx>\n";
}

inline const std::string kFloor =
    "Name='Floor' Geometry='640x360+740+1560' LowerLeft='-1.13 -0.635 0.05'\n"
    "  LowerRight='1.13 -0.635 0.05' UpperRight='1.13 -0.635 -1.22'";

inline const std::string kGood = machine(kFloor);

inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Room files that are wrong in one place: each test of a part of the file gives its own.
class PvxFaults : public ::testing::TestWithParam<ImportFault> {};

}  // namespace carom::test::pvx
