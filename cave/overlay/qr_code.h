#pragma once
// A QR code (ISO/IEC 18004) of a short text, by libqrencode.

#include <string>
#include <vector>

namespace carom {

/// The dark and light modules of a code, without the light border that must surround it.
struct QrCode {
  int side = 0;            ///< modules; 0: the text is empty or too long
  std::vector<bool> dark;  ///< row by row from the top

  bool isDark(int column, int row) const { return dark[static_cast<std::size_t>(row * side + column)]; }
};

/// The light border of a code, in modules.
inline constexpr int kQuietModules = 4;

/// Returns the code of a text in bytes, with error correction of level M (about 15 % of it may be hidden).
QrCode qrCodeOf(const std::string& text);

}  // namespace carom
