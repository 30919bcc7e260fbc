// Values that several kinds of files have: poses, speeds, the place of spacetime, languages.
#include "app/toml/toml_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "app/file_keys/common_keys.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using namespace declare;
using test::TemporaryFolder;

/// Reads a file of this text, whose keys these are. Returns "LINE:COLUMN MESSAGE" of each fault.
std::vector<std::string> readOf(const std::string& text, std::vector<FileKey> keys,
                                const std::function<void(const TomlTable&)>& read) {
  const FileKey declared = table("file", "", std::move(keys));
  const TemporaryFolder folder;
  const TomlFile file(folder.file("given.toml", text), declared);
  read(file.root());
  std::vector<std::string> faults;
  try {
    file.throwFaults();
  } catch (const InputErrors& errors) {
    for (const InputError& fault : errors.faults())
      faults.push_back(fmt::format("{}:{} {}", fault.line(), fault.column(), fault.message()));
  }
  return faults;
}

using Faults = std::vector<std::string>;

// Turning by each axis alone, one after the other, is another way to the same place.
TEST(TomlValues, APoseTurnsAboutFixedAxesThenMoves) {
  const auto turned = [](double angle_deg, int axis, const glm::dvec3& v) {
    const double a = angle_deg * 3.14159265358979323846 / 180.0, c = std::cos(a), s = std::sin(a);
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    glm::dvec3 to = v;
    to[i] = c * v[i] - s * v[j];
    to[j] = s * v[i] + c * v[j];
    return to;
  };
  const glm::dvec3 place(0.3, -1.2, 0.7);
  const auto faults = readOf(
      "held = { translation = [100, -20, 5], rotation_deg = [30, -50, 110] }\n",
      {pose("held", ""), pose("none", "")}, [&](const TomlTable& root) {
        const glm::dvec3 expected =
            turned(110, 2, turned(-50, 1, turned(30, 0, place))) + glm::dvec3(1.0, -0.2, 0.05);
        const glm::dvec3 found = readPose(root, "held", 0.01) * place;
        EXPECT_LT(glm::distance(found, expected), 1e-14) << found.x << ' ' << found.y << ' ' << found.z;
        EXPECT_EQ(readPose(root, "none", 0.01) * place, place);
      });
  EXPECT_EQ(faults, Faults{});
}

TEST(TomlValues, TheFastestSpeedIsACelerity) {
  const auto most_u = [](const std::string& text) {
    double u = 0.0;
    EXPECT_EQ(readOf(text, {fastestBeta("")}, [&](const TomlTable& root) { u = readMost_u(root); }),
              Faults{});
    return u;
  };
  EXPECT_NEAR(most_u("fastest_beta = 0.6\n"), 0.75, 1e-15);
  EXPECT_EQ(most_u(""), kMostPlatformU);
}

TEST(TomlValues, SpacetimeStandsInTheUnitOfItsFile) {
  const auto faults = readOf("[spacetime]\nplace = [100, 0, -50]\nscale = 0.5\npast_s = 3\n",
                             {spacetimeKey(true)}, [](const TomlTable& root) {
                               const SpacetimeSetup setup = readSpacetime(*root.table("spacetime"), 0.01);
                               EXPECT_EQ(setup.place_m, glm::dvec3(1.0, 0.0, -0.5));
                               EXPECT_EQ(setup.scale, 0.5);
                               EXPECT_EQ(setup.height_m, 2.2);
                               EXPECT_EQ(setup.past_s, 3.0);
                               EXPECT_FALSE(setup.future_s);
                             });
  EXPECT_EQ(faults, Faults{});
}

TEST(TomlValues, SpeedsAreBelowLight) {
  const auto faultsOf = [](const std::string& beta) {
    return readOf("beta = " + beta + "\n", {numbers("beta", 2, {}, "")},
                  [](const TomlTable& root) { checkSpeed(root, toVec2(root.numbers<2>("beta"))); });
  };
  EXPECT_EQ(faultsOf("[0.6, 0.79]"), Faults{});
  EXPECT_EQ(faultsOf("[-3, 4]"), Faults{"1:8 beta has magnitude 5, expected a speed below light, under 1"});
}

TEST(TomlValues, LanguagesStandOnceEach) {
  std::vector<std::string> languages;
  const auto read = [&](const TomlTable& root) { languages = readLanguages(root, {}); };
  EXPECT_EQ(readOf("languages = ['de', 'en']\n", {languagesKey("")}, read), Faults{});
  EXPECT_EQ(languages, (std::vector<std::string>{"de", "en"}));
  EXPECT_EQ(readOf("languages = ['de', 'en', 'de']\n", {languagesKey("")}, read),
            Faults{"1:26 'de' stands here twice, expected it once"});
  EXPECT_EQ(
      readOf("", {languageKey("")}, [](const TomlTable& root) { EXPECT_EQ(readLanguage(root, {}), ""); }),
      Faults{});
  const Faults unknown =
      readOf("language = 'x x'\n", {languageKey("")}, [](const TomlTable& root) { readLanguage(root, {}); });
  ASSERT_EQ(unknown.size(), 1u);
  EXPECT_TRUE(unknown[0].starts_with("1:12 ")) << unknown[0];
}

}  // namespace
}  // namespace carom
