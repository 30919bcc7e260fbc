// No file, however it is made, costs `carom check` more than 2 s of processor and 300 MB of memory, or prints
// more than a hundred findings.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "app/program.h"
#include "app/repeated_text.h"

namespace carom {
namespace {

using test::ProgramResult;
using test::repeated;
using test::TemporaryFolder;

double processorOfChildren_s() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Checks a file that lies in the folder within the limits.
ProgramResult checked(const TemporaryFolder& folder, const std::filesystem::path& file) {
  const double before_s = processorOfChildren_s();
  const ProgramResult result = test::runCarom(folder, {"check", file.string()});
  EXPECT_LE(processorOfChildren_s() - before_s, 2.0) << result.err;
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  EXPECT_LE(usage.ru_maxrss, 300 << 10) << "KiB, of the largest so far: " << result.err;
  EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 101) << result.err;
  EXPECT_LE(result.err.size(), 200'000U);
  return result;
}

void expectSaid(const ProgramResult& result, int status, const std::string& words) {
  EXPECT_EQ(result.status, status) << result.err;
  EXPECT_NE(result.err.find(words), std::string::npos) << "instead of " << words << ": " << result.err;
}

const std::string kRig =
    "unit = 'm'\naxes = 'x-right y-up z-back'\n[head]\ntracker = 'head'\n[[tracker]]\nname = 'head'\n"
    "kind = 'simulated'\n";

std::string wallNamed(const std::string& name, const std::string& more = "") {
  return "[[wall]]\nname = '" + name +
         "'\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\nupper_left = [-1, 2, -1]\npixels = [100, "
         "100]\n" +
         more;
}

std::string bodyWith(const std::string& mesh) {
  return "light_speed_m_s = 1\n[[body]]\nname = 'rod'\nmesh = '" + mesh +
         "'\nat = { t_s = 0, r_m = [0, 0, 1] }\n[[body.leg]]\nbeta = [0, 0, 0]\n";
}

TEST(CheckCost, WhatIsNoFileEndsAtOnce) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo.toml").c_str(), 0600), 0);
  expectSaid(checked(folder, folder / "fifo.toml"), 1, "fifo.toml:1:1: this is a pipe, expected a TOML file");
  expectSaid(checked(folder, "/dev/zero"), 1, "/dev/zero:1:1: this is a device, expected a TOML file");
}

TEST(CheckCost, NestingEndsBeforeAParserRecurses) {
  const TemporaryFolder folder;
  constexpr int kDeep = 200'000;
  for (const auto& [name, text] :
       {std::pair("a.toml", "[" + repeated("a.", kDeep) + "a]\n"),
        std::pair("b.toml", "a = " + repeated("[", kDeep)), std::pair("c.json", repeated("[", kDeep)),
        std::pair("d.pvx", "<pvx>" + repeated("<a>", kDeep))})
    expectSaid(checked(folder, folder.file(name, text)), 1, "nested too deep");
}

TEST(CheckCost, WallsOnOnePlaceAreOneFinding) {
  const TemporaryFolder folder;
  std::string rig = kRig;
  for (int i = 0; i < 500; ++i) rig += wallNamed("w" + std::to_string(i));
  const ProgramResult result = checked(folder, folder.file("walls.toml", rig));
  expectSaid(result, 0, "124750 pairs of walls: walls 'w0' and 'w1' are on the same place");
  EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 5) << result.err;
  for (int i = 500; i < 2000; ++i) rig += wallNamed("w" + std::to_string(i));
  expectSaid(checked(folder, folder.file("walls.toml", rig)), 1,
             "2000 tables [[wall]], expected at most 512");
}

