#include "app/commands/cave_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>
#include <stdexcept>

#include "app/journal/linked_game_file.h"
#include "app/operator/visitor_choices.h"
#include "app/rig/rig_viewers.h"
#include "app/toml/config_folder.h"
#include "engine/base/xxh3.h"
#include "engine/linked/seats.h"
#include "engine/text/log.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr std::size_t kMostPucks = 200;

LinkSelf selfOf(const Rig& rig, const LinkAddress& address) {
  const LinkSetup& setup = rig.link.value();
  LinkSelf self;
  self.hosts = address.listens;
  self.room = setup.name;
  self.viewers = namesOf(rig.viewers);
  self.floor = floorOf(rig);
  self.reach_m = setup.reach_m;
  self.gone_s = setup.gone_s;
  self.apart_m = setup.apart_m;
  self.program = CAROM_VERSION;
  return self;
}

/// Returns the scenario's mesh files by their names, each with the digest of its content.
std::vector<LinkWelcome::Mesh> meshesOf(const Scenario& scenario) {
  std::set<std::filesystem::path> files;
  for (const auto& mesh : scenario.puckMeshes)
    if (mesh) files.insert(mesh->file);
  for (const ScriptedBody& body : scenario.bodies)
    if (body.mesh) files.insert(*body.mesh);
  std::vector<LinkWelcome::Mesh> meshes;
  for (const std::filesystem::path& file : files) {
    const std::string content = contentOf(file, InputKind::mesh);
    meshes.push_back({file.filename().string(), XXH3_64bits(content.data(), content.size())});
  }
  return meshes;
}

}  // namespace

std::string whyNotLinked(const Scenario& scenario) {
  const BilliardSetup& game = scenario.billiard;
  if (scenario.lesson) return "it is a lesson, in which every room has its own time";
  if (game.rules.collisionEvent != CollisionEvent::centre)
    return "its pucks turn at once (collision_event = \"contact\"), faster than light";
  const bool isSoft = std::ranges::any_of(game.pucks, [](const Puck& puck) { return puck.soft.has_value(); });
  if (isSoft) return "it has soft pucks, which two rooms do not compute alike to the bit";
  if (game.pucks.size() > kMostPucks)
    return fmt::format("it has {} pucks, expected {} at most", game.pucks.size(), kMostPucks);
  return {};
}

Floor floorOf(const Rig& rig) {
  std::vector<Wall> walls = drawnWalls(rig);
  std::erase_if(walls, [](const Wall& wall) { return wall.sky || wall.onHead; });
  Floor floor;
  if (walls.size() < 2) return floor;
  floor.least_m = glm::dvec2(1e9);
  floor.most_m = glm::dvec2(-1e9);
  for (const Wall& wall : walls) {
    for (const Vec3& corner : {wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m,
                               wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m}) {
      const glm::dvec2 at(glm::dot(corner, rig.axes.right), glm::dot(corner, rig.axes.forward));
      floor.least_m = glm::min(floor.least_m, at);
      floor.most_m = glm::max(floor.most_m, at);
    }
  }
  return floor;
}

LinkKey linkKeyOf(const Rig& rig, const std::filesystem::path& file) {
  if (!rig.link)
    throw std::runtime_error(
        fmt::format("--link: the rig {} has no [link], expected one with name and key", file.string()));
  return LinkKey::read(rig.link->key);
}

CaveLink::CaveLink(const Rig& rig, const std::filesystem::path& rigFile, const LinkAddress& address)
    : address_(address),
      line_(address, linkKeyOf(rig, rigFile)),
      play_(selfOf(rig, address), line_, arithmeticFingerprint()),
      room_(play_, invitedFile(), rig.axes) {
  log::note(
      fmt::format("link: {} with the key {}", address.text(), LinkKey::read(rig.link->key).fingerprint()));
}

std::string CaveLink::invitedFile() { return (configFolder() / "scenarios" / "linked.toml").string(); }

void CaveLink::wait() { room_.begin(true); }

