#include "cave/scene/seen_mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

#include "cave/mesh_input/mesh_library.h"
#include "engine/light/light_cone.h"
#include "engine/light/sampled_history.h"

namespace carom {
namespace {

vtkSmartPointer<vtkDoubleArray> makeArray(const char* name, int components) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

/// Returns the history of a soft body's points by its rows. Before the first one, if it was soft from the
/// beginning, and after the last, they move as its nodes do there.
SampledHistory historyOf(const SoftModel& model, const SoftHistory& rows, double c_m_s) {
  constexpr double kBefore_m = 1000.0, kAfter_m = 1.0;  // of light
  std::vector<double> times_s;
  std::vector<Vec3> places_m, velocities;
  const auto add = [&](std::size_t k, double later_m) {
    times_s.push_back((rows.row(k).time + later_m) / c_m_s);
    for (const SoftModel::Point& point : model.points) {
      const glm::dvec2 v = rows.velocityAfter(k, point.node), at_m = rows.place(k, point.node) + later_m * v;
      places_m.emplace_back(at_m, 0.5 * model.height_m + point.z_m);
      velocities.emplace_back(v, 0.0);
    }
  };
  if (rows.row(0).wasRigid == 0) add(0, -kBefore_m);
  for (std::size_t k = 0; k < rows.rowCount(); ++k) add(k, 0.0);
  add(rows.rowCount() - 1, kAfter_m);
  return {c_m_s, std::move(times_s), std::move(places_m), std::move(velocities)};
}

/// Collects the seen points of one part after another.
class Gathering {
 public:
  Gathering(const Event& observation, const Lorentz& headFromBoard)
      : observation_(observation), headFromBoard_(headFromBoard) {
    points_->SetDataTypeToDouble();
    body_->SetName("body");
  }

  /// Adds the part's points. Returns the index of each, or -1 if it is unseen.
  std::vector<vtkIdType> addPoints(const ScenePart& part, const WorldLine& line) {
    std::vector<vtkIdType> places;
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      Vec3 offset_m(0.0);
      part.mesh->GetPoint(i, &offset_m.x);
      const std::optional<Emission> seen = emission(line, offset_m, observation_, headFromBoard_);
      places.push_back(seen ? add(*seen, offset_m, part.body) : -1);
    }
    return places;
  }

  /// Adds the points of a soft body.
  std::vector<vtkIdType> addPoints(const SoftModel& model, const SeenBody& body) {
    const SampledHistory history = historyOf(model, *body.rows, headFromBoard_.lightSpeed_m_s());
    std::vector<vtkIdType> places;
    for (std::size_t i = 0; i < model.points.size(); ++i) {
      const Vec3 offset_m(model.relaxed_m[model.points[i].node], model.points[i].z_m);
      std::optional<Emission> seen = history.seenAt(i, observation_, headFromBoard_);
      if (!seen) seen = emission(body.worldLine, offset_m, observation_, headFromBoard_);
      if (seen) seen->properTime_s = body.worldLine.at(seen->event.t_s).properTime_s;
      places.push_back(seen ? add(*seen, offset_m, model.body) : -1);
    }
    return places;
  }

  /// Adds its triangles whose corners are all seen. Returns how many are left out.
  std::size_t addTriangles(const SoftModel& model, const std::vector<vtkIdType>& places) {
    std::size_t leftOut = 0;
    for (std::size_t k = 0; k + 2 < model.surface.size(); k += 3) {
      std::array<vtkIdType, 3> corners{};
      for (std::size_t j = 0; j < 3; ++j) corners[j] = places[model.vertices[model.surface[k + j]].point];
      if (std::any_of(corners.begin(), corners.end(), [](vtkIdType place) { return place < 0; })) {
        ++leftOut;
      } else {
        triangles_->InsertNextCell(3, corners.data());
      }
    }
    return leftOut;
  }

  /// Adds the part's triangles whose corners are all seen. Returns how many are left out.
  std::size_t addTriangles(const ScenePart& part, const std::vector<vtkIdType>& places) {
    std::size_t leftOut = 0;
    const auto cells = vtk::TakeSmartPointer(part.mesh->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
      vtkIdType corners = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCurrentCell(corners, ids);
      std::vector<vtkIdType> placed;
      for (vtkIdType i = 0; i < corners; ++i) {
        if (const vtkIdType place = places[static_cast<std::size_t>(ids[i])]; place >= 0)
          placed.push_back(place);
      }
      if (placed.size() == static_cast<std::size_t>(corners)) {
        triangles_->InsertNextCell(corners, placed.data());
      } else {
        ++leftOut;
      }
    }
    return leftOut;
  }

