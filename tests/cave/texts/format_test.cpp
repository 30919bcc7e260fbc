// Numbers in texts, with the signs of a language.
#include "cave/texts/format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>

#include <fmt/format.h>

#include "cave/texts/language.h"

namespace carom::texts {
namespace {

TEST(Languages, NumbersHaveTheSignsOfTheirLanguage) {
  const auto written = [](const char* code, auto value, const char* how) {
    const Language made(code);
    const InLanguage use(&made);
    return fmt::vformat(how, fmt::make_format_args(localized(value)));
  };
  EXPECT_EQ(written("fr", 1234.5, "{:.1f}"), "1234,5") << "four digits stay together";
  EXPECT_EQ(written("fr", 12345.5, "{:.1f}"), "12\u202F345,5");
  EXPECT_EQ(written("de", -1234567, "{}"), "-1\u202F234\u202F567");
  EXPECT_EQ(written("ja", 12345.5, "{:.1f}"), "12345.5");
  EXPECT_EQ(written("de", 0.5, "{:7.2f}"), "   0,50");
  EXPECT_EQ(written("fr", 1.5e10, "{:.3g}"), "1,5e+10");
  EXPECT_EQ(written("fr", std::nan(""), "{:.1f}"), "nan");
}

TEST(Languages, NumbersAreTheSameButForTheirSigns) {
  std::mt19937_64 random(44);
  std::uniform_real_distribution<double> size(-9.0, 12.0);
  const Language made("fr");
  for (int i = 0; i < 2000; ++i) {
    const double value = std::pow(10.0, size(random)) * (i % 2 ? 1.0 : -1.0);
    for (const char* const how : {"{:.2f}", "{:g}", "{:.0f}", "{:9.3f}"}) {
      const InLanguage use(&made);
      std::string text = fmt::vformat(how, fmt::make_format_args(localized(value)));
      std::string plain;
      for (std::size_t at = 0; at < text.size(); ++at) {
        if (text.compare(at, 3, "\u202F") == 0) {
          at += 2;
        } else {
          plain += text[at] == ',' ? '.' : text[at];
        }
      }
      EXPECT_EQ(plain, fmt::format(fmt::runtime(how), value)) << "seed 44, " << value << " as " << how;
    }
  }
}

}  // namespace
}  // namespace carom::texts
