#include "engine/text/outside_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "engine/text/input_error.h"

namespace carom {
namespace {

/// In the order of InputKind. A TOML file of 16 MiB holds a hundred thousand pucks, a trace of 512 MiB
/// eighteen hours at 60 Hz; a session of a day has some 10 GiB; no reader keeps more than one frame of it.
constexpr std::array<InputLimit, 14> kInputLimits{{{"a TOML file", 16},
                                                   {"a JSON file", 16},
                                                   {"an XML file", 16},
                                                   {"a trace", 512},
                                                   {"a mesh", 256},
                                                   {"a buffer or picture of a mesh", 256},
                                                   {"a warp mesh", 64},
                                                   {"a picture", 256},
                                                   {"a session file", 1ULL << 30U},
                                                   {"a mesh of a screen", 128},
                                                   {"a grid of a screen", 256},
                                                   {"an MPCDI file", 256},
                                                   {"a PO file", 16},
                                                   {"a glossary", 1}}};

/// A regular file that is open for reading, or the reason why it is not.
class OpenedFile {
 public:
  OpenedFile(const std::filesystem::path& file, InputKind kind) : limit_(limitOf(kind)) { open(file); }
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;
  ~OpenedFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  const std::string& refusal() const { return refusal_; }

  std::string refusalBySize() const { return bytes_ > most() ? tooLarge(bytes_) : ""; }

  /// Reads at most `most` bytes. Some files have another length than they say, such as those in /proc: the
  /// largest size is that of the part that is read.
  std::string read(std::uintmax_t most) {
    std::string content;
    constexpr std::uintmax_t kLeast_bytes = 1 << 12, kMost_bytes = 1 << 20;  // at once
    while (content.size() < most) {
      const std::size_t before = content.size();
      const std::uintmax_t left = bytes_ > before ? bytes_ - before : 0;
      const auto step =
          static_cast<std::size_t>(std::min(std::clamp(left, kLeast_bytes, kMost_bytes), most - before));
      content.resize(before + step);
      const ssize_t got = ::read(descriptor_, content.data() + before, step);
      content.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
      if (got < 0 && errno != EINTR) refuse(errno);
      if (got == 0 || !refusal_.empty()) break;
    }
    return content;
  }

  std::uintmax_t most() const { return limit_.most_MiB << 20U; }

  std::string tooLarge(std::uintmax_t bytes) const {
    return "the file is too large, " + std::to_string((bytes + (1U << 20U) - 1) >> 20U) +
           " MiB, expected at most " + std::to_string(limit_.most_MiB) + " MiB";
  }

 private:
  void open(const std::filesystem::path& file) {
    struct stat state {};
    if (::stat(file.c_str(), &state) != 0) return refuse(errno);
    if (!S_ISREG(state.st_mode)) return refuseKind(state.st_mode);
    // Another file may have taken its place: O_NONBLOCK does not wait for the other end of a pipe.
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0 || ::fstat(descriptor_, &state) != 0) return refuse(errno);
    if (!S_ISREG(state.st_mode)) return refuseKind(state.st_mode);
    bytes_ = static_cast<std::uintmax_t>(state.st_size);
  }
  void refuse(int error) {
    const std::string expected = ", expected " + std::string(limit_.what);
    refusal_ = error == ENOENT || error == ENOTDIR
                   ? "there is no such file" + expected
                   : std::string("the file cannot be read (") + std::strerror(error) + ")" + expected;
  }
  void refuseKind(mode_t mode) {
    refusal_ = std::string(S_ISDIR(mode)    ? "this is a folder"
                           : S_ISFIFO(mode) ? "this is a pipe"
                           : S_ISSOCK(mode) ? "this is a socket"
                                            : "this is a device") +
               ", expected " + std::string(limit_.what);
  }

  const InputLimit& limit_;
  int descriptor_ = -1;
  std::uintmax_t bytes_ = 0;
  std::string refusal_;
};

/// Returns the path without links; empty if there is no such file.
std::filesystem::path realPath(const std::filesystem::path& path) {
  std::error_code failed;
  const auto real = std::filesystem::canonical(path.empty() ? "." : path, failed);
  return failed ? std::filesystem::path() : real;
}

}  // namespace

const InputLimit& limitOf(InputKind kind) { return kInputLimits[static_cast<std::size_t>(kind)]; }

std::string refusalOf(const std::filesystem::path& file, InputKind kind) {
  const OpenedFile opened(file, kind);
  return opened.refusal().empty() ? opened.refusalBySize() : opened.refusal();
}

std::string contentOf(const std::filesystem::path& file, InputKind kind) {
  OpenedFile opened(file, kind);
  std::string refusal = opened.refusal().empty() ? opened.refusalBySize() : opened.refusal();
  std::string content = refusal.empty() ? opened.read(opened.most() + 1) : "";
  if (refusal.empty()) refusal = opened.refusal();
  if (refusal.empty() && content.size() > opened.most()) refusal = opened.tooLarge(content.size());
  if (!refusal.empty()) throw InputError(file.string(), 1, 1, refusal);
  return content;
}

std::string beginningOf(const std::filesystem::path& file, InputKind kind, std::size_t most) {
  OpenedFile opened(file, kind);
  std::string content = opened.refusal().empty() ? opened.read(most) : "";
  if (!opened.refusal().empty()) throw InputError(file.string(), 1, 1, opened.refusal());
  return content;
}

bool liesBelow(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto real = realPath(file), root = realPath(folder);
  if (real.empty() || root.empty()) return false;
  return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
}

std::string outsideWords(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return realPath(file).string() + ", outside " + realPath(folder).string();
}

}  // namespace carom
