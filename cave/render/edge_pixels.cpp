#include "cave/render/edge_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace carom {
namespace {

constexpr int kFarthest_px = 16;  // that an edge is followed
constexpr int kLeft_px = 32;      // columns of tones before a picture: more than are looked at, and aligned
constexpr int kBelow_px = kFarthest_px + 1;
constexpr std::uint32_t kWhole = 256;  // share of a pixel that is covered

/// Returns the share of the pixel from j to j + 1 that lies beyond the edge, an even line that falls from
/// half a pixel on this side of the border of two rows to half a pixel on the other within k pixels (A.
/// Reshetov, Morphological antialiasing, High Performance Graphics 2009):
///   ∫ max(0, 1/2 − x/k) dx from j to j + 1.
constexpr double cutOff(double j, double k) {
  const double h = std::clamp(0.5 * k - j, 0.0, 1.0);
  return h * (0.5 - (j + 0.5 * h) / k);
}

/// The same of an edge whose turns are `near` and `far` pixels away.
constexpr auto kShares = [] {
  std::array<std::array<std::uint32_t, kFarthest_px + 1>, kFarthest_px + 1> shares{};
  for (int near = 1; near <= kFarthest_px; ++near) {
    for (int far = near; far <= kFarthest_px; ++far)
      shares[near][far] = static_cast<std::uint32_t>(cutOff(near - 1, near + far - 1) * kWhole + 0.5);
  }
  return shares;
}();

/// Returns the least step of tones that is an edge: five of 255, or twelve where letters and pictures have
/// tones of their own.
std::uint8_t leastStep(EdgePixels::Tones tones) { return tones == EdgePixels::Tones::inAlpha ? 5 : 12; }

/// Luminance: Rec. 709.
std::uint8_t luminance(std::uint32_t pixel) {
  const std::uint32_t red = (pixel >> 16U) & 255U, green = (pixel >> 8U) & 255U, blue = pixel & 255U;
  return static_cast<std::uint8_t>((54U * red + 183U * green + 19U * blue + 128U) >> 8U);
}

/// Returns `ours` with a share of `theirs` in all four bytes.
std::uint32_t mixed(std::uint32_t ours, std::uint32_t theirs, std::uint32_t share) {
  constexpr std::uint32_t kEven = 0x00ff00ffU, kHalf = 0x00800080U;
  const auto bytes = [&](std::uint32_t a, std::uint32_t b) {
    return ((a & kEven) * (kWhole - share) + (b & kEven) * share + kHalf) >> 8U & kEven;
  };
  return bytes(ours, theirs) | bytes(ours >> 8U, theirs >> 8U) << 8U;
}

/// Returns which share of the neighbour's colour the pixel at `here` takes: `along` and `across` lead to the
/// next along the edge and over it. The search is that of T. Lottes, FXAA 3.11 (NVIDIA, 2011): to both sides,
/// up to where the edge goes on in another row. Only where the nearer of these turns is to the neighbour's
/// tone does the edge come over to this pixel's row.
std::uint32_t shareOf(const std::uint8_t* here, std::ptrdiff_t along, std::ptrdiff_t across) {
  const int step = here[across] - here[0];
  if (step == 0) return 0;
  const int middle = 2 * (here[0] + here[across]);  // four times the tone between both sides
  const auto off = [&](std::ptrdiff_t i) {
    return 2 * (here[i * along] + here[i * along + across]) - middle;
  };
  const auto turns = [&](int change) { return std::abs(change) >= std::abs(step); };
  for (int i = 1; i <= kFarthest_px; ++i) {
    const int ahead = off(i), behind = off(-i);
    const bool turnsBehind = turns(behind);
    if (!turnsBehind && !turns(ahead)) continue;
    const int nearer = turnsBehind ? behind : ahead;
    if ((nearer > 0) != (step > 0)) return 0;
    int far = i;
    if (!turnsBehind || !turns(ahead)) {
      const int side = turnsBehind ? 1 : -1;
      while (far < kFarthest_px && !turns(off(side * ++far))) {
      }
    }
    return kShares[static_cast<std::size_t>(i)][static_cast<std::size_t>(far)];
  }
  return 0;
}

}  // namespace

std::span<std::uint32_t> EdgePixels::begin(const glm::ivec2& size_px) {
  if (size_px == size_px_) return pixels_;
  size_px_ = size_px;
  const auto columns = static_cast<std::size_t>(size_px.x), rows = static_cast<std::size_t>(size_px.y);
  const std::size_t words = (columns + 7) / 8;
  stride_ = static_cast<std::ptrdiff_t>(8 * words) + 2 * kLeft_px;
  pixels_.resize(columns * rows);
  edges_.resize(words);
  tones8_.resize(static_cast<std::size_t>(stride_) * (rows + 2 * kBelow_px));
  return pixels_;
}

