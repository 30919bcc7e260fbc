#pragma once
// The shaders of a page: the texts of cave/bodies/shaders in the dialect of browsers (GLSL ES 3.00), for
// every variant that a page can ask for.

#include <cstddef>
#include <string>
#include <vector>

#include "cave/bodies/body_program.h"

namespace carom {

/// A variant and the parts of its two texts, by their places among all parts.
struct PageVariant {
  BodyVariant variant;
  std::vector<std::size_t> vertex, fragment;
};

struct PageShaders {
  std::vector<std::string> parts;  ///< each once
  std::vector<PageVariant> variants;
};

/// The texels of a row of the texture of legs: those of sixty legs. The table of colours has rows of 1024.
inline constexpr int kLegRowTexels = 60 * kLegTexels;

/// Returns a part of a shader's text in the dialect of browsers. Legs and colours lie in textures of rows;
/// what does not exist yet is discarded by its pixels instead of being clipped.
std::string browserText(std::string text, bool isVertex);

/// Returns the variants of these paints at rest and of moving bodies, for all states of the first three
/// effects with each of these states of the others, and the ghosts.
PageShaders pageShaders(const std::vector<Paint>& resting, const std::vector<Paint>& moving,
                        const std::vector<Switches>& recorded, bool followsLamps);

/// Returns a variant's name in a page: legs, paint, the bits of the effects, moment.
std::string nameOf(const BodyVariant& variant);

}  // namespace carom
