// `carom observe --vtp`: read back with VTK, against what `carom observe --json` says of the same points.

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "app/program.h"
#include "places.h"

namespace carom {
namespace {

using nlohmann::json;
using test::exact;
using test::runCarom;
using test::TemporaryFolder;

// Both commands solve the same points in double; 1e-9 m or s is a thousandth of the width of an atom's trace
// in anything shown.
constexpr double kSame = 1e-9;

vtkSmartPointer<vtkPolyData> readBack(const std::filesystem::path& file) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

std::vector<double> tuple(vtkPolyData& mesh, const char* name, vtkIdType i) {
  vtkDataArray* array = mesh.GetPointData()->GetArray(name);
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfComponents()));
  array->GetTuple(i, values.data());
  return values;
}

std::string fieldText(vtkPolyData& mesh, const char* name, vtkIdType i) {
  return vtkStringArray::SafeDownCast(mesh.GetFieldData()->GetAbstractArray(name))->GetValue(i);
}

const std::string kLateBody =
    "\n[[body]]\nname = \"late\"\nat = { t_s = 0, r_m = [0, 9, 0.5] }\nappears_s = 2.0\n[[body.leg]]\nbeta = "
    "[0, 0.5, "
    "0]\n";

TEST(SeenScene, AgreesWithWhatObserveSaysOfThePoints) {
  const TemporaryFolder folder;
  const std::string scenario = CAROM_CONFIG_DIR "/scenarios/three-pucks.toml";
  const std::vector<std::string> eye{"--event", "2.3", "0.4", "-0.9", "0.8", "--beta", "0.3", "-0.5", "0.1"};
  std::vector<std::string> arguments{"observe", scenario, "--vtp", folder / "seen.vtp"};
  arguments.insert(arguments.end(), eye.begin(), eye.end());
  const auto written = runCarom(folder, arguments);
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_NE(written.out.find("white"), std::string::npos) << "the table comes all the same";
  const auto mesh = readBack(folder / "seen.vtp");
  ASSERT_GT(mesh->GetNumberOfPoints(), 30000);
  EXPECT_GT(mesh->GetNumberOfPolys(), mesh->GetNumberOfPoints());

  std::vector<vtkIdType> ids;  // of pucks, whose points observe can be asked for
  std::set<int> bodies;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    const int body = static_cast<int>(tuple(*mesh, "body", i)[0]);
    bodies.insert(body);
    if (body > 0) ids.push_back(i);
  }
  EXPECT_EQ(bodies, (std::set<int>{0, 1, 2, 3}));
  EXPECT_EQ(fieldText(*mesh, "body_names", 1), "white");
  EXPECT_EQ(fieldText(*mesh, "status", 0), "seen");
  EXPECT_EQ(mesh->GetFieldData()->GetArray("event_t_s")->GetTuple1(0), 2.3);

  std::mt19937 random(5);
  std::vector<std::string> asked{"observe", scenario, "--json", "-"};
  asked.insert(asked.end(), eye.begin(), eye.end());
  std::vector<vtkIdType> samples;
  for (int k = 0; k < 200; ++k) {
    const vtkIdType id = ids[random() % ids.size()];
    samples.push_back(id);
    const auto offset_m = tuple(*mesh, "offset_m", id);
    const auto body = static_cast<vtkIdType>(tuple(*mesh, "body", id)[0]);
    for (const std::string& word : {std::string("--point"), fieldText(*mesh, "body_names", body),
                                    exact(offset_m[0]), exact(offset_m[1]), exact(offset_m[2])}) {
      asked.push_back(word);
    }
  }
  const auto said = runCarom(folder, asked);
  ASSERT_EQ(said.status, 0) << said.err;
  const json points = json::parse(said.out)["points"];
  ASSERT_EQ(points.size(), samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    SCOPED_TRACE(points[k].dump());
    const vtkIdType id = samples[k];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(mesh->GetPoint(id)[axis], points[k]["seen_m"][axis].get<double>(), kSame);
      EXPECT_NEAR(tuple(*mesh, "r_m", id)[axis], points[k]["emission"]["r_m"][axis].get<double>(), kSame);
    }
    EXPECT_NEAR(tuple(*mesh, "t_s", id)[0], points[k]["emission"]["t_s"].get<double>(), kSame);
    EXPECT_NEAR(tuple(*mesh, "doppler", id)[0], points[k]["doppler"].get<double>(), kSame);
    EXPECT_NEAR(tuple(*mesh, "proper_time_s", id)[0], points[k]["proper_time_s"].get<double>(), kSame);
  }
}

// For what rests, by hand: light left |r − r_eye|/c ago, and the table's clocks all show board time.
TEST(SeenScene, TheTableIsSeenWhereItWasThatLongAgo) {
  const TemporaryFolder folder;
  const std::string scenario = CAROM_CONFIG_DIR "/scenarios/three-pucks.toml";
  ASSERT_EQ(
      runCarom(folder, {"observe", scenario, "--event", "5", "0", "-1", "1", "--vtp", folder / "seen.vtp"})
          .status,
      0);
  const auto mesh = readBack(folder / "seen.vtp");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 7) {
    if (tuple(*mesh, "body", i)[0] > 0) continue;
    const auto r = tuple(*mesh, "r_m", i);
    ASSERT_NEAR(tuple(*mesh, "t_s", i)[0], 5.0 - std::hypot(r[0], r[1] + 1.0, r[2] - 1.0) / 1.42, kSame);
    ASSERT_NEAR(tuple(*mesh, "proper_time_s", i)[0], tuple(*mesh, "t_s", i)[0], kSame);
    ASSERT_NEAR(tuple(*mesh, "doppler", i)[0], 1.0, kSame);
    ASSERT_NEAR(mesh->GetPoint(i)[1], r[1] + 1.0, kSame);
  }
}

