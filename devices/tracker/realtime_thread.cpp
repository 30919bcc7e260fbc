#include "devices/tracker/realtime_thread.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

namespace carom {

// On Linux process number 0 means the calling thread here, and each thread has a nice value of its own.
Promptness askForPromptness() {
  const int policy = sched_getscheduler(0);
  if (policy == SCHED_RR || policy == SCHED_FIFO) return Promptness::realTime;
  const sched_param lowest{sched_get_priority_min(SCHED_RR)}, none{0};
  if (sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &lowest) == 0) return Promptness::realTime;
  constexpr int kNicer = -10;
  sched_setscheduler(0, SCHED_OTHER | SCHED_RESET_ON_FORK, &none);
  return setpriority(PRIO_PROCESS, 0, kNicer) == 0 ? Promptness::nicer : Promptness::usual;
}

}  // namespace carom
