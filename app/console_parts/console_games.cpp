#include "app/console_parts/console_games.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>

#include "app/console_parts/console_lesson.h"
#include "app/operator/visitor_choices.h"
#include "app/toml/config_folder.h"
#include "cave/frame/lesson_language.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

constexpr float kListWidth = 0.46F;  // fraction of the panel
constexpr float kNarrow_em = 34.0F;  // a panel narrower than this has the list above the game

/// Draws a mark at the right edge of a title's line if there is room beside the title.
void markAtRight(const std::string& title, const char* mark) {
  const float gap_px = ImGui::GetFontSize();
  const float taken_px = ImGui::CalcTextSize(title.c_str()).x + gap_px + ImGui::CalcTextSize(mark).x;
  if (taken_px <= ImGui::GetContentRegionAvail().x) keyAtRight(mark);
}

}  // namespace

GamesPanel::Game GamesPanel::gameIn(const std::string& file) {
  Game game{file, std::filesystem::path(file).stem().string(), false, {}, {}};
  try {
    const Scenario scenario = readScenario(file);
    game.title = scenario.title;
    game.lesson = scenario.lesson.has_value();
    if (game.lesson) game.words = scenario.lesson->words;
  } catch (const std::exception& error) {
    game.fault = error.what();
  }
  return game;
}

GamesPanel::GamesPanel() {
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(configFolder() / "scenarios", failed)) {
    if (entry.path().extension() == ".toml") games_.push_back(gameIn(entry.path().string()));
  }
  // The lessons come first, in the order in which they build on one another.
  std::sort(games_.begin(), games_.end(), [](const Game& a, const Game& b) {
    return std::tuple(!a.lesson, numberOfLesson(a.file), a.title) <
           std::tuple(!b.lesson, numberOfLesson(b.file), b.title);
  });
}

void GamesPanel::play(const Scenario& scenario, const std::string& file) {
  scenario_ = &scenario;
  file_ = file;
  const auto known = std::find_if(games_.begin(), games_.end(),
                                  [&](const Game& game) { return isSameFile(game.file, file); });
  chosen_ = played_ = static_cast<std::size_t>(known - games_.begin());
  if (known == games_.end() && !file.empty()) {
    games_.push_back({file,
                      scenario.title,
                      scenario.lesson.has_value(),
                      scenario.lesson ? scenario.lesson->words : LessonWords(),
                      {}});
  }
}

/// Lists the games of a playlist alone, in its order.
void GamesPanel::restrictTo(const Playlist& playlist) {
  playlist_ = &playlist;
  games_.clear();
  for (const PlaylistGame& game : playlist.games) games_.push_back(gameIn(game.scenario.string()));
  if (scenario_) play(*scenario_, file_);
}

/// Draws what the playlist says of the present game, and which one follows by itself.
void GamesPanel::drawProgramme(const ConsoleFrame& frame) const {
  if (!playlist_) return;
  const std::size_t number = numberOf(*playlist_, file_);
  if (number < playlist_->games.size()) paragraph(texts::console::kNote, playlist_->games[number].note);
  if (!frame.following) return;
  words(texts::format(texts::console::kNextGame, texts::other(frame.following->game->title),
                      std::max(0.0, frame.following->in_s)));
}

void GamesPanel::drawList(const ConsoleFrame& frame) {
  const bool mayPlay = isLive(frame.keys);
  const float foot_px = mayPlay ? ImGui::GetFrameHeightWithSpacing() : 0.0F;
  ImGui::BeginChild("##games", {0.0F, -foot_px});
  bool twice = false;
  for (std::size_t i = 0; i < games_.size(); ++i) {
    Game& game = games_[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushStyleColor(ImGuiCol_Text, game.fault.empty() ? kBright : kDim);
    if (ImGui::Selectable(texts::other(game.title).c_str(), chosen_ == i,
                          ImGuiSelectableFlags_AllowDoubleClick)) {
      chosen_ = i;
      if (i != played_) games_[i] = gameIn(game.file);  // it may have been corrected meanwhile
      twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    ImGui::PopStyleColor();
    tip(game.fault.empty() ? game.file : game.fault);
    if (i == played_) {
      markAtRight(texts::other(game.title),
                  game.lesson ? texts::console::kIsPlayedLesson : texts::console::kIsPlayed);
    } else if (game.lesson) {
      markAtRight(texts::other(game.title), texts::console::kIsLesson);
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
  if (!mayPlay) return;
  const bool canPlay = chosen_ < games_.size() && games_[chosen_].fault.empty();
  ImGui::BeginDisabled(!canPlay);
  if ((ImGui::Button(texts::console::kPlay) || twice) && canPlay)
    frame.commands.emplace_back(PlayScenario{games_[chosen_].file});
  tip(texts::console::kPlayTip);
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button(texts::console::kRestart))
    frame.commands.emplace_back(PlayScenario{frame.settings.playing});
  tip(texts::console::kRestartTip);
}

/// Draws the description of a chosen game that is not the current one.
void GamesPanel::drawChosen() const {
  const Game& game = games_[chosen_];
  heading(texts::other(game.title).c_str());
  if (!game.fault.empty()) return ImGui::TextWrapped("%s", game.fault.c_str());
  if (!game.lesson) return words(texts::console::kPlayBegins);
  dim(texts::console::kPlayBeginsLesson);
  const LessonWords said = inLanguage(game.words);
  ImGui::TextWrapped("%s", said.question.c_str());
  for (const std::string& answer : said.answers) words(texts::format(texts::console::kListed, answer));
  paragraph(texts::console::kTryThis, said.todo);
  paragraph(texts::console::kLookFor, said.notice);
}

void GamesPanel::drawPlayed(const ConsoleFrame& frame) const {
  const bool live = isLive(frame.keys);
  heading(texts::other(scenario_->title).c_str());
  words(texts::format(texts::console::kPucksAndLight, scenario_->billiard.pucks.size(),
                      scenario_->billiard.lightSpeed_m_s));
  dim(std::filesystem::path(file_).filename().string());
  tip(file_);
  drawProgramme(frame);
  if (live && !scenario_->lesson) {
    if (ImGui::Button(texts::console::kBestShot)) frame.commands.emplace_back(ShowBestShot{});
    tip(texts::console::kBestShotTip);
    keyAtRight(texts::keys::kEnterKey);
  }
  if (scenario_->tour.empty() || !live) return;
  if (ImGui::Button(texts::console::kStartFlight)) frame.commands.emplace_back(StartTour{});
  tip(texts::console::kStartFlightTip);
  keyAtRight(keyFor(frame.keys, "tour").keys);
}

void GamesPanel::draw(const ConsoleFrame& frame) {
  const Playlist* const playlist = frame.settings.playlist.get();
  if (playlist && playlist != playlist_) restrictTo(*playlist);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool isNarrow = room.x < kNarrow_em * ImGui::GetFontSize();
  ImGui::BeginChild("##list", isNarrow ? ImVec2(0.0F, 0.5F * room.y) : ImVec2(kListWidth * room.x, 0.0F));
  drawList(frame);
  ImGui::EndChild();
  if (!isNarrow) ImGui::SameLine();
  ImGui::BeginChild("##played");
  if (chosen_ != played_ && chosen_ < games_.size()) {
    drawChosen();
  } else {
    drawPlayed(frame);
  }
  ImGui::EndChild();
}

}  // namespace carom::console
