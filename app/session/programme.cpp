#include "app/session/programme.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/operator/visitor_choices.h"

namespace carom {

Programme::Programme(std::string firstGame, std::shared_ptr<const Playlist> playlist,
                     std::optional<double> patience_s)
    : firstGame_(std::move(firstGame)),
      playlist_(std::move(playlist)),
      patience_s_(patience_s),
      idle_(patience_s) {
  if (playlist_) {
    std::copy_if(playlist_->games.begin(), playlist_->games.end(), std::back_inserter(attracting_),
                 [](const PlaylistGame& game) { return game.attracts; });
  } else {
    attracting_.resize(2);
    attracting_[0].scenario = fileOfGame(kShowMe);
    attracting_[1].scenario = firstGame_;
  }
}

void Programme::welcome() {
  idle_.forget();
  isEmpty_ = true;
  emptyFrom_s_.reset();
  shown_.reset();
  began_s_.reset();
}

/// Returns the next of the games that attract, or none if there are none.
NextGame Programme::attract(double now_s) {
  if (attracting_.empty()) return {};
  shown_ = shown_ ? (*shown_ + 1) % attracting_.size() : 0;
  shownFrom_s_ = now_s;
  return {attracting_[*shown_].scenario.string(), false, true, true};
}

std::optional<Programme::Following> Programme::following(double now_s, const std::string& playing) {
  if (!playlist_ || !began_s_ || shown_) return {};
  if (playing != numbered_) {
    numbered_ = playing;
    number_ = numberOf(*playlist_, playing);
  }
  const std::size_t number = number_, games = playlist_->games.size();
  if (number == games || !playlist_->games[number].for_s) return {};
  const PlaylistGame& next = playlist_->games[(number + 1) % games];
  return Following{&next, *began_s_ + *playlist_->games[number].for_s - now_s};
}

std::optional<int> Programme::countdown(double now_s) const {
  const std::optional<double> left = idle_.left_s(now_s);
  if (!left || *left > std::min(kCountdown_s, 0.5 * *patience_s_)) return {};
  return std::max(0, static_cast<int>(std::ceil(*left)));
}

bool Programme::refuses(const Command& command) const {
  if (!isAllowed_) return false;
  const auto* play = std::get_if<PlayScenario>(&command);
  return (play && !isAllowed_(play->file)) || std::holds_alternative<WelcomeNextVisitor>(command);
}

NextGame Programme::look(const SignsOfLife& signs, const std::string& playing) {
  if (isAllowed_) return {};
  if (!began_s_) began_s_ = signs.now_s;
  if (!emptyFrom_s_) emptyFrom_s_ = signs.now_s;
  if (signs.watches) idle_.wait(signs.now_s);
  const bool isGone = idle_.look(signs.now_s, signs.acted, signs.head_m, signs.discusses);
  if (idle_.isSomebodyThere() && std::exchange(isEmpty_, false) && shown_) {
    shown_.reset();
    return {firstGame_, true};
  }
  if (isGone) {
    welcome();
    return {firstGame_, true};
  }
  const std::optional<Following> next = following(signs.now_s, playing);
  if (next && next->in_s <= 0.0) {
    began_s_ = signs.now_s;  // a game that cannot be played leaves this one for as long again
    return {next->game->scenario.string(), false, false, true};
  }
  if (!patience_s_ || !isEmpty_) return {};
  if (!shown_) return signs.now_s - *emptyFrom_s_ >= *patience_s_ ? attract(signs.now_s) : NextGame{};
  const double for_s = attracting_[*shown_].for_s.value_or(kAttract_s);
  return signs.now_s - shownFrom_s_ >= for_s ? attract(signs.now_s) : NextGame{};
}

}  // namespace carom
