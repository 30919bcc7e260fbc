#pragma once
// Who listens to the frames of a session.

#include <functional>
#include <memory>
#include <optional>

#include "app/journal/journal.h"
#include "app/session/frame_listener.h"
#include "app/session/frame_source.h"
#include "app/session/frame_statistics.h"
#include "app/stage/recording.h"
#include "cave/audio/sounds.h"
#include "cave/process/termination.h"

namespace carom {

/// Writes what the decisions say into the session file: inputs, notes, answers, strokes and the frames themselves.
class JournalListener : public FrameListener {
 public:
  JournalListener() = default;
  ~JournalListener() override { keep(nullptr); }
  JournalListener(const JournalListener&) = delete;
  JournalListener& operator=(const JournalListener&) = delete;

  /// Writes to this journal from now on and closes the one before; null: the session is not written.
  void keep(std::unique_ptr<Journal> journal);

  /// Takes the statistics of nodes and parts from there; null: from nowhere.
  void measureBy(const FrameStatistics* statistics) { statistics_ = statistics; }

  void shown(const Decision& decision) override;

 private:
  std::unique_ptr<Journal> journal_;
  std::optional<ClosedOnLeaving> onLeaving_;  ///< of the journal
  const FrameStatistics* statistics_ = nullptr;
};

/// Takes pictures and movie of the walls, and of the room from outside where there is one.
class RecordingListener : public FrameListener {
 public:
  RecordingListener(Recording& recording, const DisplayWalls& walls, const SpectatorView* outside)
      : recording_(recording), walls_(walls), outside_(outside) {}

  void shown(const Decision& decision) override { recording_.take(walls_, outside_, decision.frame.record); }

 private:
  Recording& recording_;
  const DisplayWalls& walls_;
  const SpectatorView* outside_;
};

/// Makes the game heard.
class SoundsListener : public FrameListener {
 public:
  SoundsListener(Sounds& sounds, const World& world) : sounds_(sounds), world_(world) {}

  void shown(const Decision& decision) override { sounds_.shown(decision.frame.record, world_.events); }

 private:
  Sounds& sounds_;
  const World& world_;
};

/// For who waits for frames that nobody watches: says on standard error how many there are.
class ProgressListener : public FrameListener {
 public:
  explicit ProgressListener(const FrameSource& source) : source_(source) {}

  void shown(const Decision& decision) override;

 private:
  const FrameSource& source_;
};

}  // namespace carom
