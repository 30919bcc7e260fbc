#include "app/report/report_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace carom {
namespace {

const ReportLibrary& loaded() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path file = program.parent_path().parent_path() / "lib/carom/libcarom_report.so";
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const offers = library ? dlsym(library, "caromReportLibrary") : nullptr;
  if (!offers)
    throw std::runtime_error(
        fmt::format("{}: it cannot be loaded, expected the library that draws charts and "
                    "writes sculptures: {}",
                    file.string(), dlerror()));
  return *static_cast<const ReportLibrary*>(offers);
}

}  // namespace

const ReportLibrary& reportLibrary() {
  static const ReportLibrary& library = loaded();
  return library;
}

}  // namespace carom
