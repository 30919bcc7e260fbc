#include "cave/process/loaded_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace carom {

const void* loadedLibrary(const std::string& name, const char* offers, const std::string& whatItDoes) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path file = program.parent_path().parent_path() / "lib/carom" / name;
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (const void* const found = library ? dlsym(library, offers) : nullptr) return found;
  throw std::runtime_error(fmt::format("{}: it cannot be loaded, expected the library that {}: {}",
                                       file.string(), whatItDoes, dlerror()));
}

}  // namespace carom
