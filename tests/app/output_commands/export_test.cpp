// `carom export`: rows and meshes of a recorded session against what `carom observe` says of the same events.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "app/program.h"
#include "app/table_rows.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

using nlohmann::json;
using test::contentOf;
using test::exact;
using test::Row;
using test::rowsOf;
using test::runCarom;
using test::TemporaryFolder;

double numberIn(const Row& row, const std::string& name) { return std::stod(row.at(name)); }

/// What observe says of the event and motion of a row.
json observed(const TemporaryFolder& folder, const std::filesystem::path& scenario, const Row& row,
              const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"observe", scenario, "--json", "-", "--event"};
  for (const char* name : {"t_s", "x_m", "y_m", "z_m"}) arguments.push_back(row.at(name));
  arguments.push_back("--beta");
  for (const char* name : {"beta_x", "beta_y", "beta_z"}) arguments.push_back(row.at(name));
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto result = runCarom(folder, arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  return json::parse(result.out);
}

void expectSame(double a, double b, double size, const std::string& what) {
  constexpr double kSame = 1e-12;  // the same solve of the same knots
  EXPECT_TRUE(std::abs(a - b) <= kSame * size) << what << ": " << exact(a) << ", expected " << exact(b);
}

void expectSame(const Row& row, const std::string& what, const json& place_m) {
  double size_m = 0.0;
  for (int i = 0; i < 3; ++i) size_m = std::hypot(size_m, place_m[i].get<double>());
  int i = 0;
  for (const char* axis : {"x", "y", "z"}) {
    const std::string name = what + "_" + axis + "_m";
    expectSame(numberIn(row, name), place_m[i++].get<double>(), size_m, name);
  }
}

/// The rows of one frame, a row for each body, against observe. Returns how many were seen.
int expectAsObserved(const TemporaryFolder& folder, const std::filesystem::path& scenario, const Row* rows) {
  const json points = observed(folder, scenario, rows[0])["points"];
  int seen = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Row& row = rows[i];
    const json& point = points[i];
    SCOPED_TRACE("frame " + row.at("frame") + ", " + row.at("body"));
    EXPECT_EQ(row.at("frame"), rows[0].at("frame"));
    EXPECT_EQ(row.at("status"), point["status"].get<std::string>());
    if (point["status"] != "seen") {
      EXPECT_EQ(row.at("doppler"), "");
      continue;
    }
    ++seen;
    const double light_s = std::abs(point["emission"]["t_s"].get<double>()) + std::abs(numberIn(row, "t_s"));
    expectSame(numberIn(row, "emission_t_s"), point["emission"]["t_s"], light_s, "emission_t_s");
    expectSame(row, "emission", point["emission"]["r_m"]);
    expectSame(row, "seen", point["seen_m"]);
    expectSame(numberIn(row, "distance_m"), point["distance_m"], point["distance_m"], "distance_m");
    expectSame(numberIn(row, "doppler"), point["doppler"], point["doppler"], "doppler");
    expectSame(numberIn(row, "body_proper_time_s"), point["proper_time_s"], light_s, "body_proper_time_s");
  }
  return seen;
}

constexpr std::size_t kBodies = 4;

/// A played session of two seconds.
struct Played {
  Played() {
    std::string text = contentOf(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
    text +=
        "\n[[body]]\nname = 'a \"b\"'\nat = { t_s = 0, r_m = [0, 1.5, 0.5] }\nappears_s = 0.0\n"
        "[[body.leg]]\nbeta = [0.3, 0, 0]\n";
    scenario = folder.file("game.toml", text);
    folder.file("still.csv", "time_s,x_m,y_m,z_m\n0,0,1.7,0\n");
    rig = folder.file(
        "room.toml",
        "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"t\"\n[[tracker]]\nname = "
        "\"t\"\nkind = \"recorded\"\nsource = \"still.csv\"\n[[wall]]\nname = \"front\"\nlower_left = [-1, "
        "0, -1]\nlower_right = [1, 0, -1]\nupper_left = [-1, 2, -1]\npixels = [96, 96]\nstereo = "
        "\"mono\"\nwindow = { position = [0, 0], size = [96, 96] }\n");
    std::ostringstream walk("time_s,x_m,y_m,z_m\n", std::ios::ate);
    for (int i = 0; i < 180; ++i) {
      walk << i / 100.0 << ',' << 0.4 * std::sin(0.03 * i) << ',' << 1.6 + 0.04 * std::cos(0.07 * i) << ','
           << -0.004 * i << '\n';
    }
    other = folder.file("other.csv", walk.str());
    const auto played = runCarom(folder, {"cave", "--rig", rig, "--scenario", scenario, "--frames", "120",
                                          "--session", folder / "game.db", "--no-window"});
    EXPECT_EQ(played.status, 0) << played.err;
  }

  const TemporaryFolder folder;
  std::filesystem::path scenario, rig, other;
};

/// All tests share it.
class Export : public testing::Test {
 protected:
  Export() : folder_(played().folder), scenario_(played().scenario), other_(played().other) {}
  static const Played& played() {
    if (!played_) played_ = std::make_unique<Played>();
    return *played_;
  }
  static void TearDownTestSuite() { played_.reset(); }

