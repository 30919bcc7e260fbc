#pragma once
// How much a process and its subprocesses may use to examine a file, so that no file, however it is made,
// keeps a machine busy or fills it.

#include <cstddef>
#include <string>

namespace carom {

/// The budget of a process that examines one file.
struct WorkBudget {
  double processor_s = 1.8;                ///< of this process and its subprocesses together
  std::size_t memory_bytes = 240U << 20U;  ///< of each of them, beyond what this process has now
};

/// Begins to count. A process that has used its time, or that ends because it cannot have more memory, prints
/// "error: " and `message` and exits with status 1. Call once, from a process with one thread.
void begin(const WorkBudget& budget, const std::string& message);

/// Returns the processor time that is left; without a budget, more than any job takes. Adjusts the time at
/// which this process ends: call it after each subprocess.
double budgetLeft_s();

/// Returns whether there is a budget.
bool hasBudget();

}  // namespace carom
