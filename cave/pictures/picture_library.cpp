#include "cave/pictures/picture_library.h"

#include "cave/process/loaded_library.h"

namespace carom {

const PictureLibrary& pictureLibrary() {
  static const auto& library = *static_cast<const PictureLibrary*>(
      loadedLibrary("libcarom_pictures.so", "caromPictureLibrary", "reads and writes pictures"));
  return library;
}

}  // namespace carom
