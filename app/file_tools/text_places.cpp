#include "app/file_tools/text_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/languages/source_text.h"
#include "app/scenario/scenario.h"
#include "app/toml/config_folder.h"
#include "cave/gl/letter_atlas.h"
#include "cave/hud/hud_line.h"
#include "cave/hud/line_breaks.h"
#include "cave/hud/panel_place.h"
#include "cave/hud/sentences.h"
#include "cave/overlay/band_layout.h"
#include "cave/overlay/wall_buttons.h"
#include "cave/room/off_axis.h"
#include "cave/room/room_geometry.h"

namespace carom {
namespace {

/// The widest number that each format shows within sensible bounds: times up to a quarter of an hour, speeds
/// of light up to 100 m/s, shares of c, distances in a hall, counts of a game.
struct WidestValue {
  std::string_view format, shows;
};
constexpr std::array<WidestValue, 8> kWidestValues{{{":.0f", "888"},
                                                    {":.1f", "888.8"},
                                                    {":.2f", "88.88"},
                                                    {":.3f", "8.888"},
                                                    {":g", "0.888"},
                                                    {":.2g", "0.88"},
                                                    {":.3g", "0.888"},
                                                    {":.5g", "888.88"}}};
/// A plate shows speeds in c, γ and parts of a length.
constexpr std::string_view kCount = "888", kHundredthsOfPlate = "8.88";

// Widths of windows, of their style (app/console_parts/console_parts.cpp, app/console/console.cpp).
constexpr double kConsole_px = 16.0, kOverWalls_px = 18.0;  // heights of letters
constexpr double kLeftPart_px = 366.0, kPartSides_px = 2.0 * 12.0;
constexpr double kTick_px = 23.0 + 8.0, kKeyOfView_em = 2.5;  // a box to tick, and the key at the right
constexpr double kTab_px = 2.0 * 8.0 + 8.0 + 1.0, kConsoleWide_px = 1280.0, kGap_px = 8.0, kButtons = 5.0;
constexpr double kCornerSides_px = 2.0 * 16.0, kNumbers_em = 3.0 * 5.0;  // three columns of eight places
constexpr double kPatternLetters = 0.04, kTileLetters = 0.65, kTileKey = 0.40;  // of what they lie on
constexpr std::size_t kPlateLetters = 12;

bool isOf(std::string_view entry, std::string_view group) { return entry.starts_with(group); }

/// Returns the place of a game's entry in its file: "angles.toml" and "lesson question".
std::pair<std::string, std::string> fileAndPart(const std::string& entry) {
  const std::size_t end = entry.find(".toml ");
  if (end == std::string::npos) return {};
  return {entry.substr(0, end + 5), entry.substr(end + 6)};
}

/// Returns how many letters a text has.
std::size_t lettersOf(std::string_view words) {
  return static_cast<std::size_t>(
      std::count_if(words.begin(), words.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// Returns how wide the widest line of a text is.
double widestLine_em(std::string_view words, const LineRoom& room) {
  LineBreaker breaker;
  double widest = 0.0;
  for (breaker.begin(words); !breaker.isAtEnd();) widest = std::max(widest, widthOf_em(breaker.take(room)));
  return widest;
}

/// Returns the height of the band's letters.
double bandLetter_px(const Wall& front) { return std::ceil(PanelPlace::bandLetter(front) * front.pixels.y); }

/// Adds the places of a rig.
class Places {
 public:
  Places(std::string_view rig, const Wall& front, std::span<const EntryWords> entries)
      : rig_(rig), front_(front), entries_(entries) {
    for (const EntryWords& entry : entries) {
      byEntry_.try_emplace(entry.entry, entry.words);
      const std::string part = fileAndPart(entry.entry).second;
      if (isOf(part, "name ") && columnsOf(entry.words) > columnsOf(name_)) name_ = entry.words;
    }
  }

  void nameViewers(std::span<const RoomViewer> viewers) {
    for (const RoomViewer& viewer : viewers) {
      if (columnsOf(viewer.name) > columnsOf(name_)) name_ = viewer.name;
    }
  }

  std::vector<TextPlace> all() {
    for (const EntryWords& entry : entries_) {
      const std::string words = withWidestValues(entry.entry, entry.words, name_);
      addOnPanel(entry.entry, words);
      addOnTile(entry.entry, words);
      addOnWall(entry.entry, words);
      addInScene(entry.entry, words);
      addInConsole(entry.entry, words);
    }
    addLessons();
    addTabs();
    return std::move(places_);
  }

 private:
  void add(std::string_view entry, std::string_view place, double width_px, double room_px) {
    places_.push_back({fmt::format("{}: {}, {}", entry, rig_, place), static_cast<int>(std::lround(width_px)),
                       static_cast<int>(std::lround(room_px))});
  }

  /// Adds a text that gets smaller letters where it needs them, down to the least.
  void addShrinking(std::string_view entry, std::string_view place, double width_em, double letter_px,
                    double room_px) {
    const double least_px = std::min(letter_px, static_cast<double>(kLeastLetter_px));
    add(entry, place, width_em * std::clamp(room_px / std::max(width_em, 1e-6), least_px, letter_px),
        room_px);
  }

  void addOnPanel(const std::string& entry, const std::string& words) {
    const bool isLegend = isOf(entry, "legend.");
    const std::string part = fileAndPart(entry).second;
    const bool isNotice =
        isOf(entry, "message.") || isOf(entry, "task.") || isOf(part, "caption") || isOf(part, "task ");
    if (!isLegend && !isNotice) return;
    constexpr double kBesideText = 4.0;  // of the panel's letters
    const double margin_px = PanelPlace::kMargin * front_.pixels.y;
    addShrinking(entry, "panel", widestLine_em(words, isLegend ? legendRoom() : kPanelRoom) + kBesideText,
                 PanelPlace::kCapital_m * front_.textSize / PanelPlace::kCapitalOfLetters * front_.pixels.y /
                     sizeOf_m(front_).y,
                 front_.pixels.x - 2.0 * margin_px);
    if (isLegend) return;
    const LineRoom band = bandRoom(front_);
    add(entry, "band", widestLine_em(words, band) * bandLetter_px(front_),
        band.width_em * bandLetter_px(front_));
  }

  void addOnTile(const std::string& entry, const std::string& words) {
    if (!isOf(entry, "tile.") || isOf(entry, "tile.kChoiceKeys")) return;
    const bool isChoice = isOf(entry, "tile.kChoices");
    const double wide_px = tilesOn(front_, true).front().size_m.x / sizeOf_m(front_).x * front_.pixels.x;
    const double flat_px = tilesOn(front_, true).front().size_m.y / sizeOf_m(front_).y * front_.pixels.y;
    const std::string_view key = isChoice                      ? "F7"
                                 : entry == "tile.kHome"       ? "Home"
                                 : entry == "tile.kBestShot"   ? "Enter"
                                 : entry == "tile.kTimeGoesOn" ? "F"
                                 : entry == "tile.kTryAgain"   ? "Y"
                                 : entry == "tile.kKeys"       ? "H"
                                                               : "";
    const double beside_em = (1.0 / 3.0 + kTileKey * widthOf_em(key)) / kTileLetters;
    const double least_px = std::min<double>(kLeastLetter_px, kTileLetters * flat_px);
    const bool hasKey = isEnglish() || (widthOf_em(words) + beside_em) * least_px <= 0.92 * wide_px;
    addShrinking(entry, "tile", widthOf_em(words) + (hasKey ? beside_em : 0.0), kTileLetters * flat_px,
                 0.92 * wide_px);
    if (isChoice)
      addShrinking(entry, "high tile", widthOf_em(words),
                   0.5 * tilesOn(front_, false).front().size_m.y / sizeOf_m(front_).y * front_.pixels.y,
                   0.92 * wide_px);
  }

  void addOnWall(const std::string& entry, const std::string& words) {
    const glm::dvec2 px(front_.pixels);
    if (entry == "message.kWayHome") {
      addShrinking(entry, "home arrow", widthOf_em(words) + 1.0, 0.045 * px.y, px.x);
    }
    if (isOf(entry, "classroom.") || entry == "page.kTakeHome" || entry == "page.kForAnHour")
      addShrinking(entry, "class board", widthOf_em(words) + 1.2,
                   PanelPlace::kBandCapital / PanelPlace::kCapitalOfLetters * px.y, 0.9 * px.x - 0.26 * px.y);
    if (isOf(entry, "pattern.")) {
      const bool isCorner = entry == "pattern.kCorner";
      addShrinking(entry, "test pattern", widthOf_em(words),
                   (isCorner ? 0.03 : kPatternLetters) * std::min(px.x, px.y),
                   (isCorner ? 0.46 : 0.9) * px.x);
    }
    if (isOf(entry, "ending.") || entry == "message.kStarting")
      add(entry, "over the wall", widthOf_em(words) * kOverWalls_px + 2.0 * 24.0 + 2.0 * 22.0, px.x);
    const double corner_px = widthOf_em(words) * kOverWalls_px + kCornerSides_px;
    if (isOf(entry, "latency.kParts ")) add(entry, "latency", corner_px + kNumbers_em * kOverWalls_px, px.x);
    if (isOf(entry, "latency.kLockStates"))
      add(entry, "latency",
          corner_px + widthOf_em(wordsOf("latency.kFrameLock").value_or("")) * kOverWalls_px, px.x);
    if (isOf(entry, "latency.kNode")) add(entry, "latency", corner_px, px.x);
  }

  void addInScene(const std::string& entry, const std::string& words) {
    if (!standsOnPlates(entry)) return;
    add(entry, "plate", static_cast<double>(lettersOf(words)) * kLetterCell_px.x,
        static_cast<double>(kPlateLetters) * kLetterCell_px.x);
  }

  /// The console's buttons, columns and left part grow with their words, as far as its window has room.
  void addInConsole(const std::string& entry, const std::string& words) {
    const double width_px = widthOf_em(words) * kConsole_px;
    for (const char* button : {"console.kHide", "console.kNextVisitor", "console.kKeysButton",
                               "console.kLightWalls", "console.kBlackWalls"}) {
      if (entry == button)
        add(entry, "button of the console", width_px, kConsoleWide_px / kButtons - kGap_px);
    }
    if (isOf(entry, "keys."))
      add(entry, "left part of the console", width_px + kTick_px + kKeyOfView_em * kConsole_px,
          kConsoleWide_px / 2.0);
  }

  /// The console's usual tabs together; with those of a class, a study or a link they may be scrolled, with a
  /// list of all.
  void addTabs() {
    double wide_px = 0.0;
    for (const auto& [entry, words] : byEntry_) {
      if (isOf(entry, "console.k") && entry.ends_with("Tab"))
        wide_px += widthOf_em(words) * kConsole_px + kTab_px;
    }
    if (wide_px > 0.0)
      add("console.k…Tab", "tabs", wide_px, kConsoleWide_px - kLeftPart_px - 3.0 * kGap_px - kPartSides_px);
  }

  std::optional<std::string> wordsOf(const std::string& entry) const {
    const auto found = byEntry_.find(entry);
    return found == byEntry_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Puts a game's words in the place of the English.
  void translate(const std::string& file, LessonWords& lesson, LessonPlan& plan) const {
    const auto put = [&](const std::string& part, std::string& words) {
      if (const auto other = wordsOf(file + " lesson " + part)) words = *other;
    };
    put("question", lesson.question);
    put("todo", lesson.todo);
    put("notice", lesson.notice);
    put("number", lesson.number);
    for (std::size_t i = 0; i < lesson.answers.size(); ++i)
      put(fmt::format("answer {}", i + 1), lesson.answers[i]);
    for (std::size_t i = 0; i < plan.observers.size(); ++i)
      put(fmt::format("observer {} name", i + 1), plan.observers[i].name);
    for (std::size_t i = 0; i < plan.stopwatches.size(); ++i)
      put(fmt::format("stopwatch {} name", i + 1), plan.stopwatches[i].name);
  }

  /// Lays out the band of each lesson in each phase: its lines, its buttons and its height.
  void addLessons() {
    std::map<std::string, bool> files;
    for (const EntryWords& entry : entries_) {
      const auto [file, part] = fileAndPart(entry.entry);
      if (isOf(part, "lesson ")) files[file] = true;
    }
    for (const auto& [file, isThere] : files) {
      Scenario game = readScenario(configFolder() / "scenarios" / file);
      if (!game.lesson) continue;
      translate(file, game.lesson->words, game.lesson->plan);
      for (const auto& [phase, name] :
           {std::pair{LessonPhase::asks, "asks"}, std::pair{LessonPhase::shows, "shows"},
            std::pair{LessonPhase::explains, "explains"}})
        addLesson(file + " lesson " + name, *game.lesson, phase);
    }
  }

  void addLesson(const std::string& entry, const Lesson& lesson, LessonPhase phase) {
    double widest_em = 0.0, lowest_px = bandLetter_px(front_);
    int rightmost_px = 0;
    FrameRecord record;
    std::vector<HudLine> lines;
    const auto measure = [&](double explained_s) {
      describe(record, lesson.words, lesson.plan, {}, bandRoom(front_), lines, true, explained_s);
      BandLayout layout;
      layOut(front_, front_.pixels, lines, layout);
      lowest_px = std::min(lowest_px, static_cast<double>(layout.height_px));
      for (const HudLine& line : lines)
        widest_em = std::max(widest_em, widthOf_em(line.text) + (line.setIn ? kIndent : 0.0));
      for (const BandLayout::Button& button : layout.buttons)
        rightmost_px = std::max(rightmost_px, button.part.from_px.x + button.part.size_px.x);
    };
    for (std::uint8_t answer = 0; answer <= lesson.words.answers.size(); ++answer) {
      record.lesson = {phase, answer};
      measure(0.0);
    }
    double explained_s = 0.0;
    for (const std::string_view sentence : sentencesOf(lesson.words.number)) {
      measure(explained_s);
      explained_s += standsFor_s(sentence);
    }
    const LineRoom room = bandRoom(front_);
    add(entry, "lines of the band", widest_em * bandLetter_px(front_), room.width_em * bandLetter_px(front_));
    add(entry, "buttons of the band", rightmost_px, front_.pixels.x);
    // As high as with the least letters, in the place of what there is.
    const double high_px = PanelPlace::mostOfBand(front_) * front_.pixels.y;
    add(entry, "height of the band", high_px * std::max(1.0, kLeastLetter_px / lowest_px), high_px);
  }

  std::string rig_;
  const Wall& front_;
  std::span<const EntryWords> entries_;
  std::map<std::string, std::string> byEntry_;
  std::string name_ = "puck";  ///< the longest
  std::vector<TextPlace> places_;
};

}  // namespace

std::string withWidestValues(std::string_view entry, std::string_view words, std::string_view name) {
  const bool hasNames = isOf(entry, "message.") || isOf(entry, "legend.") || isOf(entry, "lesson.");
  std::string all;
  for (std::size_t at = 0; at < words.size();) {
    if (words.substr(at, 2) == "{{" || words.substr(at, 2) == "}}") {
      all += words[at];
      at += 2;
    } else if (words[at] == '{') {
      const std::size_t end = std::min(words.find('}', at), words.size() - 1);
      std::string_view format = words.substr(at + 1, end - at - 1);
      while (!format.empty() && format.front() >= '0' && format.front() <= '9') format.remove_prefix(1);
      const auto known = std::find_if(kWidestValues.begin(), kWidestValues.end(),
                                      [&](const WidestValue& value) { return value.format == format; });
      const bool isShort = isOf(entry, "plate.kGauges") && format == ":.2f";
      all += isShort                        ? kHundredthsOfPlate
             : known != kWidestValues.end() ? known->shows
             : !format.empty() || !hasNames ? kCount
                                            : name;
      at = end + 1;
    } else {
      all += words[at++];
    }
  }
  return all;
}

std::vector<TextPlace> textPlaces(std::string_view rigName, const Rig& rig,
                                  std::span<const EntryWords> entries) {
  const RoomGeometry room = roomGeometryOf(rig);
  const std::optional<Wall> front = frontWall(room);
  if (!front) return {};
  Places places(rigName, *front, entries);
  places.nameViewers(room.viewers);
  return places.all();
}

std::span<const char* const> examinedRigs() {
  static constexpr std::array<const char*, 6> kRigs{"desk",    "play",     "single-screen",
                                                    "headset", "desk-two", "four-walls-cluster"};
  return kRigs;
}

void printTextPlaces(std::string_view language, std::span<const TextPlace> places, std::FILE* out) {
  std::size_t wide = std::string_view("entry").size();
  for (const TextPlace& place : places) wide = std::max(wide, columnsOf(place.entry));
  fmt::print(out, "{:<{}}  language  width  room  pixels over\n", "entry", wide);
  for (const TextPlace& place : places) {
    fmt::print(out, "{}{:{}}  {:<8}  {:>5}  {:>4}  {:>11}\n", place.entry, "", wide - columnsOf(place.entry),
               language, place.width_px, place.room_px, place.over_px());
  }
}

}  // namespace carom
