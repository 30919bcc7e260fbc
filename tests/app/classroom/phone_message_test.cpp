// Messages of phones: those of the contract are read, everything else is refused.
#include "app/classroom/phone_message.h"

#include <gtest/gtest.h>

#include <string>

namespace carom {
namespace {

template <typename Kind>
Kind messageOf(const std::string& bytes) {
  const auto message = phoneMessageOf(bytes);
  EXPECT_TRUE(message && std::holds_alternative<Kind>(*message)) << bytes;
  return message && std::holds_alternative<Kind>(*message) ? std::get<Kind>(*message) : Kind{};
}

TEST(PhoneMessage, IsOneOfFiveKinds) {
  EXPECT_EQ(messageOf<PhoneHello>(R"({"hello": ""})").token, "");
  EXPECT_EQ(messageOf<PhoneHello>(R"({"hello": "00ff"})").token, "00ff");
  const auto answer = messageOf<PhoneAnswer>(R"({"answer": 2, "confidence": 3, "round": 1})");
  EXPECT_EQ(answer.answer, 2);
  EXPECT_EQ(answer.confidence, 3);
  EXPECT_EQ(answer.round, 1);
  EXPECT_EQ(messageOf<PhoneAnswer>(R"({"answer": 1, "round": 2})").confidence, 0);
  EXPECT_EQ(messageOf<PhoneReason>(R"({"reason": "light is late", "round": 1})").words, "light is late");
  EXPECT_EQ(messageOf<TeacherPin>(R"({"pin": "123456"})").pin, "123456");
  EXPECT_EQ(messageOf<TeacherStep>(R"({"do": "explain"})").step, ClassStep::explain);
}

TEST(PhoneMessage, IsNothingElse) {
  const std::string deep = std::string(500, '[') + std::string(500, ']');
  const std::string long1 = R"({"reason": ")" + std::string(kMostMessageBytes, 'a') + R"(", "round": 1})";
  for (const std::string& wrong : {std::string(),
                                   std::string("{"),
                                   std::string("null"),
                                   std::string("[1]"),
                                   std::string("2"),
                                   deep,
                                   long1,
                                   std::string(R"({"answer": 0, "confidence": 3, "round": 1})"),
                                   std::string(R"({"answer": 9, "confidence": 3, "round": 1})"),
                                   std::string(R"({"answer": "2", "confidence": 3, "round": 1})"),
                                   std::string(R"({"answer": 2.0, "round": 1})"),
                                   std::string(R"({"answer": -1, "round": 1})"),
                                   std::string(R"({"answer": 18446744073709551617, "round": 1})"),
                                   std::string(R"({"answer": 2, "confidence": 5, "round": 1})"),
                                   std::string(R"({"answer": 2, "confidence": 0, "round": 1})"),
                                   std::string(R"({"answer": 2, "confidence": 3, "round": 7})"),
                                   std::string(R"({"answer": 2})"),
                                   std::string(R"({"answer": 2, "round": 1, "more": 1})"),
                                   std::string(R"({"reason": 1, "round": 1})"),
                                   std::string(R"({"reason": "a"})"),
                                   std::string(R"({"do": "dance"})"),
                                   std::string(R"({"do": 1})"),
                                   std::string(R"({"pin": 123456})"),
                                   std::string(R"({"hello": null})"),
                                   std::string(R"({"hello": [""]})"),
                                   R"({"hello": ")" + std::string(65, 'a') + "\"}",
                                   std::string(R"({"hello": "", "pin": "1"})"),
                                   std::string("{\"reason\": \"\xff\xfe\", \"round\": 1}"),
                                   std::string("{\"hello\": \"\xc3\"}"),
                                   std::string(R"({"reason": "\ud800", "round": 1})"),
                                   std::string("\0", 1)})
    EXPECT_FALSE(phoneMessageOf(wrong)) << wrong.substr(0, 80);
}

}  // namespace
}  // namespace carom