TEST(CheckCost, ManyEqualMistakesAreFewFindings) {
  const TemporaryFolder folder;
  expectSaid(checked(folder, folder.file("keys.json", "{" + repeated("\"a\": 1, ", 199'999) + "\"a\": 1}")),
             1, "too many values, expected at most 100000");
  expectSaid(checked(folder, folder.file("few.json",
                                         "{\"nodes\": [], " + repeated("\"a\": 1, ", 49'999) + "\"a\": 1}")),
             1, "50000 keys: unknown key 'a'");
  expectSaid(checked(folder, folder.file("games.toml", repeated("[[game]]\nscenario = 'none'\n", 99'999))), 1,
             "99999 tables [[game]], expected at most 100");
  const std::string machine =
      "<Machine Name='m' Geometry='9x9+0+0' LowerLeft='-1 0 -1' LowerRight='1 0 -1' UpperRight='1 2 -1' "
      "Odd=''/>\n";
  expectSaid(checked(folder, folder.file("machines.pvx", "<pvx>" + repeated(machine, 3000) + "</pvx>")), 1,
             "512 keys: unknown key 'Odd'");
  const std::string puck = "'\nradius_m = 0.03\nmass_kg = 0.2\nposition_m = [0, 0]\nbeta = [0, 0]\n";
  std::string pucks = "light_speed_m_s = 1\n";
  for (int i = 0; i < 10'000; ++i) pucks += "[[puck]]\nname = 'p" + std::to_string(i) + puck;
  expectSaid(checked(folder, folder.file("pucks.toml", pucks)), 1,
             "9999 pairs of pucks: puck 'p1' overlaps puck 'p0'");
}

TEST(CheckCost, WhateverElseTakesTooLongIsGivenUp) {
  const TemporaryFolder folder;
  // Thin discs at 0.99999999999 c, which stand in each other's way and do not touch.
  std::string pucks = "light_speed_m_s = 1\n";
  for (int i = 0; i < 20'000; ++i)
    pucks += "[[puck]]\nname = 'p" + std::to_string(i) + "'\nradius_m = 1\nmass_kg = 1\nposition_m = [" +
             std::to_string(1e-4 * i) + ", 0]\nbeta = [0.99999999999, 0]\n";
  expectSaid(checked(folder, folder.file("stack.toml", pucks)), 1,
             "stack.toml:1:1: takes more than check may use");
}

TEST(CheckCost, OpensEveryPictureOfARig) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& name, const std::string& content) {
    folder.file(name, content);
    return checked(folder, folder.file("rig.toml", kRig + wallNamed("front", "blend = '" + name + "'\n")));
  };
  expectSaid(said("cut.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10", 20)), 1,
             "cut.png:1:1: is ");
  expectSaid(said("bad.tif", std::string("II*\0", 4) + std::string(100, '\xff')), 1, "bad.tif:1:1: is ");
  const std::string huge =
      std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\x77\x35\x94\0\x77\x35\x94\0\x08\x02\0\0\0", 29);
  expectSaid(said("huge.png", huge + std::string(40, '\0')), 1, "huge.png:1:1: ");
  EXPECT_NE(said("cut.png", "").err.find("rig.toml:14:9: "), std::string::npos) << "where the rig names it";
}

TEST(CheckCost, AMeshOfMillionsOfTrianglesIsToldByItsHeader) {
  const TemporaryFolder folder;
  constexpr std::uint32_t kTriangles = 4'500'000;
  std::string header(84, '\0');
  std::memcpy(header.data() + 80, &kTriangles, sizeof kTriangles);
  std::filesystem::resize_file(folder.file("big.stl", header),
                               84 + 50ULL * kTriangles);  // takes no space on the disk
  expectSaid(checked(folder, folder.file("big.toml", bodyWith("big.stl"))), 0,
             "big.stl:1:1: is large, 225 MB, 4500000 faces: a session takes some ");
}

TEST(CheckCost, AGltfIsReadOnlyWithPartsThatAreFilesBelowIt) {
  const TemporaryFolder folder;
  folder.file("z.gltf",
              R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 100, "uri": "/dev/zero"}]})");
  expectSaid(checked(folder, folder.file("z.toml", bodyWith("z.gltf"))), 1,
             "z.gltf:1:1: it names '/dev/zero', which is /dev/zero, outside ");
}

TEST(CheckCost, NothingOfAFileSteersTheTerminal) {
  const TemporaryFolder folder;
  const std::string escape = "\x1b[31m\xC2\x9B";
  const auto named = folder.file("x" + escape + ".toml", "title = 1");
  const ProgramResult result = checked(folder, named);
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("\xC2\x9B"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace carom
