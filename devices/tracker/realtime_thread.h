#pragma once
// Asks the system for prompt scheduling. A device's thread must run as soon as its device has sent something,
// however busy the machine is: a pose that waits for a processor reaches the eye a frame late.

namespace carom {

/// The scheduling that the system has granted a thread.
enum class Promptness {
  usual,     ///< that of every thread
  nicer,     ///< a nice value of −10: a larger share, and mostly woken at once
  realTime,  ///< SCHED_RR at its lowest priority: before every thread that is not real-time
};

/// Asks for `realTime` for the calling thread, then for `nicer`, and returns the granted one. If both are
/// refused, the thread continues as it is, and a sample may wait some milliseconds on a machine whose cores
/// are all busy. A thread that is already real-time is not changed. Threads that it starts do not inherit the
/// scheduling. An ordinary user is granted what /etc/security/limits.conf says (`rtprio` of 1 or more, `nice`
/// of −10 or less); root and CAP_SYS_NICE need nothing.
///
/// A thread that asks must sleep between packets. If packets flood it, the kernel limits what it takes of a
/// core and keeps a share for the others (/proc/sys/kernel/sched_rt_runtime_us). Source: sched(7),
/// setpriority(2).
Promptness askForPromptness();

}  // namespace carom
