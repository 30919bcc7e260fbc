// What a wall leaves out is nothing that it would show: every shipped rig and scenario, seen by random heads.
//
// More heads by hand: CAROM_HEADS=10000 CAROM_PICTURES=200 tests/with_display
// build/release/bin/app_stage_drawn_test
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/stage/scenario_scene.h"
#include "cave/bodies/visible_chunks.h"
#include "cave/gl/graphics.h"
#include "cave/gl/picture.h"
#include "cave/pictures/image.h"
#include "cave/render/wall_renderer.h"
#include "cave/room/off_axis.h"
#include "cave/screen/curved_screen.h"
#include "engine/billiard/billiard.h"
#include "engine/random_world.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kPlayed_s = 10.0;
constexpr Tessellation kCoarse{0.001, 1000};

std::size_t countFrom(const char* variable, std::size_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::strtoul(text, nullptr, 10) : otherwise;
}

/// Whether a file is a game with soft pucks, which takes minutes to play and is seen by its rows (SeenRows).
bool isSoft(const std::filesystem::path& file) {
  std::ifstream content(file);
  const std::string text(std::istreambuf_iterator<char>(content), {});
  return text.find("[puck.soft]") != std::string::npos;
}

std::vector<std::filesystem::path> shipped(const char* folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR + std::string(folder)))
    if (entry.path().extension() == ".toml" && !isSoft(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// A scenario that has been played for a while, and its scene.
struct Played {
  Scenario scenario;
  Scene scene;
  std::vector<WorldLine> histories;

  explicit Played(const std::filesystem::path& file)
      : scenario(readScenario(file)), scene(sceneOf(scenario, kCoarse)) {
    Billiard billiard(scenario.billiard);
    billiard.advanceTo(kPlayed_s);
    std::vector<WorldLine> lines;
    for (const SeenBody& body : seenBodies(scenario, billiard.worldLines())) lines.push_back(body.worldLine);
    histories = reachingTo(lines, scene.reach_m);
  }
};

/// One eye anywhere in a room that stands and moves anyhow, and what it sees with these switches.
struct RandomEye {
  EyeView eye;
  Lorentz headFromBoard{1.0};
  Switches switches;
  std::vector<BodyView> bodies;

  RandomEye(test::Random& random, const Played& played, bool switched) : bodies(played.scene.bodyCount) {
    const double c_m_s = played.scenario.billiard.lightSpeed_m_s;
    const glm::dquat turned = glm::angleAxis(random.in(0.0, glm::two_pi<double>()), Vec3(0.0, 0.0, 1.0));
    headFromBoard = Lorentz::rotation(turned, c_m_s) * Lorentz::boost(random.u(0.99), c_m_s);
    eye.observation = {random.in(0.0, 0.8 * kPlayed_s), random.inBox(2.5)};
    eye.positionInRoom_m = {random.in(-1.2, 1.2), random.in(-1.2, 1.2), random.in(0.6, 1.9)};
    const auto bit = [&] { return static_cast<std::uint8_t>(random.in(0.0, 1.0) < 0.5); };
    if (switched) switches = {bit(), bit(), bit(), 0, 0};
    for (std::size_t i = 0; i < bodies.size(); ++i)
      viewBody(played.histories[i], eye.observation, headFromBoard, bodies[i], switches);
  }
};

/// Returns the rig's walls, the flat ones of a curved screen, with the floor's origin below the eye, as
/// pixels² pictures.
std::vector<Wall> wallsOf(const std::filesystem::path& file, int pixels) {
  std::vector<Wall> walls;
  for (const Wall& wall : readRig(file).walls) {
    for (Wall& flat : flatWallsOf(wall)) {
      flat.pixels = glm::ivec2(pixels);
      walls.push_back(std::move(flat));
    }
  }
  return walls;
}

/// Returns the places of a chunk's vertices; of a tile's, of those of all levels.
std::vector<Vec3> placesOf(const ChunkedMeshes& meshes, const MeshChunk& chunk, bool tiled) {
  std::vector<Vec3> places;
  if (tiled) {
    const SurfaceTile& tile = meshes.tiles[chunk.tile];
    const auto count = static_cast<std::size_t>((tile.cells[0] + 1) * (tile.cells[1] + 1));
    for (std::size_t k = 0; k < count; ++k)
      places.emplace_back(meshes.tileVertices[tile.firstVertex + k].place_m);
  }
  for (std::size_t k = 0; k < chunk.indexCount; ++k)
    places.emplace_back(meshes.vertices[meshes.indices[chunk.firstIndex + k]].place_m);
  return places;
}

/// Where a chunk's vertices are drawn, by the kernel in double.
std::vector<Vec3> drawnOf(std::span<const Vec3> places_m, const BodyView& body,
                          const glm::dmat4& drawnFromSeen) {
  std::vector<Vec3> drawn;
  for (const Vec3& place_m : places_m) {
    const auto emission = emissionIn(body, place_m);
    const LegView& leg = body.legs[static_cast<std::size_t>(emission.leg)];
    drawn.push_back(kernel::rayThrough(drawnFromSeen, kernel::seenFromEye(leg, emission.event)));
  }
  return drawn;
}

bool liesOn(const glm::dmat4& clipFromDrawn, const Vec3& drawn) {
  const glm::dvec4 clip = clipFromDrawn * glm::dvec4(drawn, 1.0);
  return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

struct Share {
  std::size_t drawn = 0, all = 0;
};

/// Holds every vertex of every chunk that is left out, of meshes as coarse as the tolerance allows, against
/// the walls.
void expectNothingLeftOut(const RandomEye& random, const Vec3& seenFromEye_m, const Scene& scene,
                          const SceneChunks& chunks, VisibleChunks& visible, std::span<const Wall> walls,
                          double tolerance_rad, Share& share) {
  const ViewFrame frame(random.headFromBoard, random.switches);
  visible.look(random.bodies, frame);
  std::map<std::uint32_t, std::vector<Vec3>> drawn;  // of chunks that some wall leaves out
  for (const Wall& wall : walls) {
    const auto projection = clipFromEye(wall, random.eye.positionInRoom_m);
    if (!projection) continue;
    const glm::dmat4 clipFromDrawn = glm::translate(*projection, seenFromEye_m);
    visible.choose(clipFromDrawn, tolerance_rad);
    share.drawn += visible.chosen().size();
    std::vector<bool> chosen(chunks.places);
    for (const std::uint32_t i : visible.chosen()) chosen[i] = true;
    for (std::size_t part = 0; part < chunks.parts.size(); ++part) {
      const ChunkRange& range = chunks.parts[part].rangeOf(visible.levelOf(part));
      share.all += range.count;
      if (scene.parts[part].paint == Paint::shadow) continue;  // the shader moves them: see the pictures
      for (std::uint32_t i = range.firstPlace; i < range.firstPlace + range.count; ++i) {
        if (chosen[i]) continue;
        const auto [at, fresh] = drawn.try_emplace(i);
        if (fresh) {
          const MeshChunk& chunk = chunks.meshes.chunks[range.first + i - range.firstPlace];
          at->second = drawnOf(placesOf(chunks.meshes, chunk, chunks.parts[part].tiled),
                               random.bodies[chunks.parts[part].body], frame.drawnFromSeen.matrix());
        }
        for (const Vec3& place : at->second) ASSERT_FALSE(liesOn(clipFromDrawn, place)) << "chunk " << i;
      }
    }
  }
}

TEST(Culling, NoVertexOnAWallIsLeftOut) {
  const auto rigs = shipped("/rigs"), scenarios = shipped("/scenarios");
  const std::size_t pairs = rigs.size() * scenarios.size();
  const std::size_t heads = countFrom("CAROM_HEADS", pairs) / pairs;
  std::vector<std::vector<Wall>> walls;
  for (const auto& rig : rigs) walls.push_back(wallsOf(rig, 100));
  std::map<std::string, Share> shares;
  Share retarded;
  test::Random random(71);
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    const Played played(scenarios[s]);
    const SceneChunks chunks(played.scene);
    VisibleChunks visible(chunks);
    for (std::size_t i = 0; i < heads * rigs.size(); ++i) {
      const std::filesystem::path& rig = rigs[i % rigs.size()];
      CASE(random, i + s * heads * rigs.size());
      SCOPED_TRACE(rig.filename().string() + ", " + scenarios[s].filename().string());
      const RandomEye eye(random, played, i % 4 == 1);
      const Vec3 walked_m = i % 8 == 3 ? random.inBox(0.5) : Vec3(0.0);  // round a frozen view
      ASSERT_NO_FATAL_FAILURE(expectNothingLeftOut(eye, walked_m, played.scene, chunks, visible,
                                                   walls[i % rigs.size()], i % 3 == 0 ? 0.0 : 0.0005,
                                                   shares[rig.stem().string()]));
    }
  }
  for (const auto& [rig, share] : shares) {
    const double drawn = static_cast<double>(share.drawn) / static_cast<double>(share.all);
    std::printf("%s: %.1f %% of the chunks are drawn on a wall\n", rig.c_str(), 100.0 * drawn);
    EXPECT_LT(drawn, 0.5) << rig;
  }
}

TEST(Culling, PicturesAreThoseOfEverything) {
  const std::size_t pictures = countFrom("CAROM_PICTURES", 8);
  const auto rigs = shipped("/rigs"), scenarios = shipped("/scenarios");
  Graphics graphics;
  test::Random random(72);
  const std::size_t each = (pictures + scenarios.size() - 1) / scenarios.size();
  for (std::size_t s = 0; s < std::min(pictures, scenarios.size()); ++s) {
    // The first few are spread over all scenarios.
    const auto& file = scenarios[s * scenarios.size() / std::min(pictures, scenarios.size())];
    const Played played(file);
    WallRenderer renderer(graphics, played.scene, played.scenario.billiard.lightSpeed_m_s, 4);
    for (std::size_t i = 0; i < each; ++i) {
      CASE(random, i + s * each);
      SCOPED_TRACE(file.filename().string());
      const RandomEye eye(random, played, i % 2 == 1);
      renderer.look(eye.headFromBoard, eye.eye, eye.bodies, eye.switches);
      const std::filesystem::path& rig = rigs[(i + s) % rigs.size()];
      for (const Wall& wall : wallsOf(rig, 200)) {
        RenderTarget culled(wall.pixels), whole(wall.pixels);
        WallDrawing everything;
        everything.everything = true;
        const bool seen = renderer.draw(wall, eye.eye.positionInRoom_m, culled);
        EXPECT_EQ(renderer.draw(wall, eye.eye.positionInRoom_m, whole, everything), seen);
        EXPECT_EQ(readBack(culled).rgb, readBack(whole).rgb) << rig << ", " << wall.name;
      }
    }
  }
}

}  // namespace
}  // namespace carom
