// Messages of anything, as of a phone of a class.

#include "app/classroom/phone_message.h"

#include <algorithm>

#include "engine/text/plain_words.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace carom;
  const auto message = phoneMessageOf({reinterpret_cast<const char*>(bytes), size});
  if (!message) return 0;
  test::expect(size <= kMostMessageBytes, "only short messages are read");
  if (const auto* answer = std::get_if<PhoneAnswer>(&*message)) {
    test::expect(answer->answer >= 1 && answer->answer <= static_cast<int>(kMostAnswers),
                 "an answer counts from 1");
    test::expect(answer->round >= 1 && answer->round <= static_cast<int>(kVotes), "there are two votes");
    test::expect(answer->confidence >= 0 && answer->confidence <= kMostConfidence,
                 "confidence has four steps");
  }
  if (const auto* reason = std::get_if<PhoneReason>(&*message)) {
    const std::string& words = reason->words;
    test::expect(std::none_of(words.begin(), words.end(),
                              [](char letter) {
                                return static_cast<unsigned char>(letter) < 0x20U || letter == 0x7f;
                              }),
                 "no control sign is left");
    test::expect(words.find("\xe2\x80\xae") == std::string::npos, "no mark of direction is left");
    const auto signs = std::count_if(words.begin(), words.end(), [](char letter) {
      return (static_cast<unsigned char>(letter) & 0xc0U) != 0x80U;
    });
    test::expect(signs <= static_cast<long>(kMostReasonSigns), "a reason is short");
    test::expect(plainWords(words, kMostReasonSigns) == words, "plain words stay as they are");
  }
  return 0;
}