  vtkSmartPointer<vtkPolyData> mesh() const {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points_);
    mesh->SetPolys(triangles_);
    for (const auto& array : {time_s_, place_m_, properTime_s_, doppler_, offset_m_}) {
      mesh->GetPointData()->AddArray(array);
    }
    mesh->GetPointData()->AddArray(body_);
    return mesh;
  }

 private:
  vtkIdType add(const Emission& seen, const Vec3& offset_m, std::size_t body) {
    time_s_->InsertNextValue(seen.event.t_s);
    place_m_->InsertNextTuple(&seen.event.r_m.x);
    properTime_s_->InsertNextValue(seen.properTime_s);
    doppler_->InsertNextValue(seen.doppler);
    offset_m_->InsertNextTuple(&offset_m.x);
    body_->InsertNextValue(static_cast<int>(body));
    return points_->InsertNextPoint(&seen.seen.dr_m.x);
  }

  Event observation_;
  Lorentz headFromBoard_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> triangles_;
  vtkSmartPointer<vtkDoubleArray> time_s_ = makeArray("t_s", 1), place_m_ = makeArray("r_m", 3),
                                  properTime_s_ = makeArray("proper_time_s", 1),
                                  doppler_ = makeArray("doppler", 1), offset_m_ = makeArray("offset_m", 3);
  vtkNew<vtkIntArray> body_;
};

/// The number of a body's points, and how many of them are unseen.
struct Count {
  std::size_t points = 0;
  std::size_t unseen = 0;
};

const char* statusOf(const Count& count) {
  if (count.unseen == 0) return "seen";
  return count.unseen < count.points ? "partly seen" : "unseen";
}

void addFields(vtkPolyData& mesh, std::span<const SeenBody> bodies, std::span<const Count> counts,
               const Event& observation, double c_m_s) {
  vtkNew<vtkStringArray> names, status;
  names->SetName("body_names");
  status->SetName("status");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    names->InsertNextValue(bodies[i].name);
    status->InsertNextValue(statusOf(counts[i]));
  }
  const auto time_s = makeArray("event_t_s", 1), place_m = makeArray("event_r_m", 3),
             light_m_s = makeArray("light_speed_m_s", 1);
  time_s->InsertNextValue(observation.t_s);
  place_m->InsertNextTuple(&observation.r_m.x);
  light_m_s->InsertNextValue(c_m_s);
  mesh.GetFieldData()->AddArray(names);
  mesh.GetFieldData()->AddArray(status);
  for (const auto& array : {time_s, place_m, light_m_s}) mesh.GetFieldData()->AddArray(array);
}

}  // namespace

SeenMesh seenMesh(const Scene& scene, std::span<const SeenBody> bodies, const Event& observation,
                  const Lorentz& headFromBoard) {
  SeenMesh seen;
  Gathering gathering(observation, headFromBoard);
  std::vector<Count> counts(bodies.size());
  const auto add = [&](const auto& shape, std::size_t body, const std::vector<vtkIdType>& places) {
    const auto unseen = static_cast<std::size_t>(std::count(places.begin(), places.end(), -1));
    counts[body].points += places.size();
    counts[body].unseen += unseen;
    seen.unseenPoints += unseen;
    seen.unseenTriangles += gathering.addTriangles(shape, places);
  };
  for (const ScenePart& part : scene.parts) {
    if (part.paint == Paint::shadow || bodies[part.body].rows) continue;
    add(part, part.body, gathering.addPoints(part, bodies[part.body].worldLine));
  }
  for (const SoftModel& model : scene.soft) {
    if (model.told || !bodies[model.body].rows) continue;
    add(model, model.body, gathering.addPoints(model, bodies[model.body]));
  }
  seen.mesh = gathering.mesh();
  addFields(*seen.mesh, bodies, counts, observation, headFromBoard.lightSpeed_m_s());
  return seen;
}

std::string vtpText(const SeenMesh& seen) { return meshLibrary().vtpOf(*seen.mesh); }

}  // namespace carom
