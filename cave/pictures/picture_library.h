#pragma once
// The library that reads and writes pictures as files, loaded when one is wanted: the libraries for JPEG and
// TIFF take longer to load than most commands take to run.

#include "cave/pictures/picture_files.h"

namespace carom {

struct PictureLibrary {
  decltype(&carom::pngOf) pngOf;
  decltype(&carom::pixelBytes) pixelBytes;
};

/// Returns what the library offers, and loads it at the first call (cave/process/loaded_library.h). Throws
/// std::runtime_error that names the file and its fault.
const PictureLibrary& pictureLibrary();

}  // namespace carom