std::uint8_t* EdgePixels::rowOfTones(int y) { return tones8_.data() + (y + kBelow_px) * stride_ + kLeft_px; }

void EdgePixels::takeTones() {
  const std::uint32_t* pixel = pixels_.data();
  for (int y = 0; y < size_px_.y; ++y, pixel += size_px_.x) {
    std::uint8_t* row = rowOfTones(y);
    if (tones_ == Tones::inAlpha) {
      for (int x = 0; x < size_px_.x; ++x) row[x] = static_cast<std::uint8_t>(pixel[x] >> 24U);
    } else {
      for (int x = 0; x < size_px_.x; ++x) row[x] = luminance(pixel[x]);
    }
    std::fill(row - kLeft_px, row, row[0]);
    std::fill(row + size_px_.x, row - kLeft_px + stride_, row[size_px_.x - 1]);
  }
  for (int i = 1; i <= kBelow_px; ++i) {
    std::copy_n(rowOfTones(0) - kLeft_px, stride_, rowOfTones(-i) - kLeft_px);
    std::copy_n(rowOfTones(size_px_.y - 1) - kLeft_px, stride_, rowOfTones(size_px_.y - 1 + i) - kLeft_px);
  }
}

void EdgePixels::findEdges(int y) {
  const std::uint8_t* row = rowOfTones(y);
  const std::uint8_t* below = row - stride_;
  const std::uint8_t* above = row + stride_;
  const std::uint8_t least = leastStep(tones_);
  auto* edges = reinterpret_cast<std::uint8_t*>(edges_.data());
  const std::size_t columns = 8 * edges_.size();
  for (std::size_t x = 0; x < columns; ++x) {
    const std::uint8_t high = std::max({row[x], row[x - 1], row[x + 1], below[x], above[x]});
    const std::uint8_t low = std::min({row[x], row[x - 1], row[x + 1], below[x], above[x]});
    edges[x] = static_cast<std::uint8_t>(high - low) >= least ? 1 : 0;
  }
}

/// Notes the colour of a pixel at an edge.
void EdgePixels::mix(int x, int y) {
  const std::uint8_t* here = rowOfTones(y) + x;
  const auto tone = [&](int dx, int dy) -> int { return here[dy * stride_ + dx]; };
  const int m = tone(0, 0), north = tone(0, 1), south = tone(0, -1), east = tone(1, 0), west = tone(-1, 0);
  const int ne = tone(1, 1), nw = tone(-1, 1), se = tone(1, -1), sw = tone(-1, -1);
  // Along rows or along columns: where the second differences across are the larger ones, corners included.
  const int acrossRows =
      std::abs(nw + sw - 2 * west) + 2 * std::abs(north + south - 2 * m) + std::abs(ne + se - 2 * east);
  const int acrossColumns =
      std::abs(nw + ne - 2 * north) + 2 * std::abs(west + east - 2 * m) + std::abs(sw + se - 2 * south);
  const bool inRow = acrossRows >= acrossColumns;
  const int up = inRow ? north : east, down = inRow ? south : west;
  const int side = std::abs(up - m) >= std::abs(down - m) ? 1 : -1;
  const std::uint32_t share = shareOf(here, inRow ? 1 : stride_, inRow ? side * stride_ : side);
  if (share == 0) return;
  const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size_px_.x) + x;
  const std::size_t neighbour = at + static_cast<std::size_t>(inRow ? side * size_px_.x : side);
  changes_.push_back({at, mixed(pixels_[at], pixels_[neighbour], share)});
}

std::span<const std::uint32_t> EdgePixels::smooth() {
  takeTones();
  changes_.clear();
  for (int y = 0; y < size_px_.y; ++y) {
    findEdges(y);
    for (int word = 0; word < static_cast<int>(edges_.size()); ++word) {
      if (edges_[static_cast<std::size_t>(word)] == 0) continue;
      std::array<std::uint8_t, 8> edges;
      std::memcpy(edges.data(), &edges_[static_cast<std::size_t>(word)], edges.size());
      for (int i = 0; i < 8; ++i)
        if (edges[static_cast<std::size_t>(i)] != 0 && 8 * word + i < size_px_.x) mix(8 * word + i, y);
    }
  }
  for (const Change& change : changes_) pixels_[change.at] = change.colour;
  return pixels_;
}

}  // namespace carom
