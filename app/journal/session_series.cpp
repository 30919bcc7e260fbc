#include "app/journal/session_series.h"

#include <fmt/format.h>

namespace carom {
namespace {

std::filesystem::path fileOf(std::filesystem::path first, int game) {
  return first.replace_filename(
      fmt::format("{}-{}{}", first.stem().string(), game, first.extension().string()));
}

int nextGame(const std::filesystem::path& first) {
  int game = 2;
  while (std::filesystem::exists(fileOf(first, game))) ++game;
  return game;
}

}  // namespace

std::filesystem::path fileAfter(const std::filesystem::path& first) { return fileOf(first, nextGame(first)); }

std::filesystem::path newestOf(const std::filesystem::path& first) {
  const int next = nextGame(first);
  return next == 2 ? first : fileOf(first, next - 1);
}

}  // namespace carom
