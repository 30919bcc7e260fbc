#include "app/classroom/phone_message.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>

#include <nlohmann/json.hpp>

namespace carom {
namespace {

using Json = nlohmann::json;

/// Returns whether the object has these keys, and no others but `optional`.
bool hasKeys(const Json& object, std::initializer_list<const char*> keys, const char* optional = nullptr) {
  const bool all =
      std::all_of(keys.begin(), keys.end(), [&](const char* key) { return object.contains(key); });
  const std::size_t more = optional && object.contains(optional) ? 1 : 0;
  return all && object.size() == keys.size() + more;
}

/// Returns the whole number of a key, from 1 to `most`, or none.
std::optional<int> numberIn(const Json& object, const char* key, int most) {
  const Json& value = object[key];
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < 1 ||
      value.get<std::uint64_t>() > static_cast<std::uint64_t>(most))
    return {};
  return value.get<int>();
}

/// Returns the text of a key, or none if it has more than `most` bytes.
std::optional<std::string> textIn(const Json& object, const char* key, std::size_t most) {
  const Json& value = object[key];
  if (!value.is_string() || value.get_ref<const std::string&>().size() > most) return {};
  return value.get<std::string>();
}

std::optional<PhoneMessage> answerIn(const Json& object) {
  const auto answer = numberIn(object, "answer", static_cast<int>(kMostAnswers));
  const auto round = numberIn(object, "round", static_cast<int>(kVotes));
  const bool isTold = object.contains("confidence");
  const auto confidence = isTold ? numberIn(object, "confidence", kMostConfidence) : std::optional(0);
  if (!answer || !round || !confidence) return {};
  return PhoneAnswer{*answer, *confidence, *round};
}

std::optional<PhoneMessage> reasonIn(const Json& object) {
  const auto words = textIn(object, "reason", kMostMessageBytes);
  const auto round = numberIn(object, "round", static_cast<int>(kVotes));
  if (!words || !round) return {};
  return PhoneReason{cleanWords(*words), *round};
}

std::optional<PhoneMessage> messageIn(const Json& object) {
  constexpr std::size_t kMostShort = 64;
  if (!object.is_object()) return {};
  if (hasKeys(object, {"hello"})) {
    if (auto token = textIn(object, "hello", kMostShort)) return PhoneHello{*std::move(token)};
  } else if (hasKeys(object, {"answer", "round"}, "confidence")) {
    return answerIn(object);
  } else if (hasKeys(object, {"reason", "round"})) {
    return reasonIn(object);
  } else if (hasKeys(object, {"pin"})) {
    if (auto pin = textIn(object, "pin", kMostShort)) return TeacherPin{*std::move(pin)};
  } else if (hasKeys(object, {"do"})) {
    const auto name = textIn(object, "do", kMostShort);
    if (const auto step = name ? classStepNamed(*name) : std::nullopt) return TeacherStep{*step};
  }
  return {};
}

/// Returns whether a sign is none to show: controls (Unicode's Cc), marks of direction (UAX 9), separators of
/// lines, signs without width, the mark of byte order, invisible tags.
bool isHidden(std::uint32_t sign) {
  constexpr std::array<std::array<std::uint32_t, 2>, 11> kHidden{{{0x00, 0x1f},
                                                                  {0x7f, 0x9f},
                                                                  {0xad, 0xad},
                                                                  {0x61c, 0x61c},
                                                                  {0x200b, 0x200b},
                                                                  {0x200e, 0x200f},
                                                                  {0x2028, 0x202e},
                                                                  {0x2060, 0x2069},
                                                                  {0xfeff, 0xfeff},
                                                                  {0xfff0, 0xfffb},
                                                                  {0xe0000, 0xe0fff}}};
  return std::any_of(kHidden.begin(), kHidden.end(),
                     [sign](const auto& range) { return sign >= range[0] && sign <= range[1]; });
}

}  // namespace

std::optional<PhoneMessage> phoneMessageOf(std::string_view bytes) {
  if (bytes.size() > kMostMessageBytes) return {};
  constexpr bool kThrows = false;
  return messageIn(Json::parse(bytes, nullptr, kThrows));
}

std::string cleanWords(std::string_view words) {
  std::string clean;
  std::size_t signs = 0;
  for (std::size_t at = 0; at < words.size() && signs < kMostReasonSigns;) {
    const auto lead = static_cast<unsigned char>(words[at]);
    const std::size_t bytes = lead < 0x80U ? 1 : lead < 0xe0U ? 2 : lead < 0xf0U ? 3 : 4;
    std::uint32_t sign = bytes == 1 ? lead : lead & (0xffU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes && at + i < words.size(); ++i)
      sign = sign << 6U | (static_cast<unsigned char>(words[at + i]) & 0x3fU);
    const std::string_view letters = words.substr(at, bytes);
    at += bytes;
    const bool divides = sign == '\n' || sign == '\r' || sign == '\t';
    if (isHidden(sign) && !divides) continue;
    clean += divides ? std::string_view(" ") : letters;
    ++signs;
  }
  return clean;
}

}  // namespace carom
