#include "app/journal/session_series.h"

#include <array>
#include <ctime>
#include <stdexcept>

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

std::filesystem::path fileAfter(const std::filesystem::path& first) {
  const int next = nextGame(first);
  return next == 2 && !std::filesystem::exists(first) ? first : fileOf(first, next);
}

std::filesystem::path newestOf(const std::filesystem::path& first) {
  const int next = nextGame(first);
  return next == 2 ? first : fileOf(first, next - 1);
}

std::filesystem::path namedToday(const std::filesystem::path& name) {
  if (name.string().find('%') == std::string::npos) return name;
  const std::time_t now = std::time(nullptr);
  std::tm today{};
  localtime_r(&now, &today);
  std::array<char, 256> text{};
  if (std::strftime(text.data(), text.size(), name.string().c_str(), &today) == 0) {
    throw std::runtime_error(fmt::format(
        "session file {}: the name is too long, expected one such as monday-%F.db", name.string()));
  }
  return text.data();
}

std::filesystem::path datedFile(const std::filesystem::path& name) {
  const std::filesystem::path file = namedToday(name);
  return file != name && std::filesystem::exists(file) ? fileAfter(file) : file;
}

}  // namespace carom
