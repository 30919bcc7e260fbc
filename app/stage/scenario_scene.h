#pragma once
// Creates the visible scene from a scenario file.

#include <span>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "cave/mesh/tessellation.h"
#include "cave/record/frame_state.h"
#include "cave/scene/scene.h"
#include "cave/scene/seen_mesh.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Returns a tessellation as fine as the rig's finest pixel seen from the room's origin. A software renderer
/// gets fewer vertices than a GPU.
Tessellation tessellationFor(const Rig& rig, bool inSoftware);

/// Returns the scene of table, hall, pucks and scripted bodies. The meshes must have been opened.
Scene sceneOf(const Scenario& scenario, const Tessellation& tessellation);

/// Which bodies of a scenario the sculpture of its spacetime shows: pucks, those nearest to the middle of the
/// board first, then bodies that move as told, kMostSculpted in all.
struct SculptedBodies {
  std::vector<std::size_t> pucks, bodies;  ///< indices, in their order
  std::size_t leftOut = 0;                 ///< pucks and bodies that are not shown
};
SculptedBodies sculptedBodies(const Scenario& scenario);

/// Returns a body that moves as told as a puck with the outline of its mesh, seen from above; without one, or
/// if that is large or a line from above, as a disc of two centimetres. Throws as openMeshes does.
Puck outlineOf(const ScriptedBody& body);

/// Opens every mesh of the scenario. Throws InputErrors with the fault of each that cannot be read, and
/// std::runtime_error for a told body whose spin would carry a part of it round as fast as light.
void openMeshes(const Scenario& scenario);

/// Does the same to examine a scenario, with little time and memory: warns of large meshes instead of reading
/// them, and keeps none.
void examineMeshes(const Scenario& scenario);

/// Returns the bodies of the scenario's scene. `pucks` are their world lines; `soft`, of every body or none,
/// is kept by reference.
std::vector<SeenBody> seenBodies(const Scenario& scenario, std::span<const WorldLine> pucks,
                                 std::span<const SoftPast> soft = {});

/// Returns the whole scenario as seen by an eye at `observation` with rest frame `headFromBoard`, as the
/// bytes of a .vtp file (cave/scene/seen_mesh.h). `pucks` are their world lines. Prints to standard error how
/// much is unseen. Throws as openMeshes does.
std::string seenSceneVtp(const Scenario& scenario, std::span<const WorldLine> pucks, const Event& observation,
                         const Lorentz& headFromBoard);

}  // namespace carom
