#pragma once
// The keys of playlists.

#include "app/file_keys/file_key.h"

namespace carom {

const FileKey& playlistKeys();

}  // namespace carom
