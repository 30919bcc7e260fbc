#include "cave/overlay/class_board.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "cave/hud/panel_place.h"
#include "cave/overlay/wall_buttons.h"
#include "cave/room/off_axis.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

constexpr double kCodeHeight = 0.26;  // of the picture's height
// Of the picture's width and height; above it is the band of the lesson.
constexpr glm::dvec2 kMost{0.9, 0.45};
// In the nominal height of the letters.
constexpr double kPitch = 1.35, kBarPitch = 0.8, kBarHeight = 0.55, kPairGap = 0.3;
constexpr double kBarLength = 11.0,
                 kShortBar = 5.0;  // of all votes; while the lesson explains, which needs the wall
constexpr double kNumberWidth = 2.2, kCountWidth = 2.2, kPadding = 0.6;
constexpr PanelPicture::Rgba kBoardGround{12, 14, 18, 205}, kLight{255, 255, 255, 255}, kDark{0, 0, 0, 255};
constexpr std::array<PanelPicture::Rgba, kVotes> kBars{{{96, 160, 255, 255}, {255, 170, 70, 255}}};
constexpr glm::vec3 kBoardInk(235.0F), kGreen(110.0F, 225.0F, 140.0F);

std::uint64_t allOf(const VoteCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

double barLength(const ClassView& view) {
  return view.phase == ClassPhase::explained ? kShortBar : kBarLength;
}

/// Returns whether there is a distribution of a vote to show.
bool isCounted(const ClassView& view, std::size_t vote) { return allOf(view.counts[vote]) > 0; }

/// Returns whether the code is small: once everybody has joined, the wall is the game's.
bool isSmall(const ClassView& view) { return hasClass(view) && view.phase > ClassPhase::vote; }

/// Returns whether there is a code: not while the lesson explains, which needs the wall.
bool hasCode(const ClassView& view) { return view.phase != ClassPhase::explained; }

}  // namespace

std::vector<std::string> classLines(const ClassView& view) {
  const std::string address(view.address.words());
  if (!hasClass(view)) return {texts::page::kTakeHome.words(), address, texts::page::kForAnHour.words()};
  const std::string room = texts::format(texts::classroom::kRoom, view.word.words());
  const bool isTooFew = view.answered > 0 && !isCounted(view, 0) && !isCounted(view, 1);
  switch (view.phase) {
    case ClassPhase::idle:
      return {texts::classroom::kJoin.words(), address, room,
              texts::format(texts::classroom::kPhones, view.phones)};
    case ClassPhase::vote:
      return {texts::format(texts::classroom::kVote, view.round, view.answered, view.phones), address, room};
    case ClassPhase::closed: {
      std::vector<std::string> lines{texts::format(texts::classroom::kClosed, view.round, view.answered)};
      if (isTooFew) lines.emplace_back(texts::classroom::kTooFew);
      return lines;
    }
    case ClassPhase::discuss:
      return {texts::classroom::kDiscuss.words()};
    default:
      return {};
  }
}

int moduleOf_px(int picture_px, int modules, bool isSmall) {
  constexpr double kLeast = 1.0 / 400.0;
  constexpr int kReadable_px = 2;
  const int least_px = std::max(kReadable_px, static_cast<int>(std::ceil(kLeast * picture_px)));
  return isSmall ? least_px : std::max(least_px, static_cast<int>(kCodeHeight * picture_px / modules));
}

/// Returns whether the distributions are shown: not while the lesson plays, which they would cover.
bool ClassBoard::showsBars() const {
  return view_.phase != ClassPhase::shown && (isCounted(view_, 0) || isCounted(view_, 1));
}

/// Returns whether a bar of each vote stands beside that of the other.
bool ClassBoard::hasBoth() const { return isCounted(view_, 0) && isCounted(view_, 1); }

int ClassBoard::barRows() const {
  return static_cast<int>(view_.choices) * ((isCounted(view_, 0) ? 1 : 0) + (isCounted(view_, 1) ? 1 : 0));
}

/// Renders the letters and finds the size of the panel. `scale`: of the letters, on a narrow wall less than
/// its text size.
void ClassBoard::layOut(double scale) {
  const double letters_px = PanelPlace::kBandCapital / PanelPlace::kCapitalOfLetters * picture_px_.y;
  letter_px_ = std::max(9, static_cast<int>(scale * std::ceil(letters_px)));
  const int modules = code_.side + 2 * kQuietModules;
  module_px_ = moduleOf_px(picture_px_.y, modules, isSmall(view_));
  int widest_px = 0;
  for (Line& line : lines_) {
    line.ink = ink(line.text, letter_px_);
    widest_px = std::max(widest_px, line.ink.size_px.x);
  }
  double high = kPitch * static_cast<double>(lines_.size()) + 2.0 * kPadding;
  if (showsBars()) {
    widest_px =
        std::max(widest_px, static_cast<int>((kNumberWidth + barLength(view_) + kCountWidth) * letter_px_));
    high += kBarPitch * (barRows() + (hasBoth() ? 1 : 0)) + kPairGap * static_cast<double>(view_.choices) +
            kPadding;
  }
  const int code_px = hasCode(view_) ? modules * module_px_ : 0;
  size_px_ = glm::ivec2(code_px);
  if (widest_px == 0) return;
  size_px_.x += widest_px + 2 * static_cast<int>(kPadding * letter_px_);
  size_px_.y = std::max(code_px, static_cast<int>(high * letter_px_));
}

