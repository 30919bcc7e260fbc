#pragma once
// Says that a session with a study is open, also between two lessons, when no journal writes to its file: a
// lock on FILE-study beside it. A lock on the file itself would end the locks that SQLite has on it in this
// program.

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

namespace carom {

class StudyLock {
 public:
  /// Takes the lock of a session file, if it is free.
  explicit StudyLock(const std::filesystem::path& session)
      : file_(session.string() + "-study"), fd_(::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    isTaken_ = fd_ >= 0 && ::flock(fd_, LOCK_EX | LOCK_NB) == 0;
  }
  ~StudyLock() {
    if (isTaken_) ::unlink(file_.c_str());
    if (fd_ >= 0) ::close(fd_);
  }
  StudyLock(const StudyLock&) = delete;
  StudyLock& operator=(const StudyLock&) = delete;

  /// Returns whether this object has it; otherwise a session has.
  bool isTaken() const { return isTaken_; }

 private:
  std::filesystem::path file_;
  int fd_ = -1;
  bool isTaken_ = false;
};

}  // namespace carom
