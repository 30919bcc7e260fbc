#include "app/files/whole_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace carom {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::runtime_error(fmt::format("{} cannot be written, expected a place that can", file.string()));
}

}  // namespace

WholeFile::WholeFile(const std::filesystem::path& file) : file_(file) {
  if (file == "-") return;
  std::error_code failed;
  if (std::filesystem::is_symlink(file, failed)) file_ = std::filesystem::weakly_canonical(file, failed);
  if (file_.empty() || std::filesystem::is_directory(file_, failed)) fail(file);
  if (std::filesystem::is_other(file_, failed)) return;
  part_ = file_;
  part_ += fmt::format(".part-{}", ::getpid());
  if (!std::ofstream(part_)) fail(file);
}

WholeFile::~WholeFile() {
  std::error_code ignored;
  if (!part_.empty()) std::filesystem::remove(part_, ignored);
}

void WholeFile::commit(std::string_view text) {
  if (file_ == "-") {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) fail("standard output");
    return;
  }
  std::ofstream out(part_.empty() ? file_ : part_, std::ios::binary);
  out << text;
  out.close();
  if (!out) fail(file_);
  if (part_.empty()) return;
  std::error_code failed;
  std::filesystem::rename(part_, file_, failed);
  if (failed) fail(file_);
  part_.clear();
}

}  // namespace carom
