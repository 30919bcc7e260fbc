#pragma once
// One message of each kind, with values of its own in every field.

#include <vector>

#include "app/link/link_message.h"

namespace carom::test {

inline LinkStroke sampleStroke(std::uint32_t number) {
  LinkStroke stroke{1, {number, 2, {}}};
  stroke.told.stroke.puck = 2;
  stroke.told.stroke.at_s = 12.5 + number;
  stroke.told.stroke.from_m = Vec3(-0.25, 1.5, 0.125);
  stroke.told.stroke.momentum_kg_m_s = {0.1, -0.2};
  stroke.told.stroke.offset_m = 0.01;
  return stroke;
}

inline LinkPresent samplePresent() {
  LinkPresent message;
  message.room = 1;
  message.present = {77, 3, true, {}, 2};
  for (std::size_t i = 0; i < 2; ++i) {
    const double t_s = 20.0 + static_cast<double>(i);
    message.present.persons[i] = {{t_s, Vec3(1.0, 2.0, 0.9)},
                                  {t_s + 0.5, Vec3(1.1, 2.0, 0.9)},
                                  {t_s + 0.5, Vec3(1.2, 2.25, 0.9)},
                                  t_s - 1.0};
    message.persons[i] = {
        glm::angleAxis(0.5, Vec3(0.0, 0.0, 1.0)), Vec3(0.5, 0.0, -0.25), 3, Vec3(0.1, 0.0, 0.2), 7, 2};
  }
  message.boardFromRoom = (Lorentz::boost(Vec3(0.3, -0.4, 0.0), 1.42) *
                           Lorentz::rotation(glm::angleAxis(1.0, Vec3(0.0, 0.0, 1.0)), 1.42))
                              .matrix();
  return message;
}

/// In the order of their numbers.
inline std::vector<LinkMessage> sampleMessages() {
  LinkHello hello;
  hello.arithmetic = 0x123456789abcdef0;
  hello.program = "carom 0.2.0";
  hello.room = "grenoble";
  hello.viewers = {"anna", "ben"};
  hello.floor = {{-1.5, -1.0}, {1.5, 2.0}};
  hello.game = 99;
  hello.heard = 3;
  LinkWelcome welcome;
  welcome.game = 99;
  welcome.apart_m = 1.25;
  welcome.lightSpeedShown_m_s = 1.42;
  welcome.board_s = 81.5;
  welcome.scenario = "light_speed_m_s = 1.42\n";
  welcome.meshes = {{"puck.obj", 5}};
  welcome.strokes = {sampleStroke(0), sampleStroke(1)};
  return {hello,
          LinkPing{4, -5},
          LinkPong{{4, -5}},
          welcome,
          LinkReady{samplePresent()},
          LinkAccept{2},
          samplePresent(),
          sampleStroke(9),
          LinkDigest{81, 42},
          LinkSettings{3, 2.0, true},
          LinkBye{"the room closes"},
          LinkTurns{81, 43, {{0.0, 80.5, 0.1, -0.2, 0.3, 0.4, 60.5, 0.5, 0.25}}}};
}

}  // namespace carom::test
