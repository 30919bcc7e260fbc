#pragma once
// From a scenario file to what there is to see of it.

#include <span>
#include <string>
#include <vector>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene.h"
#include "cave/scene/seen_mesh.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Whether OpenGL of this name is a processor's work, without a graphics card.
bool drawsOnProcessor(const std::string& renderer);

/// Fine enough for the rig's finest pixel as a person sees it who stands at the room's origin; `renderer` is
/// what draws (Graphics::rendererName): a processor is given fewer vertices than a graphics card.
Tessellation tessellationFor(const Rig& rig, const std::string& renderer);

/// Table, hall, pucks and scripted bodies; the meshes have been opened.
Scene sceneOf(const Scenario& scenario, const Tessellation& tessellation);

/// Opens every mesh of the scenario. Throws InputErrors with the fault of each that cannot be read.
void openMeshes(const Scenario& scenario);

/// The bodies of the scenario's scene. `pucks`: their world lines.
std::vector<SeenBody> seenBodies(const Scenario& scenario, std::span<const WorldLine> pucks);

/// What an eye at `observation`, whose rest frame is `headFromBoard`, sees of the whole scene: the bytes of a
/// .vtp file (cave/scene/seen_mesh.h). `pucks`: their world lines. Says on standard error how much is unseen.
/// Throws as openMeshes does.
std::string seenSceneVtp(const Scenario& scenario, std::span<const WorldLine> pucks, const Event& observation,
                         const Lorentz& headFromBoard);

}  // namespace carom
