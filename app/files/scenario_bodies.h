#pragma once
// The scripted bodies of a scenario file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/scenario.h"
#include "app/files/toml_file.h"

namespace carom {

/// One leg of a scripted body.
struct Leg {
  double from_s = 0.0;  ///< of the first leg: unused
  Vec3 u{0.0};
};

/// A body as the file gives it, before its world line can be laid.
struct BodyText {
  TomlTable table;
  std::string name;
  std::optional<std::filesystem::path> mesh;
  Event at;
  std::optional<double> appears_s;
  std::vector<Leg> legs;
};

/// The mesh that a puck or a body names; none if it names none.
std::optional<std::filesystem::path> readMesh(const TomlFile& file, const TomlTable& table);

BodyText readBody(const TomlFile& file, const TomlTable& table);

/// Lays the world line of a body without faults.
ScriptedBody scriptedBody(const BodyText& body, double c_m_s);

}  // namespace carom
