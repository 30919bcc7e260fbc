#pragma once
// A device's thread has to run as soon as its device has spoken, however busy the machine is: a pose that
// waits for a processor reaches the eye a frame late.

namespace carom {

/// What the system granted a thread.
enum class Promptness {
  usual,     ///< nothing beyond what every thread has
  nicer,     ///< a nice value of −10: a larger share, and mostly woken at once
  realTime,  ///< SCHED_RR at its lowest priority: before all that is not real-time
};

/// Asks for the calling thread, first `realTime`, then `nicer`; where both are refused it goes on as it is,
/// and a sample may wait some milliseconds on a machine whose every core is busy. A thread that is real-time
/// already is left alone. Threads that it starts are not given the same. An ordinary user is granted what
/// /etc/security/limits.conf says (`rtprio` of 1 or more, `nice` of −10 or less); root and CAP_SYS_NICE need
/// nothing.
///
/// A thread that asks must sleep between packets. What a flood of packets can take of a core is bounded by
/// the kernel, which keeps a share of it for the others (/proc/sys/kernel/sched_rt_runtime_us).
/// Source: sched(7), setpriority(2).
Promptness askForPromptness();

}  // namespace carom
