#pragma once
// A room of BlenderCAVE for two people.

#include <string>

namespace carom::test::blender {

inline const std::string kCave = R"(<?xml version="1.0"?>
<!DOCTYPE ROOM [
  <!ENTITY rest SYSTEM "rest.xml">
]>
<blender_cave name="Two">
 <user name="user A" eye_separation="0.03"><default_position>0, 0, 0</default_position></user>
 <user name="user B" eye_separation="0.066"><default_position>0.5, 0, 0</default_position></user>
 <computer name="pc-0">
  <screen name="console"><player options="-w 600 600"/><graphic_buffer name="alone" user="user A" eye="middle"/>
   <corner name="topRightCorner">1, 1, -1</corner><corner name="topLeftCorner">-1, 1, -1</corner>
   <corner name="bottomRightCorner">1, -1, -1</corner></screen>
 </computer>
 <computer name="pc-1">
  <screen name="main"><player options="-f -s hwpageflip" display=":0.1"/>
   <graphic_buffer name="right" user="user A" eye="right"/><graphic_buffer name="left" user="0" eye="left"/>
   <viewport>420, 0, 1500, 1080</viewport>
   <corner name="topRightCorner">-2, 1.1, -1.5</corner><corner name="topLeftCorner">-2, 1.1, 1.5</corner>
   <corner name="bottomRightCorner">-2, -1.6, -1.5</corner></screen>
 </computer>
 <computer name="pc-2">
  <screen name="main">
   <graphic_buffer name="right" user="user A" eye="middle"/><graphic_buffer name="left" user="user B" eye="middle"/>
   <corner name="topRightCorner">2, -1.6, -1.5</corner><corner name="topLeftCorner">-2, -1.6, -1.5</corner>
   <corner name="bottomRightCorner">2, -1.6, 1.5</corner></screen>
 </computer>
 <vrpn>
  <tracker name="DTrack" host="tracker-pc">
   <transformation><translate x="0" y="0" z="-1.6"/><rotate x="1" y="1" z="1" angle="-2.0943951023931953"/></transformation>
   <sensor id="4" processor_method="user_position" users="user B">
    <transformation><rotate x="1" y="1" z="1" angle="2.0943951023931953"/></transformation></sensor>
   <sensor id="0" processor_method="wand"/>
  </tracker>
  <button name="FlyStick" host="tracker-pc"/>
 </vrpn>
 &rest;
</blender_cave>
)";

}  // namespace carom::test::blender
