// Baked light that is kept for the next session and handed to other nodes.
#include "cave/scene/kept_light.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cave/scene/baked_light.h"
#include "cave/scene/lit_plates.h"

namespace carom {
namespace {

using test::bytesOf;
using test::plateOver;
using test::slabOver;

/// A folder for kept light, gone with the test.
struct LightFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("carom-light-test-" + std::to_string(getpid()));
  ~LightFolder() { std::filesystem::remove_all(path); }

  std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> all;
    for (const auto& entry : std::filesystem::directory_iterator(path)) all.push_back(entry.path());
    return all;
  }
};

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ino_t numberOf(const std::filesystem::path& file) {
  struct stat state {};
  stat(file.c_str(), &state);
  return state.st_ino;
}

TEST(KeptLight, IsThatWhichWasBakedAndIsBakedOnce) {
  const LightFolder folder;
  Scene baked = plateOver(0.75), first = plateOver(0.75), again = plateOver(0.75), other = plateOver(0.76);
  bakeLight(baked);
  lightScene(first, folder.path);
  ASSERT_EQ(folder.files().size(), 1U);
  const std::filesystem::path file = folder.files().front();
  const ino_t number = numberOf(file);
  lightScene(again, folder.path);
  EXPECT_EQ(numberOf(file), number) << "it was baked and written again";
  EXPECT_EQ(bytesOf(*first.parts[0].mesh), bytesOf(*baked.parts[0].mesh));
  EXPECT_EQ(bytesOf(*again.parts[0].mesh), bytesOf(*baked.parts[0].mesh));
  lightScene(other, folder.path);
  EXPECT_EQ(folder.files().size(), 2U) << "another scene has other light";
  EXPECT_NE(bytesOf(*other.parts[0].mesh), bytesOf(*baked.parts[0].mesh));
}

TEST(KeptLight, IsHandedToTheSameSceneOnly) {
  Scene first = plateOver(0.75), same = plateOver(0.75), other = plateOver(0.76), coarser = slabOver(0.75);
  bakeLight(first);
  const std::string light = lightOf(first);
  EXPECT_TRUE(setLight(same, light));
  EXPECT_EQ(bytesOf(*same.parts[0].mesh), bytesOf(*first.parts[0].mesh));
  EXPECT_FALSE(setLight(other, light));
  EXPECT_FALSE(setLight(coarser, light));
  for (const std::string& wrong : {std::string(), std::string("x"), light + "x", light.substr(1)})
    EXPECT_FALSE(setLight(same, wrong)) << wrong.size() << " bytes";
}

TEST(KeptLight, ThatIsNotWholeIsBakedAnew) {
  const LightFolder folder;
  Scene baked = plateOver(0.75);
  lightScene(baked, folder.path);
  const std::filesystem::path file = folder.files().front();
  const std::string whole = contentOf(file);
  std::string changed = whole;
  changed.back() ^= 1;
  for (const std::string& bytes : {std::string(), std::string("junk"), whole.substr(0, 16),
                                   whole.substr(0, 1000), whole + "x", changed}) {
    std::ofstream(file, std::ios::binary) << bytes;
    Scene scene = plateOver(0.75);
    lightScene(scene, folder.path);
    EXPECT_EQ(bytesOf(*scene.parts[0].mesh), bytesOf(*baked.parts[0].mesh)) << bytes.size() << " bytes";
    EXPECT_EQ(contentOf(file), whole) << bytes.size() << " bytes";
  }
}

TEST(KeptLight, IsOfSixteenScenesAndNeedsNoFolder) {
  const LightFolder folder;
  for (int i = 0; i < 18; ++i) {
    Scene scene = slabOver(0.5 + 0.01 * i);
    lightScene(scene, folder.path);
  }
  EXPECT_EQ(folder.files().size(), 16U);
  for (const char* nowhere : {"", "/proc/carom-light"}) {
    Scene scene = plateOver(0.75);
    lightScene(scene, nowhere);
    EXPECT_EQ(bytesOf(*scene.parts[0].mesh).size(),
              4U * static_cast<std::size_t>(scene.parts[0].mesh->GetNumberOfPoints()));
  }
}

}  // namespace
}  // namespace carom
