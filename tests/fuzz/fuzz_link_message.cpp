// Anything that another room could send, cut in any way. The first byte says how it is cut.

#include <algorithm>

#include "app/link/link_stream.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace carom;
  if (size == 0) return 0;
  const std::size_t piece = 1 + bytes[0];
  LinkStream stream;
  std::vector<std::uint8_t> back;
  try {
    for (std::size_t at = 1; at < size; at += piece) {
      stream.add({bytes + at, std::min(piece, size - at)}, 0.0);
      while (const auto message = stream.next()) append(*message, back);
    }
  } catch (const BrokenLink&) {  // the line ends
  }
  test::expect(back.size() < size && std::equal(back.begin(), back.end(), bytes + 1),
               "a message is written as it was read");
  return 0;
}
