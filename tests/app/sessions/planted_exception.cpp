// Loaded into the program by LD_PRELOAD: once the file exists that CAROM_PLANTED_AT names, the frame loop's
// next look for keys ends by an exception, as anything in it could.
#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

extern "C" void glfwPollEvents() {
  const char* at = std::getenv("CAROM_PLANTED_AT");
  if (at && access(at, F_OK) == 0) throw std::runtime_error("a planted exception");
  using Poll = void (*)();
  static const Poll poll = reinterpret_cast<Poll>(dlsym(RTLD_NEXT, "glfwPollEvents"));
  poll();
}
