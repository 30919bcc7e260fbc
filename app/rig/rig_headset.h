#pragma once
// Reads a rig whose walls hang on the head: [headset] in the place of [head], [[tracker]] and [[wall]].

#include "app/rig/rig.h"
#include "app/toml/toml_file.h"

namespace carom {

/// Reads the table and makes the rig's viewer and tracker: sensor 0 is the head, sensor 1 the hand that aims.
void readHeadset(const TomlTable& root, const TomlTable& table, double unit_m, Rig& rig);

/// Makes the walls before the eyes: as if somebody stood in the middle of the room and looked forward, until
/// the headset tells where they are. Their windows are the halves of the one window.
void placeEyes(Rig& rig);

/// Gives the pictures of both eyes this size. The mirror keeps its height.
void fitEyes(Rig& rig, glm::ivec2 eye_px);

}  // namespace carom
