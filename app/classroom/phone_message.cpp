#include "app/classroom/phone_message.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include <nlohmann/json.hpp>

#include "engine/text/plain_words.h"

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
  return PhoneReason{plainWords(*words, kMostReasonSigns), *round};
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

}  // namespace

std::optional<PhoneMessage> phoneMessageOf(std::string_view bytes) {
  if (bytes.size() > kMostMessageBytes) return {};
  constexpr bool kThrows = false;
  return messageIn(Json::parse(bytes, nullptr, kThrows));
}

}  // namespace carom
