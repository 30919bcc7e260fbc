#pragma once
// What a frame brings to the journal besides its record.

#include <cstddef>

#include "engine/billiard/billiard.h"

namespace carom {

/// A stroke made by hand.
struct HandStroke {
  Stroke stroke;
  std::size_t viewer = 0;  ///< whose hand it was, an index of the rig's viewers
};

}  // namespace carom
