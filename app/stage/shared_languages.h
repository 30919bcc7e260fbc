#pragma once
// The languages of a session on all nodes. Rank 0 reads their files; the others are given the words.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/file_keys/session_languages.h"
#include "cave/cluster/cluster.h"
#include "cave/texts/language.h"

namespace carom {

/// Puts the languages that rank 0 has into use on every rank, with the words beside the `scenarios` of one's
/// own, and returns their names. Windows and plates have their letters from then on. Throws on every rank
/// if a file has errors, or if no font here has the letters of a language.
std::vector<std::string> shareLanguages(const Cluster& cluster, const SessionLanguages& languages,
                                        std::span<const std::string> scenarios);

}  // namespace carom
