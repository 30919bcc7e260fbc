#pragma once
// Reads the bodies of a frame of Qualisys Track Manager.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

struct QtmFrame {
  std::uint32_t number = 0;
  bool isWhole = true;  ///< every body that QTM sees has a pose that can be one
};

/// Takes the content of a data packet and appends a reading for each body, in QTM's order from sensor 0: a
/// pose, or that it is lost. Its components 6D and 6DRes are read, others are passed by. None, and nothing
/// appended, if it cannot be read.
///
/// The nine numbers of a body's rotation are the columns of its matrix, one after another. Qualisys's own
/// programs read them so: QTM Connect for Unity, for Unreal and for Maya.
std::optional<QtmFrame> readQtmFrame(std::span<const std::uint8_t> content, std::vector<Reading>& readings);

}  // namespace carom
