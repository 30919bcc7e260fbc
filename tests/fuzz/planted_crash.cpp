// A target that crashes on inputs of more than eight bytes, in the way that the first byte says:
// planted_crash.sh.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size <= 8) return 0;
  if (bytes[0] == 'a') std::abort();
  if (bytes[0] == 'e') throw std::runtime_error("planted");
  if (bytes[0] == 'h') {
    for (volatile bool goesOn = true; goesOn;) {
    }
  }
  if (bytes[0] == 's') *reinterpret_cast<volatile int*>(size & 4) = 1;  // an address that nothing owns
  return 0;
}
