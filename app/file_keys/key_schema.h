#pragma once
// The keys of a kind of file as texts: the JSON Schema by which editors complete and check files, and a list
// for people.

#include <string>

#include "app/file_keys/file_key.h"

namespace carom {

/// Returns the JSON Schema (draft 7) of the files whose keys these are.
std::string schemaOf(const FileKey& file);

/// Returns the keys as a page of Markdown: for each table a heading, and of each key its value with range and
/// unit, the value where it is left out, and its meaning.
std::string pageOf(const FileKey& file);

}  // namespace carom
