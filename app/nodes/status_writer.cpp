#include "app/nodes/status_writer.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

constexpr std::chrono::seconds kEvery{1};

std::string now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

}  // namespace

nlohmann::ordered_json statusOf(const char* state) {
  return {{"version", CAROM_VERSION}, {"written", now()}, {"state", state}, {"process", getpid()}};
}

std::string linesOf(const nlohmann::ordered_json& status) {
  return status.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ReadStatus readStatus(const std::filesystem::path& file) try {
  std::ifstream in(file);
  const auto json = nlohmann::json::parse(in);
  ReadStatus status{json.at("state").get<std::string>(), json.at("process").get<pid_t>()};
  if (json.contains("frame")) status.frame = json["frame"].get<std::uint64_t>();
  return status;
} catch (const nlohmann::json::exception&) {
  return {};
}

std::string withNewTime(const std::filesystem::path& file) try {
  std::ifstream in(file);
  auto status = nlohmann::ordered_json::parse(in);
  if (kill(status.at("process").get<pid_t>(), 0) == 0) return {};
  status["written"] = now();
  return linesOf(status);
} catch (const nlohmann::json::exception&) {
  return {};
}

StatusWriter::StatusWriter(std::filesystem::path file, std::function<std::string()> text)
    : file_(std::move(file)), text_(std::move(text)) {
  WholeFile(file_).commit(text_());
  thread_ = std::jthread([this](const std::stop_token& stop) { keepWriting(stop); });
}

void StatusWriter::writeSoon() {
  const std::scoped_lock hold(waking_);
  isDue_ = true;
  due_.notify_one();
}

void StatusWriter::keepWriting(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    {
      std::unique_lock hold(waking_);
      due_.wait_for(hold, stop, kEvery, [this] { return isDue_; });
      isDue_ = false;
    }
    if (!stop.stop_requested()) write();
  }
}

void StatusWriter::write() try {
  const std::scoped_lock hold(writing_);
  const std::string text = hasEnded_ ? "" : text_();
  if (!text.empty()) WholeFile(file_).commit(text);
} catch (const NotWritten& error) {
  if (!std::exchange(hasFailed_, true))
    log::warn(fmt::format("{}: {}. The session goes on.", error.what(), error.reason()));
}

void StatusWriter::end(const std::function<std::string()>& lastWords) {
  const std::scoped_lock hold(writing_);
  if (std::exchange(hasEnded_, true)) return;
  const std::string text = lastWords();
  if (!text.empty()) WholeFile(file_).commit(text);
}

}  // namespace carom