  std::vector<Row> rowsOfExport(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"export", folder_ / "game.db", "--csv", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = runCarom(folder_, arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return rowsOf(result.out);
  }

  static inline std::unique_ptr<Played> played_;
  const TemporaryFolder& folder_;
  const std::filesystem::path &scenario_, &other_;
};

TEST_F(Export, WhatAnotherPersonSeesIsWhatObserveSays) {
  const auto rows = rowsOfExport({"--observer", other_});
  ASSERT_GE(rows.size(), 100 * kBodies);
  EXPECT_EQ(rows[3].at("body"), "\"a \"\"b\"\"\"") << "a field of a CSV";
  int seen = 0;
  double fastest = 0.0;
  const std::size_t frames = rows.size() / kBodies;
  for (std::size_t sample = 0; sample < 10; ++sample) {
    const Row* row = &rows[sample * (frames - 1) / 9 * kBodies];
    seen += expectAsObserved(folder_, scenario_, row);
    fastest = std::max(fastest, std::hypot(numberIn(*row, "beta_x"), numberIn(*row, "beta_y")));
  }
  EXPECT_GT(seen, 30);
  EXPECT_GT(fastest, 0.2) << "the other person walks";
  EXPECT_EQ(rows[3].at("status"), "unseen") << "its light has not arrived when the session begins";
  EXPECT_EQ(rows.back().at("status"), "seen");
}

TEST_F(Export, WhatThePersonSawIsWhatObserveSays) {
  const auto rows = rowsOfExport({"--every", "40"});
  ASSERT_EQ(rows.size(), 3 * kBodies);
  for (std::size_t i = 0; i < rows.size(); i += kBodies) {
    EXPECT_EQ(rows[i].at("frame"), std::to_string(i / kBodies * 40));
    expectAsObserved(folder_, scenario_, &rows[i]);
  }
}

TEST_F(Export, ParaViewGetsASeriesOfWhatObserveWrites) {
  const auto result = runCarom(folder_, {"export", folder_ / "game.db", "--observer", other_, "--every", "50",
                                         "--csv", folder_ / "seen.csv", "--paraview", folder_ / "seen"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = rowsOf(contentOf(folder_ / "seen.csv"));
  ASSERT_GE(rows.size(), 3 * kBodies);
  const std::string index = contentOf(folder_ / "seen/seen.pvd");
  for (std::size_t i = 0; i < rows.size(); i += kBodies) {
    char name[32];
    std::snprintf(name, sizeof name, "seen_%06d.vtp", std::stoi(rows[i].at("frame")));
    EXPECT_NE(index.find("timestep=\"" + rows[i].at("display_s") + "\" part=\"0\" file=\"" + name + "\""),
              std::string::npos)
        << index;
    observed(folder_, scenario_, rows[i], {"--vtp", folder_ / "one.vtp"});
    EXPECT_TRUE(contentOf(folder_ / "seen" / name) == contentOf(folder_ / "one.vtp")) << name;
  }
  const auto files = std::distance(std::filesystem::directory_iterator(folder_ / "seen"), {});
  EXPECT_EQ(static_cast<std::size_t>(files), rows.size() / kBodies + 1);
}

TEST_F(Export, NothingIsHalfWritten) {
  const long before = folder_.entries();
  const auto bad = folder_.file("bad.csv", "time_s,x_m,y_m,z_m\n0,0,1.7\n");
  const auto faulty = runCarom(folder_, {"export", folder_ / "game.db", "--observer", bad, "--csv",
                                         folder_ / "a.csv", "--paraview", folder_ / "a"});
  EXPECT_EQ(faulty.status, 1);
  EXPECT_NE(faulty.err.find("bad.csv:2"), std::string::npos) << faulty.err;
  EXPECT_EQ(folder_.entries(), before + 1) << "only the faulty trace";
  std::filesystem::create_directory(folder_ / "full");
  std::ofstream(folder_ / "full/notes.txt") << "mine";
  const auto refused =
      runCarom(folder_, {"export", folder_ / "game.db", "--every", "60", "--paraview", folder_ / "full"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("there already"), std::string::npos) << refused.err;
  EXPECT_EQ(contentOf(folder_ / "full/notes.txt"), "mine");
  EXPECT_EQ(runCarom(folder_, {"export", folder_ / "game.db"}).status, 2) << "nothing is asked for";
}

}  // namespace
}  // namespace carom
