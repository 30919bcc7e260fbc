#include "app/console/console_recording.h"

#include <cmath>
#include <ctime>
#include <string>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace carom::console {
namespace {

constexpr double kMeasuredEvery_s = 1.0;

/// Returns a name with today's date and the time, beside the session file or in the present folder.
std::filesystem::path timed(const std::optional<std::filesystem::path>& session, const char* what,
                            const char* ending) {
  const std::string name = fmt::format("{}-{:%F-%H%M%S}{}", what, fmt::localtime(std::time(nullptr)), ending);
  return session ? session->parent_path() / name : std::filesystem::path(name);
}

void made(const char* what, const std::filesystem::path& where, std::uint64_t frames, std::uint64_t leftOut,
          const char* option) {
  heading(what);
  if (where.empty()) return dim(fmt::format("Not made: start with {}.", option));
  words(where.string());
  dim(fmt::format("{} frames since the session began", frames));
  if (leftOut == 0) return;
  ImGui::TextColored(kFair, "%s",
                     fmt::format("{} left out: they came faster than they are written", leftOut).c_str());
}

}  // namespace

void RecordingPanel::drawLight(const ConsoleFrame& frame) const {
  const bool replay = frame.keys == KeysOf::replay;
  light(file_ ? kBad : kDim);
  ImGui::SameLine(0.0F, 4.0F);
  words(file_    ? fmt::format("recording {}", file_->filename().string())
        : replay ? "a recorded session"
                 : "not recorded");
  tip(file_    ? file_->string()
      : replay ? "What you do here is not written."
               : "Start with --session FILE to keep the session.");
}

void RecordingPanel::draw(const ConsoleFrame& frame) {
  heading("Session file");
  if (!file_) {
    dim(frame.keys == KeysOf::replay ? "This is a recorded session: nothing is written."
                                     : "The session is not recorded: start with --session FILE.");
  } else {
    if (std::abs(frame.record.display_s - measured_s_) >= kMeasuredEvery_s) {
      measured_s_ = frame.record.display_s;
      bytes_ = 0;
      for (const char* part : {"", "-wal"}) {  // the WAL file of SQLite
        std::error_code failed;
        const std::uintmax_t bytes = std::filesystem::file_size(file_->string() + part, failed);
        if (!failed) bytes_ += bytes;
      }
    }
    words(file_->string());
    dim(fmt::format("{:.1f} MB, up to frame {}", 1e-6 * static_cast<double>(bytes_), frame.record.number));
  }
  const RecordingReport report = frame.recording.report();
  made("Pictures of every wall and eye", report.capture, report.captured, report.notCaptured,
       "--capture DIR");
  made("Movie", report.movie, report.filmed, report.notFilmed, "--movie FILE");
  if (frame.keys == KeysOf::session) drawButtons(frame, report);
}

/// Draws what starts and ends recordings while the session runs.
void RecordingPanel::drawButtons(const ConsoleFrame& frame, const RecordingReport& report) const {
  ImGui::Spacing();
  if (report.movie.empty()) {
    if (ImGui::Button("Start a movie")) frame.recording.startMovie(timed(file_, "carom", ".mp4"));
    tip("Of the walls that this node draws, the left eye's, beside the session file or in the present "
        "folder.");
  } else {
    if (ImGui::Button("End the movie")) frame.recording.endMovie();
    tip("The session stands still until the movie is whole.");
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(!report.capture.empty());
  if (ImGui::Button("Take pictures")) frame.recording.takePictures(timed(file_, "carom-pictures", ""));
  ImGui::EndDisabled();
  tip("Of every wall and eye of this node, now.");
  ImGui::SameLine();
  ImGui::BeginDisabled(file_.has_value() || frame.settings.playing.empty());
  if (ImGui::Button("Restart and record")) {
    frame.commands.emplace_back(
        PlayScenario{frame.settings.playing, false, timed({}, "carom", ".db").string()});
  }
  ImGui::EndDisabled();
  tip("A session file holds games from their beginning: this one starts again, and from then on all are "
      "kept.");
}

}  // namespace carom::console
