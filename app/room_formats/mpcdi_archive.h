#pragma once
// The files of an MPCDI room: in a zip archive, or beside its .xml. Neither is trusted.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace carom {

class MpcdiArchive {
 public:
  /// Opens a file (InputKind::mpcdi). Throws InputErrors if it cannot be read; if it begins as a zip archive
  /// and is none, has over 1000 files, one by an absolute name or a name that leads out of it, or unpacks to
  /// more than a file of its kind may have, all together.
  explicit MpcdiArchive(const std::filesystem::path& file);

  /// Returns the text of mpcdi.xml. Throws InputErrors if there is none.
  std::string description() const;

  /// Returns the content of a file that the description names. Throws std::runtime_error, in words that can
  /// follow a place of the description, if there is no such file, if its name leads out of the archive or
  /// folder, or if it has over `most` bytes.
  std::string contentOf(const std::string& name, std::size_t most) const;

 private:
  std::filesystem::path file_;
  std::string bytes_;
  bool isZip_ = false;
  std::map<std::string, std::size_t> sizes_;  ///< of the files in the archive, unpacked
};

}  // namespace carom
