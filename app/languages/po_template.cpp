#include "app/languages/po_template.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace carom {
namespace {

PoText textOfWords(const std::string& words) { return {words, {}}; }

std::size_t formsOf(const PoFile& file) {
  const auto head = headerOf(file);
  const std::string code = head ? head->language : "";
  return texts::pluralForms(code.substr(0, code.find('_')));
}

/// Returns an entry without a translation.
PoEntry entryOf(const SourceText& source, std::size_t forms) {
  PoEntry entry;
  if (!source.note.empty()) entry.comments.push_back("#. " + source.note);
  if (!source.reference.empty()) entry.comments.push_back("#: " + source.reference);
  entry.context = textOfWords(source.context);
  entry.id = textOfWords(source.english);
  if (!source.plural.empty()) entry.plural = textOfWords(source.plural);
  entry.forms.resize(source.plural.empty() ? 1 : forms);
  return entry;
}

bool hasWords(const PoEntry& entry) {
  return std::ranges::any_of(entry.forms, [](const PoText& form) { return !form.words.empty(); });
}

bool isOf(const PoEntry& entry, const SourceText& source) {
  return entry.id.words == source.english && (entry.plural ? entry.plural->words : "") == source.plural;
}

/// Returns a line "#| msgid …" of the English of before.
std::vector<std::string> linesOfBefore(const PoEntry& old) {
  std::vector<std::string> lines{"#| msgid " + quotedPo(old.id.words)};
  if (old.plural) lines.push_back("#| msgid_plural " + quotedPo(old.plural->words));
  return lines;
}

/// The entries of an old file that wait for a text of today.
class OldEntries {
 public:
  explicit OldEntries(const PoFile& file) {
    for (const bool isObsolete : {false, true}) {
      for (const PoEntry& entry : file.entries) {
        if (entry.isObsolete != isObsolete || !entry.context) continue;
        byContext_.emplace(entry.context->words, &entry);
        byEnglish_.emplace(entry.id.words, &entry);
      }
    }
  }

  const PoEntry* same(const SourceText& source) { return take(byContext_, source.context, source, true); }
  const PoEntry* moved(const SourceText& source) { return take(byEnglish_, source.english, source, true); }
  const PoEntry* changed(const SourceText& source) { return take(byContext_, source.context, source, false); }
  bool isTaken(const PoEntry& entry) const { return taken_.contains(&entry); }

 private:
  using Index = std::unordered_multimap<std::string, const PoEntry*>;

  const PoEntry* take(const Index& index, const std::string& key, const SourceText& source, bool isSame) {
    const PoEntry* found = nullptr;
    const auto [from, to] = index.equal_range(key);
    for (auto entry = from; entry != to; ++entry) {
      if ((isSame && !isOf(*entry->second, source)) || isTaken(*entry->second)) continue;
      // Of several, one that is translated; of these, the first of the file.
      if (!found || std::pair(!hasWords(*entry->second), entry->second) < std::pair(!hasWords(*found), found))
        found = entry->second;
    }
    if (found) taken_.insert(found);
    return found;
  }

  Index byContext_, byEnglish_;
  std::unordered_set<const PoEntry*> taken_;
};

/// Gives an entry what an old one had.
void keep(const PoEntry& old, PoEntry& entry) {
  for (std::size_t i = 0; i < entry.forms.size(); ++i)
    entry.forms[i] = old.forms[std::min(i, old.forms.size() - 1)];
  entry.flags = old.flags;
  entry.before = old.before;
  std::vector<std::string> notes;  // of translators
  std::ranges::copy_if(old.comments, std::back_inserter(notes), [](const std::string& line) {
    return !line.starts_with("#.") && !line.starts_with("#:");
  });
  entry.comments.insert(entry.comments.begin(), notes.begin(), notes.end());
}

}  // namespace

PoFile templateOf(std::span<const SourceText> sources) {
  PoFile file;
  PoEntry& head = file.head.emplace();
  head.forms.push_back(
      textOfWords("Project-Id-Version: Carom\nLanguage: \nMIME-Version: 1.0\n"
                  "Content-Type: text/plain; charset=UTF-8\nContent-Transfer-Encoding: 8bit\n"));
  constexpr std::size_t kForms = 2;  // of English
  for (const SourceText& source : sources) file.entries.push_back(entryOf(source, kForms));
  return file;
}

UpdatedPo updated(const PoFile& old, std::span<const SourceText> sources) {
  UpdatedPo result;
  result.file.path = old.path;
  result.file.head = old.head;
  OldEntries waiting(old);
  std::vector<const PoEntry*> kept;
  for (const SourceText& source : sources) kept.push_back(waiting.same(source));
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!kept[i]) kept[i] = waiting.moved(sources[i]);
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    PoEntry& entry = result.file.entries.emplace_back(entryOf(sources[i], formsOf(old)));
    const PoEntry* before = kept[i] ? kept[i] : waiting.changed(sources[i]);
    if (!before) {
      ++result.added;
      continue;
    }
    keep(*before, entry);
    if (kept[i] || !hasWords(entry)) continue;
    ++result.changed;
    if (!entry.isFuzzy()) {
      entry.flags.insert(entry.flags.begin(), "fuzzy");
      entry.before = linesOfBefore(*before);
    }
  }
  for (const PoEntry& entry : old.entries) {
    if (waiting.isTaken(entry) || !hasWords(entry)) continue;
    result.gone += entry.isObsolete ? 0 : 1;
    PoEntry& obsolete = result.file.entries.emplace_back(entry);
    obsolete.isObsolete = true;
    obsolete.before.clear();
    std::erase_if(obsolete.comments,
                  [](const std::string& line) { return line.starts_with("#.") || line.starts_with("#:"); });
  }
  return result;
}

}  // namespace carom
