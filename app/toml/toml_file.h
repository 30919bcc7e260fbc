#pragma once
// Strict, typed reading of TOML files. The whole file is read before faults are reported: they are collected
// with their positions and thrown together, so that the user can correct them all at once.

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/file_keys/file_key.h"
#include "app/toml/input_file.h"

namespace carom {

/// One string of an array.
struct PlacedText {
  std::string text;
  FilePlace place;
};

/// A point of an array of points, of two or three coordinates.
struct PlacedPoint {
  std::vector<double> at;  ///< NaN where the file has none
  FilePlace place;
};

/// One table of a file, whose keys are declared (app/file_keys/file_key.h). Each reading function takes one
/// key and throws std::logic_error if no such key of such a type is declared. If its value is wrong, a fault
/// is recorded and a substitute returned (the declared value of a key that is left out, if there is one), so
/// that reading continues. A key without such a value is required. Keys that were never read are faults.
/// Values must not be used before TomlFile::throwFaults has returned. The TomlFile must outlive its tables.
class TomlTable {
 public:
  /// Returns the declaration of a key.
  const FileKey& declared(std::string_view key) const;
  /// Returns whether the key exists; counts as reading it.
  bool has(std::string_view key) const;
  /// Returns whether the key's value is a number; counts as reading it.
  bool isNumber(std::string_view key) const;

  /// Returns whether the key's value is one of the texts that are declared for it; counts as reading it.
  bool isOneOfTexts(std::string_view key) const;

  double number(std::string_view key) const;
  /// Reads a number that is `fallback` where it is left out, and at most `most` if that is given.
  double numberOr(std::string_view key, double fallback, std::optional<double> most = {}) const;
  /// Returns a required number; none if it is absent or wrong.
  std::optional<double> rightNumber(std::string_view key) const;
  /// Reads a whole number that is at most `most` if that is given.
  int integer(std::string_view key, std::optional<int> most = {}) const;
  bool flag(std::string_view key, std::optional<bool> fallback = {}) const;
  std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
  /// Reads a day; none if the key is absent or wrong.
  std::optional<std::chrono::year_month_day> date(std::string_view key) const;
  /// Returns the index of the text among the declared choices; `fallback`, if given, where there is none.
  std::size_t choice(std::string_view key, std::optional<std::size_t> fallback = {}) const;
  /// Reads an array of numbers, whole ones if they are declared so.
  template <std::size_t N>
  std::array<double, N> numbers(std::string_view key) const {
    std::array<double, N> result{};
    readNumbers(key, result);
    return result;
  }
  /// Returns an array of strings, each with its position; empty if the key is absent or its value is not such
  /// an array.
  std::vector<PlacedText> texts(std::string_view key) const;
  /// Returns the same of a key whose value may also be a single string.
  std::vector<PlacedText> oneOrMoreTexts(std::string_view key) const;
  /// Returns an array of points; required. None if the key is absent or not an array of points.
  std::optional<std::vector<PlacedPoint>> points(std::string_view key) const;
  std::optional<TomlTable> table(std::string_view key) const;
  std::optional<TomlTable> requiredTable(std::string_view key) const;
  /// Returns an array of tables; empty if the key is absent. Throws InputErrors if there are more than
  /// `most`, by default those declared, which are then not read.
  std::vector<TomlTable> tables(std::string_view key, std::optional<std::size_t> most = {}) const;

  /// Records a fault if the key exists: a known key that is not allowed here.
  void refuse(std::string_view key, const std::string& why) const;

  /// Returns whether the content is that which the file once had, perhaps on another computer.
  bool isKept() const;

  /// Returns the position of the key's value (of the table if absent), for faults found later.
  FilePlace place(std::string_view key) const;
  FilePlace place() const;
  /// Records a fault.
  void fault(FilePlace where, std::string message) const;
  /// Records a fault of a key's value.
  void fault(std::string_view key, std::string message) const { fault(place(key), std::move(message)); }

 private:
  friend class TomlFile;
  struct State;
  void readNumbers(std::string_view key, std::span<double> result) const;
  explicit TomlTable(std::shared_ptr<State> state) : state_(std::move(state)) {}
  double readNumber(std::string_view key, const Range& range, std::optional<double> fallback) const;
  std::shared_ptr<State> state_;
};

/// The files that a file may name beside the shipped ones: those below its own folder, all links followed, or
/// any. A rig is its operator's, who may name any; all else may come from somebody else. A rig in a session
/// is the operator's only if its file still is what it was.
enum class Reach { ownFolder, anywhere };

class TomlFile {
 public:
  /// Reads the file or, if given, `kept`, the content that the file once had. `keys`: those of its root; they
  /// must outlive this. Files that it names are looked for below `root` first. Throws InputErrors if the file
  /// cannot be read (at 1:1), is too large or nested too deep, or is not TOML.
  TomlFile(const std::filesystem::path& file, const FileKey& keys,
           const std::optional<std::string>& kept = {}, const std::filesystem::path& root = {});
  ~TomlFile();
  TomlFile(const TomlFile&) = delete;
  TomlFile& operator=(const TomlFile&) = delete;

  const TomlTable& root() const;
  /// Returns whether the root has a key, declared or not; does not count as reading it.
  bool contains(std::string_view key) const;
  /// Throws InputErrors if there is any fault so far, including keys that were never read.
  void throwFaults() const;

  /// Returns the file that a key names: as given, beside this file, or in the configuration folder. Records a
  /// fault if it is in none of these, is out of reach, or is no regular file of a size that its kind may
  /// have.
  std::filesystem::path existingFile(const TomlTable& table, std::string_view key, InputKind kind,
                                     Reach reach) const;

 private:
  friend class TomlTable;
  struct Document;
  std::optional<std::filesystem::path> folderOfNamed(Reach reach) const;
  /// Returns the file of the node that handed over this one.
  std::filesystem::path handedFile(const std::filesystem::path& given) const;
  std::unique_ptr<Document> document_;
};

}  // namespace carom
