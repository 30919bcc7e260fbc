// Rig files of anything: what can be read can be shown.

#include <algorithm>

#include "app/rig/rig.h"
#include "engine/text/input_error.h"
#include "fuzz/expect.h"
#include "fuzz/file_of.h"

namespace {

using carom::test::expect;

/// A projector that a session could use.
void expectSound(const carom::Wall& wall) {
  expect(std::min({wall.gain.x, wall.gain.y, wall.gain.z}) > wall.blackLevel, "white is above black");
  if (!wall.skewed) return;
  const glm::dmat3 pictureOf = carom::pictureFromWindow(*wall.skewed);
  for (const glm::dvec3& corner : {glm::dvec3(0, 0, 1), {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}) {
    expect((pictureOf * corner).z > 0.0, "a homography has the screen before it");
  }
  const carom::SkewCost cost = carom::costOf(*wall.skewed, {1.0, 1.0}, {100, 100});
  expect(cost.least > 0.0 && cost.most < 100.0 && cost.lost > -1e-6 && cost.lost < 1.0,
         "its cost is bounded");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    for (const carom::Wall& wall : carom::readRig(carom::test::fileOf(bytes, size)).walls) expectSound(wall);
  } catch (const carom::InputError&) {
  }
  return 0;
}
