#pragma once
// Output files that appear whole or not at all.

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace carom {

/// A file cannot be written. `what()` names it; `reason()` is the system's, in its words.
class NotWritten : public std::runtime_error {
 public:
  NotWritten(const std::string& file, std::string reason)
      : std::runtime_error(file + " cannot be written, expected a place that can"),
        reason_(std::move(reason)) {}
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// A file to be written: made beside its place when constructed, moved there by `commit`. "-" is standard
/// output; devices and pipes are written directly. Throws NotWritten where it cannot be written; then, or
/// without commit, nothing is left behind. Several threads may write the same file: one of them is last.
class WholeFile {
 public:
  explicit WholeFile(const std::filesystem::path& file);
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile();

  /// Adds to what `commit` will leave in its place; standard output, devices and pipes get it at once.
  void add(std::string_view bytes);
  void commit(std::string_view bytes = {});

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;  ///< empty where there is nothing to move
  std::ofstream out_;           ///< not open for standard output
};

}  // namespace carom
