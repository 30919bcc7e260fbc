#pragma once
// `carom observe`: computes what an eye at one board event sees of points fixed to bodies.

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/scenario/scenario.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace CLI {
class App;
}

namespace carom {

/// A point fixed to a puck or a body, relative to its centre, in its rest frame.
struct BodyPoint {
  std::string body;
  Vec3 offset_m{0.0};
};

/// Thrown for a point on a body that is not in the scenario, or that cannot be part of the body.
class UnknownPoint : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A vertex of a told history, counted from 0.
struct ToldVertex {
  std::string body;
  std::size_t vertex = 0;
};

struct ObserveOptions {
  std::filesystem::path scenario;
  Event event;                       ///< of the eye, board frame
  Vec3 beta{0.0};                    ///< of the observer, board frame; below 1
  std::vector<BodyPoint> points;     ///< if none and no vertices either, the centres of all bodies
  std::vector<ToldVertex> vertices;  ///< of told histories
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> vtp;  ///< output file for the whole seen scene
};

/// Returns the bytes of the file of the whole seen scene, from a scenario and its pucks' world lines, for an
/// eye at `observation` with rest frame `headFromBoard`.
using SeenSceneText = std::function<std::string(const Scenario& scenario, std::span<const WorldLine> pucks,
                                                const Event& observation, const Lorentz& headFromBoard)>;

/// Returns the exit status. Throws InputErrors for an invalid scenario, UnknownPoint for a point that is
/// not there. `seenScene` makes the .vtp file; it is empty in a program built without VTK, which then
/// refuses --vtp.
int runObserve(const ObserveOptions& options, const SeenSceneText& seenScene = {});

/// Adds the command to `app`. When it runs, it stores its exit status in `status`. `seenScene` is as in
/// runObserve.
void addObserve(CLI::App& app, int& status, const SeenSceneText& seenScene);

}  // namespace carom
