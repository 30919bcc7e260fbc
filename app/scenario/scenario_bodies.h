#pragma once
// Reads the scripted bodies of a scenario file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scenario/scenario.h"
#include "app/toml/toml_file.h"

namespace carom {

/// One leg of a scripted body.
struct ScriptedLeg {
  double from_s = 0.0;  ///< unused for the first leg
  Vec3 u{0.0};
};

/// A body as given in the file, before its world line is computed.
struct BodyText {
  TomlTable table;
  std::string name;
  std::optional<std::filesystem::path> mesh;
  std::optional<std::filesystem::path> history;  ///< instead of all that follows
  Event at;
  std::optional<double> appears_s;
  double spin_rad_s = 0.0;
  std::vector<ScriptedLeg> legs;
  Material material = Material::lacquer;
  bool holds = false;  ///< the side of a soft puck
};

/// Returns the mesh file that a puck or body names, if any.
std::optional<std::filesystem::path> readMesh(const TomlFile& file, const TomlTable& table);

BodyText readBody(const TomlFile& file, const TomlTable& table);

/// Reads the history of a body that has one, a table of text: t_s,x0_m,y0_m,z0_m,x1_m,… with a row a board
/// time. Throws InputErrors with the position of every fault; `file` may be that of a mesh with another
/// number of vertices.
ToldBody toldBody(const BodyText& body, double c_m_s);

/// Computes the world line of a body that has no faults.
ScriptedBody scriptedBody(const BodyText& body, double c_m_s);

}  // namespace carom
