// Answers of anything, as of a DTRACK controller's command port.

#include <string_view>

#include "devices/protocol/dtrack_answer.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view answer(reinterpret_cast<const char*>(bytes), size);
  for (const std::string_view asked : {std::string_view(), std::string_view("status active")}) {
    const carom::DtrackAnswer read = carom::readDtrackAnswer(answer, asked);
    carom::test::expect(read.text.size() <= 240, "what is shown is short");
    for (const char c : read.text) carom::test::expect(c >= 0x20 && c <= 0x7e, "what is shown is printable");
    const bool ok = read.kind == carom::DtrackAnswer::Kind::ok;
    carom::test::expect(ok == (answer == "dtrack2 ok"), "nothing else is an ok");
  }
  return 0;
}
