#pragma once
// Rooms of HEVS with flat displays, and one with curved displays.

#include <string>

namespace carom::test::hevs {

inline const std::string kRooms = R"({ // two platforms, and "text // that stays"
 "platforms": {
  "Cave": {
   "cluster": {"master": "pc2"},
   "nodes": {
    "pc1": {"address": "10.0.0.1", "display": ["front", "dome"], "resolution": [1600, 800], "fullscreen": false},
    "pc2": {"address": "10.0.0.2", "displays": "left", "resolution": [1000, 500]}},
   "displays": {
    "base": {"type": "offaxis", "ul": [-1, 2, 2], "ll": [-1, 0, 2], "lr": [1, 0, 2]},
    "front": {"inherit": "base", "viewport": "half", "stereo_mode": "topbottom"},
    "left": {"type": "offaxis", "ul": [-1, 2, 0], "ll": [-1, 0, 0], "lr": [-1, 0, 2], "monitor": 2},
    "dome": {"type": "vr", "radius": 3.0},
    "spare": {"type": "offaxis"}},
   "viewports": {"half": {"x": 0.5, "y": 0, "width": 0.5, "height": 1}},
   "stereo": {"mode": "sidebyside", "separation": 0.063, "swap_eyes": true, "tracker": "Glasses"},
   "trackers": {
    "Glasses": {"type": "vrpn", "address": "Head@tracks", "forward": "Y", "right": "X", "up": "Z", "handedness": "right",
      "transform": {"translate": [1, 2, 3], "rotate": [0, 0, 0]}},
    "Wand": {"type": "vrpn", "address": "Wand@tracks", "forward": "Y", "right": "X", "up": "Z", "handedness": "right"},
    "Phone": {"type": "osc"}}
  },
  "Mono": {"inherit": "Cave", "stereo": {"mode": "mono", "swap_eyes": false}}
 }
}
)";

inline const std::string kCurved = R"({"platforms": {"Round": {
 "transforms": {"risen": {"translate": [0, 0.5, 1], "rotate": [0, 90, 0]}},
 "nodes": {"localhost": {"display": ["left", "right"], "resolution": [1600, 1200]}, "b": {"display": "dome"}},
 "displays": {
  "left": {"type": "curved", "monitor": 0, "slices": 4, "radius": 4.25, "height": 2.9, "angle_start": -60, "angle_end": 0,
    "warp_path": "warp.tif"},
  "right": {"type": "curved", "monitor": 1, "radius": 4.25, "height": 2.9, "angle_start": -10, "angle_end": 60,
    "ground_offset": 0.2, "transform": "risen", "stereo_mode": "leftonly", "swap_eyes": true},
  "dome": {"type": "dome", "fisheye_resolution": [1024, 1000], "radius": 3.0,
    "transform": {"translate": [0, 1, 2], "rotate": [-60, 30, 0]}}}}}})";

}  // namespace carom::test::hevs
