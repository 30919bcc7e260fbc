#pragma once
// The whole scene as one eye sees it, as a mesh for ParaView, where it can be turned and measured. Every
// vertex is solved separately in double (engine/light/light_cone.h, `emission`).

#include <cstddef>
#include <span>
#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "cave/scene/scene.h"
#include "engine/soft/soft_history.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Body i of a scene.
struct SeenBody {
  std::string name;
  WorldLine worldLine;
  /// Of a soft puck: the rows of its nodes, from which its soft model is shown instead of its parts. Light
  /// from before the first row of a puck that was rigid then comes from its world line.
  const SoftHistory* rows = nullptr;
};

struct SeenMesh {
  /// Points: emission − observation in the head frame, relative to the eye (metres), for all that is seen.
  /// Point arrays:
  ///   t_s, r_m        the emission event, board frame
  ///   proper_time_s   of the point's own clock then; of a soft puck, its centre's
  ///   doppler         ν_seen/ν_emitted
  ///   body            index into body_names
  ///   offset_m        the point on its body, from its centre, in its rest frame
  /// Field arrays: body_names; status of each body ("seen", "partly seen", "unseen"); event_t_s, event_r_m of
  /// the observation; light_speed_m_s.
  vtkSmartPointer<vtkPolyData> mesh;
  std::size_t unseenPoints = 0;     ///< left out: their light has not arrived
  std::size_t unseenTriangles = 0;  ///< left out with them
};

/// Returns the mesh; `bodies[i]` is body i of the scene. Contact shadows, which are no bodies, are left out.
SeenMesh seenMesh(const Scene& scene, std::span<const SeenBody> bodies, const Event& observation,
                  const Lorentz& headFromBoard);

/// Returns the bytes of a .vtp file; equal meshes give equal bytes.
std::string vtpText(const SeenMesh& seen);

}  // namespace carom
