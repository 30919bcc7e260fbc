#pragma once
// Another program that runs as a child of this one and whose output is read.

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carom {

class ChildProgram {
 public:
  /// Starts the program that PATH has under command[0], without a shell, in a process group of its own. Its
  /// output comes by a pseudo-terminal, so that it writes each line at once. Throws NeedsHelp
  /// (devices/tracker/retry.h) if PATH has no such program, and std::runtime_error if it cannot be started.
  explicit ChildProgram(const std::vector<std::string>& command);
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;
  /// Asks the program and its children to end, and ends them if they have not after 0.15 s.
  ~ChildProgram();

  /// Waits until there is something to read; returns false if the time is over first.
  bool waitReadable(std::chrono::milliseconds longest) const;
  /// Reads what it has written into `bytes`; returns the size, or none if there is nothing. 0: it has ended.
  std::optional<std::size_t> receive(std::span<std::uint8_t> bytes);
  /// Returns, of a program that has ended, how it did and the last line that it wrote to standard error.
  std::string howItEnded();

 private:
  /// A file descriptor, closed with this object.
  class Descriptor {
   public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    ~Descriptor() { close(); }
    int number() const { return number_; }
    void close();

   private:
    int number_;
  };
  void start(const std::vector<std::string>& command, int output, int errors);
  void readErrors();
  bool hasEnded(std::chrono::milliseconds within);

  Descriptor output_, errors_;
  std::string lastErrors_;
  pid_t process_ = -1;
  std::optional<int> status_;
};

}  // namespace carom
