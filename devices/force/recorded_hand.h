#pragma once
// The recorded movement of a hand: a CSV file whose first line that is no comment is
// `time_s,x_m,y_m,z_m,pressed`. Times increase, and pressed is 0 or 1.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace carom {

struct HandRow {
  double time_s = 0.0;
  glm::dvec3 place_m{0.0};
  bool pressed = false;
};

/// Reads such a file. Throws InputError at its first fault.
std::vector<HandRow> readHandRows(const std::filesystem::path& file);
/// Reads its text; messages call it `name`.
std::vector<HandRow> readHandRows(std::string_view text, const std::string& name);

/// Returns the hand at a time. Between two rows its place is on the line from one to the other, and its
/// button as in the earlier one.
HandRow handAt(const std::vector<HandRow>& rows, double time_s);

}  // namespace carom
