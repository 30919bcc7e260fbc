#pragma once
// A room of VR Juggler.

#include <string>

namespace carom::test::jconf {

inline std::string corner(const std::string& name, const std::string& x, const std::string& y,
                          const std::string& z) {
  std::string text;
  for (const std::string& value : {x, y, z}) text += "<" + name + ">" + value + "</" + name + ">";
  return text;
}

inline std::string viewport(const std::string& name, const std::string& view, const std::string& x) {
  return "<surface_viewport name='" + name +
         "'><origin>0</origin><origin>0.5</origin><size>1</size><size>0.5</size>\n<view>" + view + "</view>" +
         corner("lower_left_corner", x, "0.0", "2") + corner("lower_right_corner", x, "0.0", "-2") +
         corner("upper_right_corner", x, "3", "-2") + corner("upper_left_corner", x, "3", "2") +
         "<user>Me</user><active>true</active></surface_viewport>\n";
}

inline const std::string kCave =
    "<configuration xmlns='http://www.vrjuggler.org/jccl/xsd/3.0/configuration'>\n<elements>\n"
    "<display_system name='p'><pipes>mammoth:0.0</pipes><pipes>mammoth:0.1</pipes></display_system>\n"
    "<user "
    "name='Me'><head_position>VJHead</head_position><interocular_distance>0.068</interocular_distance></"
    "user>\n"
    "<alias name='VJHead'><proxy>Head</proxy></alias><alias name='VJWand'><proxy>Wand</proxy></alias>\n"
    "<position_proxy name='Head'><device>Art</device><unit>2</unit></position_proxy>\n"
    "<position_proxy name='Wand'><device>Flock</device><unit>0</unit></position_proxy>\n"
    "<vrpn "
    "name='Art'><tracker_server>Art@host</tracker_server><position_filters><position_transform_filter>" +
    corner("pre_translate", "0", "1", "0") + corner("pre_rotation", "0", "90", "0") +
    corner("post_translate", "0.1", "0", "0") +
    "<device_units>1</device_units></position_transform_filter></position_filters></vrpn>\n"
    "<flock name='Flock'><port>/dev/tty</port></flock>\n"
    "<display_window "
    "name='L'><origin>10</origin><origin>20</origin><size>1000</size><size>800</size><pipe>1</pipe>"
    "<stereo>true</stereo><active>true</active><surface_viewports>\n" +
    viewport("left", "Stereo", "-2.0") +
    "</surface_viewports></display_window>\n"
    "<display_window "
    "name='Sim'><origin>0</origin><origin>0</origin><size>100</size><size>100</size><pipe>0</pipe>"
    "<stereo>false</stereo><active>true</active><simulator_viewports><simulator_viewport "
    "name='s'/></simulator_viewports>"
    "<surface_viewports/></display_window>\n"
    "<display_window "
    "name='Off'><origin>0</origin><origin>0</origin><size>100</size><size>100</size><active>false</active>"
    "<surface_viewports>\n" +
    viewport("off", "Left", "2") + "</surface_viewports></display_window>\n</elements>\n</configuration>\n";

}  // namespace carom::test::jconf
