#include "app/input/keyboard_layout.h"

#include <GLFW/glfw3.h>
#include <locale.h>  // NOLINT(modernize-deprecated-headers): for newlocale
#include <wchar.h>   // NOLINT(modernize-deprecated-headers)
#include <wctype.h>  // NOLINT(modernize-deprecated-headers)

#include <algorithm>
#include <array>
#include <climits>

#include "cave/record/time_views.h"
#include "cave/texts/key_names.h"

namespace carom {
namespace {

/// The keys that mean something, by the sign on a US keyboard, which is GLFW's number. No digits, which are
/// printed on each keyboard.
constexpr std::string_view kNamed = ",-.=ABCDEFGHIJKLMNOPQRSTUVWXYZ[]";
static_assert(std::ranges::all_of(kNamedViews,
                                  [](const NamedView& view) {
                                    return view.key == kKeyF11 ||
                                           kNamed.find(static_cast<char>(view.key)) != kNamed.npos;
                                  }),
              "the key of a view is not among those that are named");

/// Names the sign + as its key, if that is not the one of =, which has + with Shift.
void namePlus() {
  const std::string_view key = texts::keyNames.of('=');
  texts::keyNames.set('+', key == "=" ? std::string_view("+") : key);
}

/// The letters of Unicode, for this thread alone and as long as this object lives.
class UnicodeLetters {
 public:
  UnicodeLetters() : before_(uselocale(known())) {}
  ~UnicodeLetters() { uselocale(before_); }
  UnicodeLetters(const UnicodeLetters&) = delete;
  UnicodeLetters& operator=(const UnicodeLetters&) = delete;

 private:
  static locale_t known() {
    static const locale_t utf8 = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);  // always installed on Debian
    return utf8;
  }
  locale_t before_;
};

}  // namespace

std::string asOnKey(std::string_view letters) {
  const UnicodeLetters unicode;
  std::string capitals;
  std::mbstate_t in{}, out{};
  while (!letters.empty()) {
    wchar_t letter = 0;
    const std::size_t bytes = mbrtowc(&letter, letters.data(), letters.size(), &in);
    if (bytes == 0 || bytes > letters.size()) break;  // no UTF-8
    std::array<char, MB_LEN_MAX> written{};
    const std::size_t wrote = wcrtomb(written.data(), static_cast<wchar_t>(towupper(letter)), &out);
    if (wrote > written.size()) break;
    capitals.append(written.data(), wrote);
    letters.remove_prefix(bytes);
  }
  return capitals;
}

void KeyboardLayout::name() {
  for (const char key : kNamed) {
    const char* const printed = glfwGetKeyName(key, 0);
    texts::keyNames.set(key, printed ? asOnKey(printed) : std::string());
  }
  namePlus();
}

std::string keyNamesInUse() {
  std::string names;
  for (const char key : kNamed) names += std::string(texts::keyNames.of(key)) + '\n';
  return names;
}

void useKeyNames(std::string_view names) {
  for (const char key : kNamed) {
    const std::size_t end = names.find('\n');
    if (end == std::string_view::npos) return;
    texts::keyNames.set(key, names.substr(0, end));
    names.remove_prefix(end + 1);
  }
  namePlus();
}

}  // namespace carom
