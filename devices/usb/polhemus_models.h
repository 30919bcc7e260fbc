#pragma once
// The Polhemus trackers that Carom supports over USB. Sources: Polhemus Tracker Terminal, the udev rules of
// the ipab-slmc ROS driver.

#include <array>
#include <cstdint>

#include "devices/protocol/polhemus_decoder.h"

namespace carom {

inline constexpr std::uint16_t kPolhemusVendor = 0x0f44;

struct PolhemusModel {
  const char* name;
  PolhemusFormat format;
  std::uint16_t product;      ///< with its firmware
  std::uint16_t bareProduct;  ///< before its firmware is loaded: that of its USB chip
  std::uint8_t commandEndpoint;
  std::uint8_t replyEndpoint;
  std::uint8_t dataEndpoint;  ///< delivers records in continuous mode
  bool dataByInterrupt;       ///< by interrupt transfers; false: bulk transfers
};

inline constexpr std::array<PolhemusModel, 6> kPolhemusModels{{
    {"FASTRAK", PolhemusFormat::fastrak, 0x0002, 0x0001, 0x02, 0x82, 0x84, true},
    {"FASTRAK", PolhemusFormat::fastrak, 0x0003, 0x0001, 0x02, 0x82, 0x84, true},
    {"PATRIOT", PolhemusFormat::liberty, 0xef12, 0xef11, 0x02, 0x82, 0x82, false},
    {"PATRIOT HS", PolhemusFormat::liberty, 0xef20, 0xef21, 0x04, 0x88, 0x88, false},
    {"LIBERTY", PolhemusFormat::liberty, 0xff12, 0xff11, 0x02, 0x82, 0x82, false},
    {"LIBERTY HS", PolhemusFormat::liberty, 0xff20, 0xff21, 0x04, 0x88, 0x88, false},
}};

/// Returns the model of a product id, with or without its firmware; null if there is none.
constexpr const PolhemusModel* findPolhemusModel(std::uint16_t product) {
  for (const PolhemusModel& model : kPolhemusModels) {
    if (model.product == product || model.bareProduct == product) return &model;
  }
  return nullptr;
}

}  // namespace carom
