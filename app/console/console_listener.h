#pragma once
// Shows the frames of a game in the operator's console. It is called when a frame is already on the walls, so
// that the console delays no wall.

#include "app/console/console.h"
#include "app/session/director.h"
#include "app/session/frame_listener.h"
#include "app/session/frame_statistics.h"
#include "app/stage/session_setup.h"

namespace carom {

class ConsoleListener : public FrameListener {
 public:
  /// Shows frames in `console`. `classroom` is null if no class takes part, `study` if there is none. All
  /// arguments must outlive this object.
  ConsoleListener(Console& console, const SessionSetup& setup, FrameStatistics& statistics,
                  const FrameSource& source, FrameLeader& leader, KeysOf keys, ClassDesk* classroom = nullptr,
                  StudyDesk* study = nullptr)
      : console_(console),
        setup_(setup),
        statistics_(statistics),
        source_(source),
        leader_(leader),
        keys_(keys),
        classroom_(classroom),
        study_(study) {}

  void shown(const Decision& decision) override;

 private:
  Console& console_;
  const SessionSetup& setup_;
  FrameStatistics& statistics_;
  const FrameSource& source_;
  FrameLeader& leader_;
  KeysOf keys_;
  ClassDesk* classroom_;
  StudyDesk* study_;
  SourceStatus status_;
  double asked_s_ = -1.0;  ///< session clock: when the source was last asked for its status
};

}  // namespace carom
