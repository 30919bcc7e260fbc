#pragma once
// A class of phones and a teacher, without sockets.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/classroom/classroom.h"

namespace carom::test {

using Json = nlohmann::json;

inline const ClassQuestion kQuestion{
    "twins.toml", "Twins", "Who is older?", {"Neither", "At home", "Who flew"}, 1};

class Class : public testing::Test {
 protected:
  Class() { room_.follow({kQuestion, LessonPhase::asks}, 0.0); }

  /// Lets a phone join, which has the token if it brings one. Returns its connection.
  Classroom::Id phone(const std::string& token = "") {
    const Classroom::Id id = ++ids_;
    room_.connect(id, "10.0.0." + std::to_string(id));
    room_.receive(id, PhoneHello{token}, now_s_);
    return id;
  }
  Classroom::Id teacher() {
    const Classroom::Id id = ++ids_;
    room_.connect(id, "10.0.1.1");
    room_.receive(id, TeacherPin{"123456"}, now_s_);
    return id;
  }
  Json told(Classroom::Id id) { return Json::parse(room_.messageFor(id)); }
  Json answer(Classroom::Id id, int answer, int round = 1, int confidence = 2) {
    room_.receive(id, PhoneAnswer{answer, confidence, round}, now_s_);
    return told(id);
  }
  void take(ClassStep step) { EXPECT_FALSE(room_.take(step, now_s_)) << static_cast<int>(step); }
  std::vector<Classroom::Id> phones(int count) {
    std::vector<Classroom::Id> all;
    for (int i = 0; i < count; ++i) all.push_back(phone());
    return all;
  }

  double now_s_ = 100.0;
  Classroom::Id ids_ = 0;
  int tokens_ = 0;
  Classroom room_{{"http://127.0.0.1:8080/", "KIWI", "123456"},
                  [this] { return "token-" + std::to_string(++tokens_); }};
};

}  // namespace carom::test
