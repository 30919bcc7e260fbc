#include "engine/text/whole_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace carom {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error = errno) {
  throw NotWritten(file.string(), std::strerror(error));
}

/// Beside the file; no other of this machine's has that name.
std::filesystem::path partOf(std::filesystem::path file) {
  static std::atomic<unsigned> parts = 0;
  file += ".";
  file += std::to_string(::getpid());
  file += "-";
  file += std::to_string(++parts);
  return file += ".partial";
}

}  // namespace

WholeFile::WholeFile(const std::filesystem::path& file) : file_(file) {
  if (file == "-") return;
  std::error_code failed;
  if (std::filesystem::is_symlink(file, failed)) file_ = std::filesystem::weakly_canonical(file, failed);
  if (file_.empty()) fail(file, ENOENT);
  if (std::filesystem::is_directory(file_, failed)) fail(file, EISDIR);
  if (!std::filesystem::is_other(file_, failed)) part_ = partOf(file_);
  out_.open(part_.empty() ? file_ : part_, std::ios::binary);
  if (!out_) fail(file);
}

WholeFile::~WholeFile() {
  std::error_code ignored;
  if (!part_.empty()) std::filesystem::remove(part_, ignored);
}

void WholeFile::add(std::string_view bytes) {
  if (file_ == "-") {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) fail("standard output");
  } else if (!(out_ << bytes)) {
    fail(file_);
  }
}

void WholeFile::commit(std::string_view bytes) {
  add(bytes);
  if (file_ == "-") {
    if (std::fflush(stdout) != 0) fail("standard output");
    return;
  }
  out_.close();
  if (!out_) fail(file_);
  if (part_.empty()) return;
  std::error_code failed;
  std::filesystem::rename(part_, file_, failed);
  if (failed) fail(file_, failed.value());
  part_.clear();
}

}  // namespace carom
