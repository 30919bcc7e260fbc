#pragma once
// Templates for translators, and new English brought into a translation.

#include <cstddef>
#include <span>

#include "app/languages/po_file.h"
#include "app/languages/source_text.h"

namespace carom {

/// Returns a file with these texts, none translated, in their order: always the same.
PoFile templateOf(std::span<const SourceText> sources);

/// A translation with the English of today.
struct UpdatedPo {
  PoFile file;
  std::size_t added = 0;    ///< texts that are new
  std::size_t changed = 0;  ///< whose English is another now: marked fuzzy, with the English of before
  std::size_t gone = 0;     ///< translations of texts that are no longer there, kept as obsolete
};

/// Returns a translation with these texts, in their order. Translations stay with their name and English, or
/// with their English where names have moved ("caption 2 text"); where only the name is the same they are
/// fuzzy. Notes of translators and the header stay. Texts that come back take up their obsolete translations.
UpdatedPo updated(const PoFile& old, std::span<const SourceText> sources);

}  // namespace carom