/// Returns where words and bars begin, behind the code.
int ClassBoard::begin_px() const {
  const int code_px = hasCode(view_) ? (code_.side + 2 * kQuietModules) * module_px_ : 0;
  return code_px + static_cast<int>(kPadding * letter_px_);
}

/// Paints the code with its border at the panel's upper left.
void ClassBoard::paintCode() {
  if (!hasCode(view_)) return;
  const int modules = code_.side + 2 * kQuietModules;
  const glm::ivec2 from_px{0, size_px_.y - modules * module_px_};
  panel_.fill(from_px, glm::ivec2(modules * module_px_), kLight);
  for (int row = 0; row < code_.side; ++row) {
    for (int column = 0; column < code_.side; ++column) {
      if (!code_.isDark(column, row)) continue;
      const glm::ivec2 at{column + kQuietModules, modules - 1 - (row + kQuietModules)};
      panel_.fill(from_px + at * module_px_, glm::ivec2(module_px_), kDark);
    }
  }
}

/// Paints a bar for each vote and answer below this height.
void ClassBoard::paintBars(int top_px) {
  const auto px = [this](double letters) { return static_cast<int>(letters * letter_px_); };
  const int left_px = begin_px();
  const int small_px = std::max(8, px(0.85));
  for (std::size_t answer = 0; answer < view_.choices; ++answer) {
    const bool isRight = view_.right == answer + 1;
    const std::string number(kAnswerNumbers.at(answer));
    for (std::size_t vote = 0; vote < kVotes; ++vote) {
      if (!isCounted(view_, vote)) continue;
      top_px -= px(kBarPitch);
      const std::uint64_t count = view_.counts[vote][answer];
      const double share = static_cast<double>(count) / static_cast<double>(allOf(view_.counts[vote]));
      const glm::ivec2 bar_px{std::max(1, px(barLength(view_) * share)), px(kBarHeight)};
      const int bar_left_px = left_px + px(kNumberWidth);
      panel_.fill({bar_left_px, top_px}, bar_px, kBars[vote]);
      panel_.write({bar_left_px + bar_px.x + px(0.3), top_px}, ink(std::to_string(count), small_px),
                   kBoardInk);
      if (vote > 0 && isCounted(view_, 0)) continue;
      panel_.write({left_px, top_px},
                   ink(isRight ? number + texts::classroom::kRight.words() : number, small_px),
                   isRight ? kGreen : kBoardInk);
    }
    top_px -= px(kPairGap);
  }
  if (!hasBoth()) return;
  top_px -= px(kBarPitch);
  int at_px = left_px;
  for (std::size_t vote = 0; vote < kVotes; ++vote) {
    const GlyphBitmap name = ink(texts::classroom::kVotes.at(vote), small_px);
    panel_.fill({at_px, top_px}, glm::ivec2(px(kBarHeight)), kBars[vote]);
    panel_.write({at_px + px(kBarPitch), top_px}, name, kBoardInk);
    at_px += px(2.0 * kBarPitch) + name.size_px.x;
  }
}

void ClassBoard::paint() {
  const auto px = [this](double letters) { return static_cast<int>(letters * letter_px_); };
  const int left_px = begin_px();
  panel_.begin(size_px_, kBoardGround);
  paintCode();
  int foot_px = size_px_.y - px(kPadding);
  for (const Line& line : lines_) {
    foot_px -= px(kPitch);
    panel_.write({left_px, foot_px + px(0.3)}, line.ink, kBoardInk);
  }
  if (showsBars()) paintBars(foot_px - px(kPadding) / 2);
  panel_.upload();
}

void ClassBoard::draw(const Wall& wall, const ClassView& view, const RenderTarget& picture) {
  if (view.phase == ClassPhase::none) return;
  if (view != view_ || picture_px_ != picture.size_px() || language_ != texts::language()) {
    language_ = texts::language();
    view_ = view;
    picture_px_ = picture.size_px();
    if (coded_ != view.address) {
      coded_ = view.address;
      code_ = qrCodeOf(std::string(view.address.words()));
    }
    lines_.clear();
    for (std::string& line : classLines(view)) lines_.push_back({std::move(line), {}});
    layOut(wall.textSize);
    const glm::dvec2 most_px = kMost * glm::dvec2(picture_px_);
    const double share = std::min(most_px.x / size_px_.x, most_px.y / size_px_.y);
    if (share < 1.0) layOut(wall.textSize * share);
    paint();
  }
  const glm::dvec2 pxPerM = glm::dvec2(picture.size_px()) / sizeOf_m(wall);
  const double margin_m = PanelPlace::kMargin * sizeOf_m(wall).y;
  constexpr bool kAtFoot = true;
  const Tile below = tilesOn(wall, kAtFoot).front();
  const glm::dvec2 from_m{margin_m, below.from_m.y + below.size_m.y + 0.5 * margin_m};
  panel_.draw(picture, glm::ivec2(from_m * pxPerM), pxPerM.x / pxPerM.y);
}

}  // namespace carom
