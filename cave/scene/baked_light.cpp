#include "cave/scene/baked_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <stdexcept>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <tbb/parallel_for.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kReach_m = 3.0;  // of what darkens a place: linearly less with its distance
constexpr double kBounced =
    0.25;  // share of the hall's light that reaches even hidden places, from other surfaces
constexpr double kLampRadius_m = 0.15;
constexpr double kOffSurface_m =
    2e-3;                            // where rays begin, above the surface, and how far from a lamp they end
constexpr double kNearest_m = 1e-3;  // of what can hide: a place where parts meet lies in the other's
                                     // surface, which hides nothing of its front
constexpr int kLampRays = 12, kFewestRays = 8, kMostRays = 64;
constexpr std::size_t kRaysInAll = 8'000'000;  // of the hall's light, so that no scene takes long

/// Returns point i of `count` points that are spread evenly over the unit disc: a spiral with the golden
/// angle.
glm::dvec2 onDisc(int i, int count) {
  const double turned = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
  return std::sqrt((i + 0.5) / count) * glm::dvec2(std::cos(turned), std::sin(turned));
}

/// The casters as Embree knows them. One instruction set and robust intersections, so that every machine
/// finds the same.
class Obstacles {
 public:
  explicit Obstacles(std::span<const ScenePart> casters)
      : device_(rtcNewDevice("isa=sse2,threads=1,set_affinity=0"), rtcReleaseDevice) {
    if (!device_) throw std::runtime_error("Embree cannot begin, so shadows of the hall cannot be computed");
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    for (const ScenePart& part : casters) {
      if (part.paint != Paint::lamp) add(*part.mesh);
    }
    rtcCommitScene(scene_.get());
  }

  /// Returns whether something is in the way of this length.
  bool hide(const glm::dvec3& from_m, const glm::dvec3& along, double length_m) const {
    const glm::vec3 from(from_m), way(along);
    RTCRay ray{};
    ray.org_x = from.x;
    ray.org_y = from.y;
    ray.org_z = from.z;
    ray.dir_x = way.x;
    ray.dir_y = way.y;
    ray.dir_z = way.z;
    ray.tnear = static_cast<float>(kNearest_m);
    ray.tfar = static_cast<float>(length_m);
    ray.mask = ~0U;
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene_.get(), &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_.get(), &context, &ray);
#endif
    return ray.tfar < 0.0F;  // as Embree says that it is hidden
  }

 private:
  void add(vtkPolyData& mesh) {
    const auto points = static_cast<std::size_t>(mesh.GetNumberOfPoints());
    const auto triangles = static_cast<std::size_t>(mesh.GetNumberOfPolys());
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float), points));
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles));
    for (std::size_t i = 0; i < points; ++i) {
      std::array<double, 3> place{};
      mesh.GetPoint(static_cast<vtkIdType>(i), place.data());
      for (std::size_t k = 0; k < 3; ++k) *places++ = static_cast<float>(place[k]);
    }
    const auto cells = vtk::TakeSmartPointer(mesh.GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCurrentCell(count, ids);
      for (vtkIdType k = 0; k < 3; ++k) *corners++ = static_cast<unsigned>(ids[k]);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
  }

  struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device_;
  std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
};

/// Returns the share of a lamp's disc that a place sees.
double seenOfLamp(const Obstacles& obstacles, const glm::dvec3& place_m, const glm::dvec3& normal,
                  const glm::dvec3& lamp_m) {
  if (glm::dot(normal, lamp_m - place_m) <= 0.0) return 0.0;
  int seen = 0;
  for (int i = 0; i < kLampRays; ++i) {
    const glm::dvec3 way_m =
        lamp_m + glm::dvec3(kLampRadius_m * onDisc(i, kLampRays), -kOffSurface_m) - place_m;
    const double length_m = glm::length(way_m);
    if (!obstacles.hide(place_m, way_m / length_m, length_m - kOffSurface_m)) ++seen;
  }
  return static_cast<double>(seen) / kLampRays;
}

/// Returns the share of the hall's light that reaches a place: rays are spread as the light of an even sky
/// falls on a matt surface, by the cosine (Malley's method: evenly over the disc below the hemisphere). Each
/// has a reach of its own, so that an obstacle counts the less the farther it is.
double seenOfHall(const Obstacles& obstacles, const glm::dvec3& place_m, const glm::dvec3& normal, int rays) {
  const glm::dvec3 aside = std::abs(normal.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(aside, normal)), v = glm::cross(normal, u);
  int seen = 0;
  for (int i = 0; i < rays; ++i) {
    const glm::dvec2 at = onDisc(i, rays);
    const glm::dvec3 along = at.x * u + at.y * v + std::sqrt(1.0 - glm::dot(at, at)) * normal;
    const double share = std::fmod((i + 0.5) * std::numbers::phi, 1.0);
    if (!obstacles.hide(place_m, along, kReach_m * share)) ++seen;
  }
  return kBounced + (1.0 - kBounced) * seen / rays;
}

void bakePart(const Obstacles& obstacles, const std::array<glm::dvec3, 3>& lamps_m, int rays,
              vtkPolyData& mesh) {
  vtkDataArray* const normals = mesh.GetPointData()->GetNormals();
  const vtkIdType points = mesh.GetNumberOfPoints();
  const std::span<std::uint8_t> bytes = addLit(mesh);
  vtkDataArray* const places = mesh.GetPoints()->GetData();
  tbb::parallel_for(vtkIdType{0}, points, [&](vtkIdType i) {
    const auto tupleOf = [i](vtkDataArray* array) {
      return glm::dvec3(array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2));
    };
    const glm::dvec3 normal = tupleOf(normals);
    // What stands is lifted off what it stands on, too: no ray begins in the ground and passes below it.
    const glm::dvec3 off(normal.x, normal.y, normal.z + 1.0 - std::abs(normal.z));
    const glm::dvec3 place_m = tupleOf(places) + kOffSurface_m * off;
    const auto set = [&](int k, double share) {
      bytes[static_cast<std::size_t>(4 * i + k)] = static_cast<std::uint8_t>(std::lround(255.0 * share));
    };
    for (int k = 0; k < 3; ++k)
      set(k, seenOfLamp(obstacles, place_m, normal, lamps_m[static_cast<std::size_t>(k)]));
    set(3, seenOfHall(obstacles, place_m, normal, rays));
  });
}

}  // namespace

bool isLit(const ScenePart& part) { return part.body == kRestingBody && part.paint != Paint::lamp; }

std::span<std::uint8_t> addLit(vtkPolyData& mesh) {
  auto lit = vtkSmartPointer<vtkUnsignedCharArray>::New();
  lit->SetName("lit");
  lit->SetNumberOfComponents(4);
  lit->SetNumberOfTuples(mesh.GetNumberOfPoints());
  mesh.GetPointData()->AddArray(lit);
  return {lit->GetPointer(0), static_cast<std::size_t>(lit->GetNumberOfValues())};
}

void bakeLight(Scene& scene) {
  const Obstacles obstacles(scene.casters);
  std::size_t vertices = 1;
  for (const ScenePart& part : scene.parts) {
    if (isLit(part)) vertices += static_cast<std::size_t>(part.mesh->GetNumberOfPoints());
  }
  const int rays = static_cast<int>(std::clamp<std::size_t>(kRaysInAll / vertices, kFewestRays, kMostRays));
  for (const ScenePart& part : scene.parts) {
    if (isLit(part)) bakePart(obstacles, scene.lamps_m, rays, *part.mesh);
  }
}

}  // namespace carom
