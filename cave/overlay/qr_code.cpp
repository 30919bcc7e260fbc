#include "cave/overlay/qr_code.h"

#include <qrencode.h>

#include <memory>

namespace carom {

QrCode qrCodeOf(const std::string& text) {
  constexpr int kAnyVersion = 0;
  if (text.empty()) return {};
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> made(
      QRcode_encodeString8bit(text.c_str(), kAnyVersion, QR_ECLEVEL_M), &QRcode_free);
  if (!made) return {};
  QrCode code{made->width, {}};
  for (int i = 0; i < code.side * code.side; ++i) code.dark.push_back((made->data[i] & 1U) != 0);
  return code;
}

}  // namespace carom
