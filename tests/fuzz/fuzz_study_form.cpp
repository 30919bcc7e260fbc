// Forms of anything, as of a participant of a study.

#include "app/study/form_fields.h"

#include <algorithm>

#include "app/study/study_code.h"
#include "app/study_data/study_columns.h"
#include "engine/text/plain_words.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace carom;
  const std::string_view form(reinterpret_cast<const char*>(bytes), size);
  const FormFields fields(form);
  for (const char* name : {"go", "token", "step", "item", "answer", "confidence", "reason", "code"}) {
    const std::string& value = fields[name];
    test::expect(value.empty() || fields.has(name), "a value is of a field");
    const int number = fields.number(name, 18, -1);
    test::expect(number >= -1 && number <= 18, "a number is in its range");
    const std::string words = plainWords(value, 200);
    const bool hasControls = std::any_of(words.begin(), words.end(), [](char letter) {
      return static_cast<unsigned char>(letter) < 0x20U || letter == 0x7f;
    });
    test::expect(!hasControls, "no control sign is left");
    test::expect(words.find("\xe2\x80\xae") == std::string::npos, "no mark of direction is left");
    test::expect(plainWords(words, 200) == words, "plain words stay as they are");
    masked(words);
    if (const auto code = codeOf(value))
      test::expect(code->size() == kCodeLength && codeOf(*code) == code, "a code is a code");
  }
  return 0;
}
