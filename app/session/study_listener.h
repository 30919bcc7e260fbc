#pragma once
// Lets a study move the room: after each frame its commands go into the director's inbox, as the console's
// do.

#include "app/class_server/study_desk.h"
#include "app/session/director.h"
#include "app/session/frame_listener.h"

namespace carom {

class StudyListener : public FrameListener {
 public:
  /// Both must outlive this object.
  StudyListener(StudyDesk& study, FrameLeader& leader) : study_(study), leader_(leader) {}

  void shown(const Decision& decision) override {
    study_.command(leader_.settings(), decision.frame.record.display_s, leader_.inbox());
  }

  StudyDesk& desk() { return study_; }

 private:
  StudyDesk& study_;
  FrameLeader& leader_;
};

}  // namespace carom
