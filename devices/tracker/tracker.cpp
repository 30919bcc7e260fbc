#include "devices/tracker/tracker.h"

namespace carom {

const char* toString(TrackerHealth::State state) {
  switch (state) {
    case TrackerHealth::State::connecting:
      return "connecting";
    case TrackerHealth::State::untouched:
      return "no presses yet";
    case TrackerHealth::State::delivering:
      return "delivering";
    case TrackerHealth::State::silent:
      return "silent";
    case TrackerHealth::State::failed:
      break;
  }
  return "failed";
}

}  // namespace carom
