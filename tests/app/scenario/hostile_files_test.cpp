// Every kind of file that a session opens, with everything in its place that is none: named at once, and
// never handed on.

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "app/bad_files.h"
#include "app/journal/session_file.h"
#include "app/languages/glossary.h"
#include "app/languages/po_file.h"
#include "app/rig/rig.h"
#include "app/rig/traces.h"
#include "app/room_formats/mpcdi_file.h"
#include "app/room_import/pvx_file.h"
#include "app/room_import/sgct_file.h"
#include "app/scenario/playlist.h"
#include "app/scenario/scenario.h"
#include "app/stage/handover.h"
#include "app/stage/scenario_scene.h"
#include "app/temporary_folder.h"
#include "app/toml/config_folder.h"

namespace carom {
namespace {

using test::BadThing;
using test::TemporaryFolder;
using Path = std::filesystem::path;

void openScenario(const Path& file) { openMeshes(readScenario(file)); }

void openRig(const Path& file) {
  const Rig rig = readRig(file);
  openTraces(rig);
  openBlends({file, {}}, rig);
  if (!rig.playlist.empty()) readPlaylist(rig.playlist);
}

std::string bodyWith(const std::string& mesh) {
  return "light_speed_m_s = 1\n[[body]]\nname = 'rod'\nmesh = '" + mesh +
         "'\nat = { t_s = 0, r_m = [0, 0, 1] }\n[[body.leg]]\nbeta = [0, 0, 0]\n";
}

/// A rig of one wall with these lines, and with this trace if it has one.
std::string rigWith(const std::string& wall, const std::string& trace = "") {
  return "unit = 'm'\naxes = 'x-right y-up z-back'\n[head]\ntracker = 'head'\n[[tracker]]\nname = "
         "'head'\nkind = " +
         (trace.empty() ? "'simulated'\n" : "'recorded'\nsource = '" + trace + "'\n") +
         "[[wall]]\nname = 'front'\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\nupper_left = [-1, 2, "
         "-1]\n"
         "pixels = [100, 100]\n" +
         wall;
}

/// A rig of a wall with this screen.
std::string rigOf(const std::string& screen) {
  std::string text = rigWith("screen = { " + screen + " }\n");
  const std::size_t from = text.find("lower_left"), to = text.find("pixels");
  return text.erase(from, to - from);
}

std::string gltfWith(const std::string& part) {
  return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 0, "uri": "data:,"}], )" + part + "}";
}

/// A kind of file and a file of ours that names one.
struct Named {
  const char* what;
  InputKind kind;
  const char* name;   ///< of the bad thing
  const char* file;   ///< that names it; empty: it is opened itself
  std::string text;   ///< of that file
  const char* other;  ///< file that `text` is in, if not the one that is opened, which names it as a mesh
  std::function<void(const Path&)> open;
  bool isConfined;  ///< to the folder of what names it
};

const std::vector<Named>& named() {
  static const std::vector<Named> all{
      {"a scenario", InputKind::toml, "bad.toml", "", "", "", openScenario, false},
      {"a rig", InputKind::toml, "bad.toml", "", "", "", openRig, false},
      {"a playlist", InputKind::toml, "bad.toml", "", "", "", [](const Path& file) { readPlaylist(file); },
       false},
      {"a ParaView room", InputKind::xml, "bad.pvx", "", "", "", [](const Path& file) { readPvx(file); },
       false},
      {"an SGCT room", InputKind::json, "bad.json", "", "", "", [](const Path& file) { readSgct(file); },
       false},
      {"a translation", InputKind::translation, "bad.po", "", "", "", [](const Path& file) { readPo(file); },
       false},
      {"a glossary", InputKind::glossary, "bad.txt", "", "", "",
       [](const Path& file) { Glossary::read(file); }, false},
      {"a trace", InputKind::trace, "bad.csv", "", "", "", [](const Path& file) { readTrace(file); }, false},
      {"a session", InputKind::session, "bad.db", "", "", "",
       [](const Path& file) { SessionFile session(file); }, false},
      {"a mesh", InputKind::mesh, "bad.stl", "game.toml", bodyWith("bad.stl"), "", openScenario, true},
      {"a glTF", InputKind::mesh, "bad.glb", "game.toml", bodyWith("bad.glb"), "", openScenario, true},
      {"a buffer", InputKind::meshPart, "bad.bin", "game.toml",
       gltfWith(R"("buffers": [{"byteLength": 1, "uri": "bad.bin"}])"), "model.gltf", openScenario, true},
      {"a picture of a mesh", InputKind::meshPart, "bad.png", "game.toml",
       gltfWith(R"("images": [{"uri": "bad.png"}])"), "model.gltf", openScenario, true},
      {"a game of a playlist", InputKind::toml, "bad.toml", "list.toml", "[[game]]\nscenario = 'bad.toml'\n",
       "", [](const Path& file) { readPlaylist(file); }, true},
      {"a warp", InputKind::warp, "bad.pfm", "rig.toml", rigWith("warp = 'bad.pfm'\n"), "", openRig, false},
      {"a colour's warp", InputKind::warp, "bad.obj", "rig.toml",
       rigWith("warp_red = 'bad.obj'\nwarp_green = 'bad.obj'\nwarp_blue = 'bad.obj'\n"), "", openRig, false},
      {"a screen's mesh", InputKind::screenMesh, "bad.obj", "rig.toml",
       rigOf("shape = 'mesh', file = 'bad.obj'"), "", openRig, false},
      {"a screen's grid", InputKind::screenGrid, "bad.pfm", "rig.toml",
       rigOf("shape = 'grid', file = 'bad.pfm'"), "", openRig, false},
      {"a warp of VIOSO", InputKind::screenGrid, "bad.vwf", "rig.toml", rigWith("warp = 'bad.vwf'\n"), "",
       openRig, false},
      {"an MPCDI room", InputKind::mpcdi, "bad.mpcdi", "", "", "", [](const Path& file) { readMpcdi(file); },
       false},
      {"a blend", InputKind::blend, "bad.png", "rig.toml", rigWith("blend = 'bad.png'\n"), "", openRig,
       false},
      {"a recorded head", InputKind::trace, "bad.csv", "rig.toml", rigWith("", "bad.csv"), "", openRig,
       false},
      {"the playlist of a rig", InputKind::toml, "bad.toml", "rig.toml",
       "playlist = 'bad.toml'\n" + rigWith(""), "", openRig, false}};
  return all;
}

