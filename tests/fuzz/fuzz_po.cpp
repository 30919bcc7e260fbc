// PO files of anything, by themselves and held against texts.

#include <string>
#include <string_view>

#include "app/languages/po_template.h"
#include "app/languages/text_values.h"
#include "app/languages/translation_rules.h"
#include "fuzz/expect.h"

namespace {

const carom::TranslationRules& rules() {
  static const carom::TranslationRules all{
      .code = "fr",
      .sources = {
          {.context = "a.b", .english = "light {:.2f} m/s, F5", .plural = {}, .note = {}, .reference = {}},
          {.context = "a.c", .english = "{} puck", .plural = "{} pucks", .note = "Counted.", .reference = {}},
          {.context = "angles.toml title",
           .english = "A puck",
           .plural = {},
           .note = {},
           .reference = "angles.toml:1",
           .hasValues = false}}};
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace carom;
  const std::string_view content(reinterpret_cast<const char*>(bytes), size);
  keysOf(content, false);
  valuesOf(content);
  printfValuesOf(content);
  try {
    const PoFile file = parsePo("a.po", content);
    const std::string text = textOf(file);
    test::expect(textOf(parsePo("a.po", text)) == text, "what is written reads the same again");
    const JudgedTranslation judged = judge(file, rules());
    for (const Translated& one : judged.translated) {
      const SourceText& source = rules().sources.at(one.source);
      test::expect(one.forms.size() == (source.plural.empty() ? 1U : 2U), "a text has its forms");
      if (!source.hasValues) continue;
      for (const std::string& form : one.forms)
        test::expect(valuesOf(form).values == valuesOf(source.english).values, "a text has its values");
    }
    const UpdatedPo now = updated(file, rules().sources);
    const UpdatedPo again = updated(parsePo("a.po", textOf(now.file)), rules().sources);
    test::expect(textOf(again.file) == textOf(now.file), "an update of an update changes nothing");
    test::expect(again.added == 0 && again.gone == 0, "nor counts anything");
  } catch (const InputErrors& errors) {
    test::expect(errors.faults().size() <= kMostFindings, "a file has so many faults");
  }
  return 0;
}
