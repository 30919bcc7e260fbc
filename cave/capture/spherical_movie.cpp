#include "cave/capture/spherical_movie.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace carom {
namespace {

constexpr std::size_t kHeader = 8;           // a box's size and name
constexpr std::size_t kMostIndex = 1 << 28;  // bytes: a movie of days

/// Returns a number of so many bytes, the highest first.
std::uint64_t numberAt(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

void putSize(std::string& bytes, std::size_t at, std::size_t size) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(size >> (8 * (3 - i)) & 0xFFU);
}

/// Returns where the first box of a name begins among those from one place to another.
std::optional<std::size_t> boxIn(std::string_view bytes, std::size_t from, std::size_t to,
                                 std::string_view name) {
  while (from + kHeader <= to) {
    const std::size_t size = numberAt(bytes, from, 4);
    if (size < kHeader || size > to - from) return std::nullopt;
    if (bytes.substr(from + 4, 4) == name) return from;
    from += size;
  }
  return std::nullopt;
}

std::string sphericalBox(Spherical kind) {
  constexpr std::string_view kUuid = "\xff\xcc\x82\x63\xf8\x55\x4a\x93\x88\x14\x58\x7a\x02\x52\x1f\xdd";
  const std::string words = fmt::format(
      "<?xml version=\"1.0\"?><rdf:SphericalVideo "
      "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
      "xmlns:GSpherical=\"http://ns.google.com/videos/1.0/spherical/\">"
      "<GSpherical:Spherical>true</GSpherical:Spherical><GSpherical:Stitched>true</GSpherical:Stitched>"
      "<GSpherical:StitchingSoftware>Carom</GSpherical:StitchingSoftware>"
      "<GSpherical:ProjectionType>equirectangular</GSpherical:ProjectionType>{}</rdf:SphericalVideo>",
      kind == Spherical::topBottom ? "<GSpherical:StereoMode>top-bottom</GSpherical:StereoMode>" : "");
  std::string box(4, '\0');
  box.append("uuid").append(kUuid).append(words);
  putSize(box, 0, box.size());
  return box;
}

/// Returns the index with the box at the end of its first track.
std::string withBox(std::string index, Spherical kind) {
  const auto track = boxIn(index, kHeader, index.size(), "trak");
  if (!track) throw std::runtime_error("it has no track");
  const std::size_t size = numberAt(index, *track, 4);
  const std::string box = sphericalBox(kind);
  index.insert(*track + size, box);
  putSize(index, *track, size + box.size());
  putSize(index, 0, index.size());
  return index;
}

}  // namespace

void markSpherical(const std::filesystem::path& file, Spherical kind) {
  if (kind == Spherical::none) return;
  const std::uint64_t size = std::filesystem::file_size(file);
  std::fstream movie(file, std::ios::in | std::ios::out | std::ios::binary);
  std::uint64_t at = 0;
  while (at + kHeader <= size) {
    std::string header(2 * kHeader, '\0');
    movie.seekg(static_cast<std::streamoff>(at));
    movie.read(header.data(), static_cast<std::streamsize>(header.size()));
    movie.clear();
    const std::uint64_t small = numberAt(header, 0, 4);
    const std::uint64_t box = small == 1 ? numberAt(header, kHeader, 8) : small == 0 ? size - at : small;
    if (box < kHeader || box > size - at) break;
    if (header.compare(4, 4, "moov") != 0) {
      at += box;
      continue;
    }
    if (at + box != size || small != box || box > kMostIndex) break;
    std::string index(box, '\0');
    movie.seekg(static_cast<std::streamoff>(at));
    movie.read(index.data(), static_cast<std::streamsize>(box));
    index = withBox(std::move(index), kind);
    movie.seekp(static_cast<std::streamoff>(at));
    movie.write(index.data(), static_cast<std::streamsize>(index.size()));
    if (!movie.flush()) throw std::runtime_error("the movie cannot be written");
    return;
  }
  throw std::runtime_error("it is no MP4 file with its index at the end");
}

}  // namespace carom
