#include "app/console/console_listener.h"

#include <cmath>

namespace carom {
namespace {

constexpr double kAskedEvery_s = 0.25;

}  // namespace

void ConsoleListener::shown(const Decision& decision) {
  const FrameRecord& record = decision.frame.record;
  for (const Note& input : decision.inputs) console_.say(input.what + ": " + input.value);
  if (std::abs(record.display_s - asked_s_) >= kAskedEvery_s) {
    asked_s_ = record.display_s;
    status_ = source_.status();
  }
  console_.show({record, setup_.world, *setup_.walls, statistics_.numbers(record), status_, *setup_.recording,
                 keys_, leader_.settings(), leader_.following(record.display_s), leader_.inbox(), classroom_,
                 study_});
}

}  // namespace carom
