#pragma once
// What tells a player that a movie shows all directions, by which it turns with the viewer's head.

#include <cstdint>
#include <filesystem>

namespace carom {

/// How the eyes' pictures of all directions, by longitude and latitude, lie in a movie.
enum class Spherical : std::uint8_t {
  none,      ///< its pictures are no such ones
  mono,      ///< one picture
  topBottom  ///< the left eye's above the right eye's
};

/// Marks a file of the MP4 family as such a movie, by the box in its video track that "Spherical Video RFC",
/// version 1 (Google, 2015), describes. The file's index, `moov`, must be its last box. Throws
/// std::runtime_error, with what is wrong, if it is no such file; it is then as it was.
void markSpherical(const std::filesystem::path& file, Spherical kind);

}  // namespace carom
