// The one name by which the library is known to those that load it (cave/pictures/picture_library.h).
#include "cave/pictures/picture_library.h"

extern "C" const carom::PictureLibrary caromPictureLibrary{carom::pngOf, carom::pixelBytes};
