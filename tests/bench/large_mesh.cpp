// large_mesh RINGS FILE.ply: writes a mesh of 4 RINGS² triangles; 1120 make five million.
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "cave/bumpy_sphere.h"

int main(int argc, char** argv) {
  const int rings = argc == 3 ? std::atoi(argv[1]) : 0;
  if (rings < 1 || rings > 2000) {
    std::cerr << "usage: large_mesh RINGS FILE.ply, with 1 to 2000 rings\n";
    return 2;
  }
  std::ofstream file(argv[2], std::ios::binary);
  file << carom::test::bumpySphere(rings) << std::flush;
  return file ? 0 : 1;
}
