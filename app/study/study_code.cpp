#include "app/study/study_code.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <cctype>
#include <set>
#include <stdexcept>

#include "app/study/study.h"
#include "app/tables/html_text.h"

namespace carom {
namespace {

/// Returns Luhn's sum modulo 32 of letters; the last one has the weight `weight`, and each one before the
/// other weight of 1 and 2.
std::size_t luhnSum(std::string_view letters, std::size_t weight) {
  const std::size_t n = kCodeLetters.size();
  std::size_t sum = 0;
  for (std::size_t i = letters.size(); i-- > 0; weight = 3 - weight) {
    const std::size_t weighted = weight * kCodeLetters.find(letters[i]);
    sum += weighted / n + weighted % n;
  }
  return sum % n;
}

/// Returns the letter that was meant by a typed one.
char meant(char typed) {
  const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(typed)));
  if (letter == 'O') return '0';
  return letter == 'I' || letter == 'L' ? '1' : letter;
}

/// Returns five letters from the operating system's randomness.
std::string anyFive() {
  std::array<unsigned char, kCodeLength - 1> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the system gives no random numbers, expected some for the codes");
  std::string five;
  for (const unsigned char byte : bytes) five += kCodeLetters[byte % kCodeLetters.size()];  // 256 = 8 · 32
  return five;
}

}  // namespace

char checkLetterOf(std::string_view five) {
  const std::size_t n = kCodeLetters.size();
  return kCodeLetters[(n - luhnSum(five, 2)) % n];
}

std::optional<std::string> codeOf(std::string_view typed) {
  std::string code;
  for (const char letter : typed) {
    if (letter == ' ' || letter == '-') continue;
    code += meant(letter);
    if (code.size() > kCodeLength || kCodeLetters.find(code.back()) == std::string_view::npos) return {};
  }
  if (code.size() != kCodeLength || luhnSum(code, 1) != 0) return {};
  return code;
}

std::vector<std::string> newCodes(std::size_t count) {
  std::vector<std::string> codes;
  std::set<std::string> known;
  while (codes.size() < count) {
    const std::string five = anyFive(), code = five + checkLetterOf(five);
    if (known.insert(code).second) codes.push_back(code);
  }
  return codes;
}

std::string slipsCsv(const std::vector<std::string>& codes) {
  std::string text = "number,code\n";
  for (std::size_t i = 0; i < codes.size(); ++i) text += fmt::format("{},{}\n", i + 1, codes[i]);
  return text;
}

std::string slipsHtml(const std::string& title, const std::vector<std::string>& codes) {
  const std::string name = htmlOf(title);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{} – slips</title>\n"
      "<style>body{{font:12pt sans-serif;margin:8mm;display:grid;grid-template-columns:1fr 1fr;gap:0}}\n"
      "section{{border:1px dashed #777;padding:6mm;break-inside:avoid}}\n"
      "b{{font:bold 26pt monospace;letter-spacing:.15em;display:block;margin:3mm 0}}\n"
      "p{{margin:0;color:#333}}</style></head><body>\n",
      name);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    page += fmt::format(
        "<section><p>{}</p><p>Number {}</p><b>{}</b><p>Keep this slip. With the code you can come again, and "
        "have your data deleted. No list of names exists.</p></section>\n",
        name, i + 1, codes[i]);
  }
  return page + "</body></html>\n";
}

std::string withdrawnMark(const std::string& code) { return sha256Of("withdrawn " + code).substr(0, 5); }

}  // namespace carom
