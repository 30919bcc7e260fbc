#pragma once
// The keys of studies and of their item banks.

#include "app/file_keys/file_key.h"

namespace carom {

const FileKey& studyKeys();
const FileKey& itemBankKeys();

}  // namespace carom
