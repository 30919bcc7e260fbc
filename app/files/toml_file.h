#pragma once
// Strict, typed reading of TOML files. The whole file is read before the first complaint: faults are
// gathered with their places and thrown together, so that a person can mend them all at once.

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/input_file.h"

namespace carom {

/// One text of an array.
struct PlacedText {
  std::string text;
  FilePlace place;
};

/// One table of a file. Each reading function asks for one key. Where the key is wrong the fault is noted
/// and a stand-in returned (the fallback if there is one), so that reading goes on; a key without fallback
/// must be there. Keys that nobody asked for are faults. Nothing read may be used before
/// TomlFile::throwFaults has returned. Lives no longer than its TomlFile.
class TomlTable {
 public:
  /// Whether the key is there; counts as asking for it.
  bool has(std::string_view key) const;

  double number(std::string_view key, const Range& range, std::optional<double> fallback = {}) const;
  int integer(std::string_view key, int least, int most, std::optional<int> fallback = {}) const;
  bool flag(std::string_view key, std::optional<bool> fallback = {}) const;
  std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
  /// Index of the text among `names`.
  std::size_t choice(std::string_view key, std::span<const std::string_view> names,
                     std::optional<std::size_t> fallback = {}) const;
  template <std::size_t N>
  std::array<double, N> numbers(std::string_view key, const Range& range,
                                std::optional<std::array<double, N>> fallback = {}) const {
    std::array<double, N> result = fallback.value_or(std::array<double, N>{});
    readNumbers(key, range, fallback.has_value(), false, result);
    return result;
  }
  /// The same for whole numbers.
  template <std::size_t N>
  std::array<double, N> wholeNumbers(std::string_view key, const Range& range,
                                     std::optional<std::array<double, N>> fallback = {}) const {
    std::array<double, N> result = fallback.value_or(std::array<double, N>{});
    readNumbers(key, range, fallback.has_value(), true, result);
    return result;
  }
  /// An array of texts, each with its place; empty where the key is absent. Of one that is none: empty.
  std::vector<PlacedText> texts(std::string_view key) const;
  /// An array of places [x, y, z]; must be there. What is wrong in them: NaN.
  std::vector<std::array<double, 3>> points(std::string_view key) const;
  std::optional<TomlTable> table(std::string_view key) const;
  std::optional<TomlTable> requiredTable(std::string_view key) const;
  /// An array of tables; empty where the key is absent.
  std::vector<TomlTable> tables(std::string_view key) const;

  /// Notes a fault if the key is there: it means something, but not to this program.
  void refuse(std::string_view key, const std::string& why) const;

  /// Of the key's value (of the table where it is absent), for faults found later.
  FilePlace place(std::string_view key) const;
  FilePlace place() const;
  /// Notes a fault.
  void fault(FilePlace where, std::string message) const;
  /// Notes a fault of a key's value.
  void fault(std::string_view key, std::string message) const { fault(place(key), std::move(message)); }

 private:
  friend class TomlFile;
  struct State;
  explicit TomlTable(std::shared_ptr<State> state) : state_(std::move(state)) {}
  void readNumbers(std::string_view key, const Range& range, bool optional, bool whole,
                   std::span<double> result) const;
  std::shared_ptr<State> state_;
};

class TomlFile {
 public:
  /// Throws InputErrors where the file cannot be read (at 1:1), is over 1 MiB or is no TOML.
  /// `kept`: what the file once held, to be read in its stead.
  explicit TomlFile(const std::filesystem::path& file, const std::optional<std::string>& kept = {});
  ~TomlFile();
  TomlFile(const TomlFile&) = delete;
  TomlFile& operator=(const TomlFile&) = delete;

  const TomlTable& root() const;
  /// Throws InputErrors if there is a fault so far; keys nobody has asked for are faults.
  void throwFaults() const;

  /// The file that a key names, as given, beside this file or in the configuration folder; notes a fault
  /// where it is in none of these.
  std::filesystem::path existingFile(const TomlTable& table, std::string_view key) const;

 private:
  friend class TomlTable;
  struct Document;
  std::unique_ptr<Document> document_;
};

}  // namespace carom
