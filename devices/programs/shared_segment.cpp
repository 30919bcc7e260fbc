#include "devices/programs/shared_segment.h"

#include <sys/ipc.h>
#include <sys/shm.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include "devices/tracker/retry.h"

namespace carom {
namespace {

[[noreturn]] void refuse(int key, int error) {
  const std::string segment = "shared memory of key " + std::to_string(key);
  if (error == ENOENT)
    throw std::runtime_error("there is no " + segment + ": trackd does not run, or uses another key");
  const std::string reason = std::generic_category().message(error);
  if (error == EACCES) throw NeedsHelp("the " + segment + " may not be read by this user: " + reason);
  throw std::runtime_error("the " + segment + " cannot be read: " + reason);
}

/// Returns what the system knows of a segment; a mode with SHM_DEST if it knows none.
shmid_ds stateOf(int id) {
  shmid_ds state{};
  if (shmctl(id, IPC_STAT, &state) != 0) state.shm_perm.mode = SHM_DEST;
  return state;
}

}  // namespace

SharedSegment::SharedSegment(int key) : key_(key), id_(shmget(key, 0, 0)) {
  if (id_ < 0) refuse(key, errno);
  const void* from = shmat(id_, nullptr, SHM_RDONLY);
  if (from == reinterpret_cast<const void*>(-1)) refuse(key, errno);
  bytes_ = {static_cast<const std::uint8_t*>(from), stateOf(id_).shm_segsz};
}

SharedSegment::~SharedSegment() { shmdt(bytes_.data()); }

bool SharedSegment::isGone() const {
  return (stateOf(id_).shm_perm.mode & SHM_DEST) != 0 || shmget(key_, 0, 0) != id_;
}

bool SharedSegment::isOurs() const { return stateOf(id_).shm_nattch <= 1; }

}  // namespace carom
