#include "cave/mesh_files/pfm_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"

namespace carom {

glm::vec3 PfmGrid::point(std::size_t column, std::size_t row) const {
  glm::vec3 values;
  for (int part = 0; part < 3; ++part) {
    std::array<char, 4> raw{};
    std::memcpy(raw.data(), bytes.data() + byteOf(column, row, static_cast<std::size_t>(part)) - at,
                raw.size());
    if (isBigEndian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    values[part] = std::bit_cast<float>(raw);
  }
  return values;
}

PfmGrid parsePfm(std::string_view content, bool twoEyes, std::size_t mostPoints) {
  MeshLines lines(content);
  const auto line = [&] {
    if (!lines.next()) meshFault(lines.lineNumber() + 1, 1, "the header ends early, expected three lines");
  };
  PfmGrid grid;
  line();
  if (const std::string_view magic = lines.word(); magic != "PF")
    lines.wrong(magic, magic == "Pf" ? "PF, three floats a point" : "a PFM, which begins with PF");
  lines.endLine();
  line();
  for (std::size_t* count : {&grid.columns, &grid.rows}) {
    const std::string_view text = lines.word();
    const auto value = countIn(text);
    const bool isColumns = count == &grid.columns, isPaired = isColumns && twoEyes;
    const std::size_t least = isPaired ? 4 : 2;  // two in each direction for each of the two eyes
    if (!value || *value < least || *value > mostPoints || (isPaired && *value % 2 != 0)) {
      lines.wrong(text, isPaired    ? "an even number of columns from 4, half of them for each eye"
                        : isColumns ? "a number of columns from 2"
                                    : "a number of rows from 2");
    }
    *count = *value;
  }
  lines.endLine();
  line();
  const std::string_view text = lines.word();
  const auto scale = numberIn(text);
  if (!scale || !std::isfinite(*scale) || *scale == 0.0)
    lines.wrong(text, "a scale: negative where the lowest byte comes first");
  lines.endLine();
  grid.isBigEndian = *scale > 0.0;
  grid.bytes = lines.rest();
  grid.at = content.size() - grid.bytes.size();
  // The product cannot overflow: each factor is at most mostPoints, under 2^25.
  if (const std::size_t needed = 12 * grid.columns * grid.rows; grid.bytes.size() != needed) {
    meshFault(
        1, 1,
        fmt::format("{} × {} points take {} bytes behind the header, but there are {}, expected it whole",
                    grid.columns, grid.rows, needed, grid.bytes.size()));
  }
  return grid;
}

}  // namespace carom
