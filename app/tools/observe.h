#pragma once
// `carom observe`: what an eye at one event of the board sees of points fixed to bodies.

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/files/scenario.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace CLI {
class App;
}

namespace carom {

/// A point fixed to a puck or a body, from its centre, in its rest frame.
struct BodyPoint {
  std::string body;
  Vec3 offset_m{0.0};
};

/// A point is asked for of something that is not in the scenario.
class UnknownBody : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

struct ObserveOptions {
  std::filesystem::path scenario;
  Event event;                    ///< of the eye, board frame
  Vec3 beta{0.0};                 ///< of the observer, board frame; below 1
  std::vector<BodyPoint> points;  ///< none: the centres of all
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> vtp;  ///< the whole seen scene
};

/// The bytes of the whole seen scene's file: of a scenario and its pucks' world lines, for an eye at an event
/// whose rest frame is `headFromBoard`.
using SeenSceneText = std::function<std::string(const Scenario& scenario, std::span<const WorldLine> pucks,
                                                const Event& observation, const Lorentz& headFromBoard)>;

/// Returns the exit status. Throws InputErrors for a bad scenario, UnknownBody for a wrong name. `seenScene`
/// is what makes the .vtp file; a program built without VTK has none, and refuses.
int runObserve(const ObserveOptions& options, const SeenSceneText& seenScene = {});

/// Adds the command to `app`; when it is called, its exit status is left in `status`. `seenScene`: as of
/// runObserve.
void addObserve(CLI::App& app, int& status, const SeenSceneText& seenScene);

}  // namespace carom
