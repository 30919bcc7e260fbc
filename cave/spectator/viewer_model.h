#pragma once
// A model of the viewer for the room seen from outside: a person with 3-D glasses, and a wand.

#include <array>
#include <optional>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/scene/person_model.h"

namespace carom {

/// Meshes in metres; x right, y forward, z up.
struct ViewerModel {
  std::vector<ModelPart> head;  ///< relative to the point between the eyes
  // Relative to the floor below the neck; the eyes are 1 m high.
  std::array<ModelPart, kMostViewers> coats;  ///< one for each viewer, in a colour of their own
  std::vector<ModelPart> below;               ///< neck and hands, trousers, shoes
  ModelPart wand;                             ///< relative to the point where it is held
};
ViewerModel makeViewerModel();

/// Transforms from the model to the room.
struct ViewerPlaces {
  glm::dmat4 roomFromHead{1.0};
  std::optional<glm::dmat4> roomFromCoat;  ///< none if the eyes are too low for a standing person
  std::optional<glm::dmat4> roomFromWand;  ///< none while the hand is not tracked
};
/// Returns the places of the first viewer's figure. `floor_m`: the floor's height along the room's up.
ViewerPlaces viewerPlaces(const SeenFrame& seen, const RoomGeometry& room, double floor_m);

}  // namespace carom