/// Returns what is said when the bad thing has been made in the folder; "" if it was taken.
std::string saidOf(const TemporaryFolder& folder, const Named& input) {
  Path opened = folder / input.name;
  if (*input.file) opened = folder.file(input.file, *input.other ? bodyWith(input.other) : input.text);
  if (*input.other) folder.file(input.other, input.text);
  try {
    input.open(opened);
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(HostileFiles, WhatIsNoFileOfItsKindIsNamedAtOnce) {
  for (const Named& input : named()) {
    for (const BadThing& bad : test::badThings(input.kind)) {
      const TemporaryFolder folder;
      bad.make(folder / input.name);
      const auto start = std::chrono::steady_clock::now();
      const std::string said = saidOf(folder, input);
      const std::string what = std::string(input.what) + ", " + bad.name + ": " + said;
      // A link out of the folder is refused for where it leads.
      const bool isOutside =
          input.isConfined &&
          said.find("outside " + Path(folder / "").parent_path().string()) != std::string::npos;
      const bool isAbsent =
          said.find("is no file") != std::string::npos || said.find("there is no game") != std::string::npos;
      const bool isNamed = said.find(bad.said) != std::string::npos;
      EXPECT_TRUE(isNamed || (isOutside && bad.name == std::string("device")) ||
                  (isAbsent && bad.name == std::string("nothing")))
          << what;
      EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << what;
    }
  }
}

/// A link out of a folder, and a name that leads out of it, to a file that is whole.
TEST(HostileFiles, WhatComesFromOutsideNamesNothingOutsideItsFolder) {
  for (const Named& input : named()) {
    if (!input.isConfined) continue;
    for (const bool byLink : {true, false}) {
      const TemporaryFolder folder;
      std::filesystem::create_directories(folder / "games");
      const auto secret =
          folder.file(std::string("secret") + Path(input.name).extension().string(), "whole\n");
      Named moved = input;
      const std::string name =
          byLink ? "link" + secret.extension().string() : "../" + secret.filename().string();
      if (byLink) std::filesystem::create_symlink(secret, folder / ("games/" + name));
      for (std::size_t at; (at = moved.text.find(input.name)) != std::string::npos;)
        moved.text.replace(at, std::strlen(input.name), name);
      const std::string file = std::string("games/") + input.file,
                        other = std::string("games/") + input.other;
      moved.file = file.c_str();
      if (*input.other) folder.file(other, moved.text);
      const Path opened = folder.file(file, *input.other ? bodyWith(input.other) : moved.text);
      std::string said;
      try {
        input.open(opened);
      } catch (const std::exception& error) {
        said = error.what();
      }
      const std::string real = std::filesystem::canonical(secret).string();
      EXPECT_NE(said.find(real + ", outside "), std::string::npos) << input.what << ": " << said;
      EXPECT_NE(said.find("games"), std::string::npos) << input.what << ": " << said;
    }
  }
}

TEST(HostileFiles, AnOperatorsRigNamesFilesAnywhereAndARecordedOneOnlyWhileItIsTheirs) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "rigs");
  folder.file("head.csv", "time_s,x_m,y_m,z_m\n0,0,1.7,0\n");
  const std::string text = rigWith("", "../head.csv");
  const Path rig = folder.file("rigs/room.toml", text);
  EXPECT_NO_THROW(readRig(rig));
  EXPECT_NO_THROW(readRig(rig, text)) << "as a session has kept it";
  EXPECT_THROW(readRig(rig, text + "# altered\n"), InputErrors);
  EXPECT_THROW(readRig(folder / "rigs/absent.toml", text), InputErrors);
}

TEST(HostileFiles, AGltfThatIsNestedWithoutEndIsRefusedBeforeItsReader) {
  const TemporaryFolder folder;
  folder.file("deep.gltf", R"({"extras": )" + std::string(100'000, '[') + std::string(100'000, ']') + "}");
  try {
    openScenario(folder.file("game.toml", bodyWith("deep.gltf")));
    FAIL() << "was taken";
  } catch (const InputErrors& error) {
    EXPECT_NE(std::string(error.what()).find("deep.gltf:1:1: values are nested too deep"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace carom
