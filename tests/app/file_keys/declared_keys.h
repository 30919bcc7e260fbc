#pragma once
// The readers against the declarations of keys: a file that has every declared table, and in each a key that
// is not declared. Of such a key the reader says which keys it would have read there; of others, that they
// are missing.

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/file_keys/file_key.h"
#include "app/temporary_folder.h"
#include "app/toml/input_file.h"

namespace carom::test {

using Names = std::set<std::string>;

/// A file as far as it says something of keys.
struct Variant {
  Names leftOut{};                            ///< tables, such as "wall.window"
  std::map<std::string, std::string> more{};  ///< lines of a table
};

/// The text of a file, and in which line each of its tables begins.
struct Skeleton {
  std::string text;
  std::map<int, std::string> tables{};
  int line = 1;

  void add(const std::string& words) {
    text += words + "\n";
    ++line;
  }
  void add(const FileKey& table, const std::string& path, const Variant& variant) {
    tables[line] = path;
    if (!path.empty()) add(table.type == FileKey::Type::table ? "[" + path + "]" : "[[" + path + "]]");
    add("qqqqqqqq = 1");
    if (const auto more = variant.more.find(path); more != variant.more.end()) add(more->second);
    for (const FileKey& key : table.keys) {
      const std::string inner = path.empty() ? key.name : path + "." + key.name;
      if (key.keys.empty() || variant.leftOut.contains(inner)) continue;
      add(key, inner, variant);
      if (!key.notInFirst.empty()) add(key, inner, variant);
    }
  }
};

/// What the reader says of each table: the keys that it reads, and all other faults.
struct Said {
  std::map<std::string, Names> read;
  std::map<std::string, std::string> faults;
};

template <class Read>
void readSkeleton(const FileKey& file, const Variant& variant, const Read& read, Said& said) {
  Skeleton skeleton;
  skeleton.add(file, "", variant);
  const TemporaryFolder folder;
  try {
    read(folder.file("given.toml", skeleton.text));
    FAIL() << "a file of unknown keys was read";
  } catch (const InputErrors& errors) {
    for (const InputError& fault : errors.faults()) {
      const std::string& table = std::prev(skeleton.tables.upper_bound(fault.line()))->second;
      const std::string words = fault.message(), beginning = "unknown key 'qqqqqqqq', expected one of ";
      if (!words.starts_with(beginning)) {
        said.faults[table] += words + "\n";
        continue;
      }
      std::istringstream keys(words.substr(beginning.size()));
      for (std::string key; keys >> key;) said.read[table].insert(key.substr(0, key.find(',')));
    }
  }
}

inline void compare(const FileKey& table, const std::string& path, const Said& said) {
  Names declared;
  for (const FileKey& key : table.keys) {
    declared.insert(key.name);
    const std::string inner = path.empty() ? key.name : path + "." + key.name;
    if (!key.keys.empty()) compare(key, inner, said);
    EXPECT_FALSE(key.sentence.empty()) << inner;
    if (!key.isRequired || !key.keys.empty()) continue;
    const auto faults = said.faults.find(path);
    EXPECT_TRUE(faults != said.faults.end() && faults->second.find(key.name + " ") != std::string::npos)
        << inner << " is declared as required, but is not missing";
  }
  const auto read = said.read.find(path);
  ASSERT_NE(read, said.read.end()) << "no reader opens the table [" << path << "]";
  EXPECT_EQ(read->second, declared) << "in the table [" << path << "]";
}

template <class Read>
void compare(const FileKey& file, const Read& read, const std::vector<Variant>& variants) {
  Said said;
  for (const Variant& variant : variants) readSkeleton(file, variant, read, said);
  compare(file, "", said);
}

}  // namespace carom::test
