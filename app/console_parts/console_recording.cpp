#include "app/console_parts/console_recording.h"

#include <cmath>
#include <ctime>
#include <string>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

constexpr double kMeasuredEvery_s = 1.0;

/// Returns the name of a session file in the present folder, with today's date and the time.
std::string datedSession() {
  return fmt::format("carom-{:%F-%H%M%S}.db", fmt::localtime(std::time(nullptr)));
}

void made(texts::Text what, const std::filesystem::path& where, std::uint64_t frames, std::uint64_t leftOut,
          texts::Text option) {
  heading(what);
  if (where.empty()) return dim(texts::format(texts::console::kNotMade, option));
  words(where.string());
  dim(texts::format(texts::console::kFrames, frames));
  if (leftOut == 0) return;
  ImGui::TextColored(kFair, "%s", texts::format(texts::console::kLeftOut, leftOut).c_str());
}

}  // namespace

void RecordingPanel::drawLight(const ConsoleFrame& frame) const {
  const bool replay = frame.keys == KeysOf::replay;
  light(file_ ? kBad : kDim);
  ImGui::SameLine(0.0F, 4.0F);
  words(file_    ? texts::format(texts::console::kRecording, file_->filename().string())
        : replay ? texts::console::kRecorded.words()
                 : texts::console::kNotRecorded.words());
  tip(file_    ? file_->string()
      : replay ? texts::console::kRecordedSessionTip.words()
               : texts::console::kNotRecordedTip.words());
}

void RecordingPanel::draw(const ConsoleFrame& frame) {
  heading(texts::console::kSessionFile);
  if (!file_) {
    dim(frame.keys == KeysOf::replay ? texts::console::kRecordedSession
                                     : texts::console::kNotRecordedSession);
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
    dim(texts::format(texts::console::kFileSize, 1e-6 * static_cast<double>(bytes_), frame.record.number));
  }
  const RecordingReport report = frame.recording.report();
  made(texts::console::kCapture, report.capture, report.captured, report.notCaptured,
       texts::console::kCaptureOption);
  made(texts::console::kMovie, report.movie, report.filmed, report.notFilmed, texts::console::kMovieOption);
  if (isLive(frame.keys)) drawButtons(frame, report);
}

/// Draws what starts and ends recordings while the session runs.
void RecordingPanel::drawButtons(const ConsoleFrame& frame, const RecordingReport& report) const {
  ImGui::Spacing();
  if (report.movie.empty()) {
    if (ImGui::Button(texts::console::kStartMovie)) frame.recording.startMovie();
    tip(texts::console::kStartMovieTip);
  } else {
    if (ImGui::Button(texts::console::kEndMovie)) frame.recording.endMovie();
    tip(texts::console::kEndMovieTip);
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(!report.capture.empty());
  if (ImGui::Button(texts::console::kTakePictures)) frame.recording.takePictures("carom-pictures");
  ImGui::EndDisabled();
  tip(texts::console::kTakePicturesTip);
  ImGui::SameLine();
  ImGui::BeginDisabled(file_.has_value() || frame.settings.playing.empty());
  if (ImGui::Button(texts::console::kRecordAnew)) {
    frame.commands.emplace_back(PlayScenario{frame.settings.playing, false, datedSession()});
  }
  ImGui::EndDisabled();
  tip(texts::console::kRecordAnewTip);
}

}  // namespace carom::console
