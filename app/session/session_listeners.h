#pragma once
// The listeners to the frames of a session.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/journal/journal.h"
#include "app/live/frame_source.h"
#include "app/session/frame_listener.h"
#include "app/session/frame_statistics.h"
#include "app/stage/recording.h"
#include "cave/audio/sounds.h"
#include "cave/headset/headset_pacer.h"
#include "cave/process/termination.h"

namespace carom {

/// Writes each decision into the session file: inputs, notes, answers, strokes and the frame itself.
class JournalListener : public FrameListener {
 public:
  JournalListener() = default;
  ~JournalListener() override { keep(nullptr); }
  JournalListener(const JournalListener&) = delete;
  JournalListener& operator=(const JournalListener&) = delete;

  /// What ends, and is noted in the journal, before it is closed as the process ends: whether or not there is
  /// a journal, and also where no object is destroyed. May be called from another thread.
  using LastNotes = std::function<std::vector<Note>()>;
  void endWith(LastNotes lastNotes) { lastNotes_ = std::move(lastNotes); }

  /// Writes to `journal` from now on and closes the previous one. Null stops the writing.
  void keep(std::unique_ptr<Journal> journal);

  /// Sets the source of the statistics of nodes and parts; null if there is none.
  void measureBy(const FrameStatistics* statistics) { statistics_ = statistics; }

  void shown(const Decision& decision) override;
  /// Writes notes of the session's end, with the number of the last frame.
  void add(const std::vector<Note>& notes);

 private:
  std::atomic<std::uint64_t> last_ = 0;  ///< number of the last frame
  std::unique_ptr<Journal> journal_;
  LastNotes lastNotes_;
  std::optional<ClosedOnLeaving> onLeaving_;  ///< closes the journal when the process ends
  const FrameStatistics* statistics_ = nullptr;
};

/// Captures images and the movie of the walls, and of the spectator view if there is one.
class RecordingListener : public FrameListener {
 public:
  RecordingListener(Recording& recording, const DisplayWalls& walls, const SpectatorView* outside)
      : recording_(recording), walls_(walls), outside_(outside) {}

  void shown(const Decision& decision) override {
    if (decision.keepsShot) recording_.takePictures("carom-best-shot");
    recording_.take(walls_, outside_, decision.frame.record);
  }

 private:
  Recording& recording_;
  const DisplayWalls& walls_;
  const SpectatorView* outside_;
};

/// Lets the controller of a headset be felt: it trembles as the cue is drawn back, and knocks with the
/// stroke.
class HapticListener : public FrameListener {
 public:
  explicit HapticListener(Headset& headset) : headset_(headset) {}

  void shown(const Decision& decision) override;

 private:
  Headset& headset_;
};

/// Plays the game's sounds.
class SoundsListener : public FrameListener {
 public:
  SoundsListener(Sounds& sounds, const World& world) : sounds_(sounds), world_(world) {}

  void shown(const Decision& decision) override { sounds_.shown(decision.frame.record, world_.events); }

 private:
  Sounds& sounds_;
  const World& world_;
};

/// Prints the number of frames so far to standard error, for runs without a watcher.
class ProgressListener : public FrameListener {
 public:
  explicit ProgressListener(const FrameSource& source) : source_(source) {}

  void shown(const Decision& decision) override;

 private:
  const FrameSource& source_;
};

}  // namespace carom
