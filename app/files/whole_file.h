#pragma once
// Output files that appear whole or not at all.

#include <filesystem>
#include <string_view>

namespace carom {

/// A file to be written: made beside its place when constructed, moved there by `commit`. "-" is standard
/// output; devices and pipes are written directly. Throws std::runtime_error, naming the file, where it
/// cannot be written; then, or without commit, nothing is left behind.
class WholeFile {
 public:
  explicit WholeFile(const std::filesystem::path& file);
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile();

  void commit(std::string_view text);

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;  ///< empty where there is nothing to move
};

}  // namespace carom
