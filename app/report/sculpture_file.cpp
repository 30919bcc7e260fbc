#include "app/report/sculpture_file.h"

#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/report/report_library.h"
#include "cave/frame/body_colour.h"

namespace carom {
namespace {

struct Format {
  std::string_view ending;
  SculptureFormat format;
};
constexpr std::array<Format, 3> kFormats{
    {{".glb", {"glb2", false, false}}, {".stl", {"stlb", true, true}}, {".3mf", {"3mf", true, false}}}};

const Format* formatOf(const std::filesystem::path& file) {
  for (const Format& format : kFormats)
    if (file.extension() == format.ending) return &format;
  return nullptr;
}

SculptureLook lookOf(const SculpturePart& part) {
  switch (part.kind) {
    case SculpturePartKind::tube:
      return {colourOf(part.name, part.puck), 1.0F, 0.35F};
    case SculpturePartKind::bead:
      return {glm::vec3(0.95F), 1.0F, 0.3F};
    case SculpturePartKind::light:
      return {{1.0F, 0.75F, 0.1F}, 1.0F, 0.6F};
    case SculpturePartKind::base:
      return {{0.02F, 0.22F, 0.09F}, 1.0F, 0.9F};
    case SculpturePartKind::frame:
      return {{0.25F, 0.1F, 0.04F}, 1.0F, 0.6F};
    case SculpturePartKind::cushion:
      return {{0.3F, 0.55F, 0.6F}, 0.18F, 0.1F};
  }
  throw std::logic_error("a part of a sculpture of no kind");
}

}  // namespace

bool isSculptureFile(const std::filesystem::path& file) { return formatOf(file) != nullptr; }

bool isForPrinters(const std::filesystem::path& file) {
  const Format* format = formatOf(file);
  return format != nullptr && format->format.forPrinters;
}

// The library writes a file by its name, beside its place; then it is moved there.
void writeSculpture(const GameSculpture& sculpture, const std::filesystem::path& file) {
  std::vector<SculptureLook> looks;
  for (const SculpturePart& part : sculpture.parts) looks.push_back(lookOf(part));
  std::filesystem::path part = file;
  part += ".part" + std::to_string(getpid());
  const bool isWritten =
      reportLibrary().exportSculpture(sculpture, looks, formatOf(file)->format, part.string());
  std::error_code failed;
  if (isWritten) std::filesystem::rename(part, file, failed);
  if (isWritten && !failed) return;
  std::filesystem::remove(part, failed);
  throw std::runtime_error(file.string() + ": it cannot be written, expected a folder with room for it");
}

}  // namespace carom
