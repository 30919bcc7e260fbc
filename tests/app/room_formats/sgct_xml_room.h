#pragma once
// A room of SGCT in XML.

#include <string>

namespace carom::test::sgct {

inline std::string plane(const std::string& element, const std::string& x) {
  return "<" + element + "><Pos x='" + x + "' y='0' z='-2'/><Pos x='" + x +
         "' y='2' z='-2'/>\n<Pos x='2' y='2' z='-2'/></" + element + ">";
}

inline const std::string kRoom =
    "<Cluster masterAddress='a'>\n"
    "<Node ip='a' port='1'><Window fullScreen='true' numberOfSamples='4'><Stereo type='Side_By_Side'/>"
    "<Size x='800' y='400'/><Pos x='5' y='6'/></Window>\n"
    "<Viewport><Pos x='0' y='0'/><Size x='1' y='1'/>" +  // SGCT 1: beside its window
    plane("viewplane", "-2") +
    "</Viewport></Node>\n"
    "<node address='b'><window><size x='800' y='400'/><viewport eye='Right'><pos x='0.5' y='0'/><size "
    "x='0.5' y='1'/>" +
    plane("ProjectionPlane", "0") +
    "</viewport><Viewport><FisheyeProjection fov='180'/></Viewport></window></node>\n"
    "<User eyeSeparation='0.067'><Pos x='0' y='1.5' z='3'/></User>\n</Cluster>\n";

}  // namespace carom::test::sgct
