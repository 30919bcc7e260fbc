#include "cave/warps/warp_file.h"

#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/vwf_file.h"
#include "cave/warps/warp_formats.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

Warp parsed(const std::string& ending, const std::string& content, const glm::ivec2& window_px) {
  if (ending == ".obj") return parseObjWarp(content);
  if (ending == ".pfm") return parsePfmWarp(content);
  if (ending == ".csv") return parseCsvWarp(content);
  if (ending == ".xml" || ending == ".simcad") return parseSimcadWarp(content);
  if (ending == ".sgc") return parseSgcWarp(content);
  if (ending == ".data") return parseBourkeWarp(content, window_px);
  if (ending == ".vwf") return warpOf(parseVwf(content));
  meshFault(1, 1,
            fmt::format("is of a kind that cannot be read, expected a file ending in {}",
                        fmt::join(kWarpEndings, ", ")));
}

}  // namespace

Warp readWarp(const std::filesystem::path& file, const glm::ivec2& window_px) {
  const std::string ending = file.extension().string();
  const InputKind kind = ending == ".vwf" ? InputKind::screenGrid : InputKind::warp;
  try {
    if (const std::string refusal = refusalOf(file, kind); !refusal.empty()) meshFault(1, 1, refusal);
    return parsed(ending, contentOf(file, kind), window_px);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ":" + error.what());
  }
}

}  // namespace carom