void CaveLink::play(const InputFile& file, Scenario& scenario, const std::vector<HandStroke>* before) {
  LinkedGame game;
  game.scenario = textOf(file);
  game.whyNot = whyNotLinked(scenario);
  if (game.scenario.size() > kMostScenarioBytes)
    game.whyNot =
        fmt::format("its file has {} bytes, expected {} at most", game.scenario.size(), kMostScenarioBytes);
  game.billiard = scenario.billiard;
  game.start = scenario.observer;
  game.meshes = meshesOf(scenario);
  for (const HandStroke& made : before ? *before : std::vector<HandStroke>())
    game.strokes.push_back({made.room, {made.number, static_cast<std::uint32_t>(made.viewer), made.stroke}});
  const double apart_m = play_.self().apart_m.value_or(0.0);
  if (!joins()) scenario.observer = seat(scenario.observer, 0, 2, apart_m);
  play_.play(std::move(game));
  room_.begin(false, before != nullptr);
}

std::string CaveLink::join(Scenario& scenario) {
  const LinkWelcome welcome = room_.invitation().value();
  if (const std::string why = whyNotLinked(scenario); !why.empty()) return why;
  LinkedGame game;
  game.scenario = welcome.scenario;
  game.meshes = meshesOf(scenario);
  for (const LinkWelcome::Mesh& mesh : welcome.meshes) {
    const bool isHere = std::ranges::any_of(game.meshes, [&](const LinkWelcome::Mesh& here) {
      return here.name == mesh.name && here.digest == mesh.digest;
    });
    if (!isHere) return fmt::format("the mesh {} is not here or differs", mesh.name);
  }
  game.billiard = scenario.billiard;
  game.start = scenario.observer;
  scenario.observer = seat(scenario.observer, welcome.room, welcome.rooms, welcome.apart_m);
  play_.join(welcome, std::move(game));
  room_.begin(false);
  return {};
}

void CaveLink::begin(bool isInvited, const InputFile& game, Scenario& scenario) {
  if (!isInvited) return play(game, scenario);
  const std::string why = join(scenario);
  if (why.empty()) return;
  log::error(fmt::format("link: the game of the other room: {}", why));
  refuse(why);
  wait();
}

bool CaveLink::mayChoose(LiveSource& source) {
  const texts::Saying why = room_.whyNotChoose();
  if (!why.empty()) source.announce(why);
  return why.empty();
}

void settleLink(CaveOptions& options, SetupOptions& inputs, bool wasLinked) {
  const Rig rig = readRig(inputs.rig);
  const bool isPlain = !options.frames && (!options.resume || wasLinked) && !options.lesson &&
                       !options.hasClass && options.study.empty();
  if (options.link.empty() && rig.link && isPlain) options.link = rig.link->with;
  if (options.link.empty()) return;
  for (const Wall& wall : rig.walls) {
    if (wall.sky && wall.sky->from_m)
      throw std::runtime_error(fmt::format(
          "--link: wall {} shows what is seen from a place of its own, expected the eyes of viewers",
          wall.name));
  }
  if (linkAddressOf(options.link).listens) return;
  if (!options.isUsualGame)
    throw std::runtime_error("--link: the room that calls plays the other's game, expected no --scenario");
  if (!options.playlist.empty())
    throw std::runtime_error("--link: the room that calls plays the other's games, expected no --playlist");
  options.scenario = fileOfGame(kTwoCities);
  inputs.scenario = {options.scenario, {}};
}

std::unique_ptr<CaveLink> openLink(SessionSetup& setup, const CaveOptions& options,
                                   const SetupOptions& inputs) {
  if (options.link.empty()) return nullptr;
  if (const std::string why = whyNotLinked(setup.scenario); !why.empty())
    throw std::runtime_error(fmt::format("--link: {}: {}", inputs.scenario.file.string(), why));
  auto link = std::make_unique<CaveLink>(setup.rig, inputs.rig.file, linkAddressOf(options.link));
  if (link->joins()) {
    link->wait();
  } else if (options.resume) {
    const auto before = hostedStrokesOf(options.session.value(), setup.scenario.billiard.pucks);
    link->play(inputs.scenario, setup.scenario, &before);
  } else {
    link->play(inputs.scenario, setup.scenario);
  }
  return link;
}

}  // namespace carom
