#pragma once
// A warp with one quadrangle, as a Wavefront OBJ.

#include <string>

namespace carom::test {

inline const std::string kObj =
    "# a keystone\nmtllib x.mtl\no wall\nv -1 -1 0\nv 1 -1 0\nv 0.5 1 0\nv -0.5 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n";

}  // namespace carom::test
