#pragma once
// People as they are drawn: the head with 3-D glasses, of viewers in the room seen from outside, and all of a
// person of another room: head and shoulders, a hand, and a cue.

#include <array>
#include <cstddef>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <glm/vec3.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/scene/scene.h"
#include "engine/base/limits.h"

namespace carom {

/// A mesh of one colour.
struct ModelPart {
  vtkSmartPointer<vtkPolyData> mesh;
  glm::vec3 colour{1.0F};  ///< linear light, the share reflected
};

/// How far the head's middle is behind the point between the eyes.
inline constexpr double kBehindEyes_m = 0.09;

inline constexpr glm::vec3 kSkin(0.80F, 0.32F, 0.09F);  ///< linear light, as the colours below

/// Colours that tell people apart, also for the colour-blind (Okabe and Ito 2008). Linear light.
inline constexpr std::array<glm::vec3, kMostViewers> kCoatColours{
    {{0.06F, 0.16F, 0.42F}, {0.60F, 0.10F, 0.01F}, {0.01F, 0.30F, 0.16F}, {0.70F, 0.35F, 0.02F}}};

/// Returns the skull with nose and ears, the 3-D glasses before the eyes, and the hair, in metres from the
/// point between the eyes; x right, y forward, z up.
std::vector<ModelPart> headParts();

/// Adds an ellipsoid to a mesh.
void addEllipsoid(MeshBuilder& mesh, const glm::dvec3& middle_m, const glm::dvec3& radii_m);

/// Adds a round limb from one point to another, with these radii there, without its ends.
void addLimb(MeshBuilder& mesh, const glm::dvec3& from_m, const glm::dvec3& to_m, double fromRadius_m,
             double toRadius_m);

/// The bodies of a person of another room, in the order of their numbers in the scene (Scene::firstPerson).
/// Their meshes look, and point, along x.
enum class PersonBody : std::size_t { head, hand, cue };
inline constexpr std::size_t kBodiesOfPerson = 3;

/// Returns the body of a person.
inline std::size_t bodyOf(const Scene& scene, std::size_t person, PersonBody body) {
  return scene.firstPerson + kBodiesOfPerson * person + static_cast<std::size_t>(body);
}

/// Adds the bodies of kMostViewers people of another room to the end of a scene. They have no histories as
/// other bodies do, but paths (engine/linked/told_path.h).
void addPeople(Scene& scene);

}  // namespace carom