TEST(SeenScene, WhatIsUnseenIsLeftOutAndCounted) {
  const TemporaryFolder folder;
  const std::string scenario = folder.file("s.toml", "light_speed_m_s = 1.0\n" + kLateBody);
  const auto before =
      runCarom(folder, {"observe", scenario, "--event", "3", "0", "0", "0.5", "--vtp", folder / "a.vtp"});
  ASSERT_EQ(before.status, 0) << before.err;
  const auto unseen = readBack(folder / "a.vtp");
  EXPECT_EQ(fieldText(*unseen, "status", 1), "unseen");
  EXPECT_EQ(before.err.find("; 0 are unseen"), std::string::npos) << before.err;
  // Its light of 2 s, from 10 m away: the near end arrives while the far one's has not.
  const auto during =
      runCarom(folder, {"observe", scenario, "--event", "12", "0", "0", "0.5", "--vtp", folder / "b.vtp"});
  ASSERT_EQ(during.status, 0) << during.err;
  const auto partly = readBack(folder / "b.vtp");
  EXPECT_EQ(fieldText(*partly, "status", 1), "partly seen");
  for (vtkIdType i = 0; i < partly->GetNumberOfPoints(); ++i) {
    if (tuple(*partly, "body", i)[0] == 1.0) {
      ASSERT_GE(tuple(*partly, "t_s", i)[0], 2.0);
    }
  }
}

TEST(SeenScene, IsTheSameEveryTimeAndWholeOrNotThere) {
  const TemporaryFolder folder;
  const std::string scenario = CAROM_CONFIG_DIR "/scenarios/parallel-tracks.toml";
  const auto write = [&](const std::string& to) {
    return runCarom(folder, {"observe", scenario, "--event", "1", "0", "0", "1", "--vtp", to, "--json",
                             folder / "seen.json"});
  };
  ASSERT_EQ(write(folder / "a.vtp").status, 0);
  ASSERT_EQ(write(folder / "b.vtp").status, 0);
  EXPECT_EQ(test::contentOf(folder / "a.vtp"), test::contentOf(folder / "b.vtp"));
  EXPECT_EQ(json::parse(test::contentOf(folder / "seen.json"))["points"].size(), 5u);
  const auto nowhere = write("/no/such/folder/a.vtp");
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_NE(nowhere.err.find("error: /no/such/folder/a.vtp"), std::string::npos) << nowhere.err;

  const std::string bad = folder.file("bad.obj", "v 0 0 nan\n");
  const std::string broken = folder.file("broken.toml", "light_speed_m_s = 1.0\n" + kLateBody + "");
  std::string text = test::contentOf(broken);
  text.insert(text.find("at ="), "mesh = \"bad.obj\"\n");
  folder.file("broken.toml", text);
  const auto refused =
      runCarom(folder, {"observe", broken, "--event", "1", "0", "0", "1", "--vtp", folder / "c.vtp"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("error: " + bad + ":1:7: "), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "c.vtp"));

  const auto checked = runCarom(folder, {"check", broken});
  EXPECT_EQ(checked.status, 1);
  EXPECT_NE(checked.err.find("error: " + bad + ":1:7: "), std::string::npos) << checked.err;
}

// A soft puck in the middle of a bounce: the rim of its mesh at both sides, where observe sees the matter.
TEST(SeenScene, ASoftPuckIsSeenAsItIsDeformed) {
  const TemporaryFolder folder;
  folder.file("soft.toml",
              "light_speed_m_s = 1.42\n[board]\nlength_m = 0.6\nwidth_m = 0.6\n[[puck]]\nname = \"jelly\"\n"
              "radius_m = 0.03\nheight_m = 0.02\nmass_kg = 0.2\nposition_m = [0.2, 0.0]\nbeta = [0.6, 0.0]\n"
              "[puck.soft]\ncells = 6\n");
  const std::vector<std::string> eye{
      (folder / "soft.toml").string(), "--event", "0.4", "0.2", "-0.4", "0.2", "--beta", "0.1", "0.2", "0.0"};
  std::vector<std::string> asked{"observe"};
  asked.insert(asked.end(), eye.begin(), eye.end());
  asked.insert(asked.end(), {"--vtp", folder / "seen.vtp", "--json", "-"});
  for (const char* x : {"-0.03", "0.03"}) asked.insert(asked.end(), {"--point", "jelly", x, "0", "0.01"});
  const auto result = runCarom(folder, asked);
  ASSERT_EQ(result.status, 0) << result.err;
  const json points = json::parse(result.out)["points"];
  const auto mesh = readBack(folder / "seen.vtp");
  constexpr double kRow_m = 2e-4;  // rows are within a tenth of a millimetre of the steps
  std::array<double, 2> across{};
  for (std::size_t k = 0; k < 2; ++k) {
    double nearest = 1.0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
      const std::vector<double> offset = tuple(*mesh, "offset_m", i), place = tuple(*mesh, "r_m", i);
      const double side = k == 0 ? -0.03 : 0.03;
      if (std::abs(offset[0] - side) > 1e-9 || std::abs(offset[1]) > 1e-9 ||
          std::abs(offset[2] - 0.01) > 1e-6)
        continue;
      const json& from = points[k]["emission"]["r_m"];
      nearest =
          std::min(nearest, std::hypot(place[0] - from[0].get<double>(), place[1] - from[1].get<double>()));
      across[k] = place[0];
    }
    EXPECT_LT(nearest, kRow_m) << points[k];
  }
  EXPECT_LT(across[1] - across[0], 0.75 * 0.06) << "pressed";
}

}  // namespace
}  // namespace carom
