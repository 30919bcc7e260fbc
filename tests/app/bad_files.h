#pragma once
// Things that are no regular file, or too large a one, in the place of a file.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/text/outside_file.h"

namespace carom::test {

/// Makes something bad at a path.
struct BadThing {
  const char* name;
  std::function<void(const std::filesystem::path&)> make;
  const char* said;  ///< of a reader that is handed this path
};

inline void makeSocket(const std::filesystem::path& path) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  ASSERT_LT(path.string().size(), sizeof address.sun_path);
  std::strcpy(address.sun_path, path.c_str());
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
}

inline std::vector<BadThing> badThings(InputKind kind) {
  std::vector<BadThing> things{
      {"fifo", [](const auto& path) { ::mkfifo(path.c_str(), 0600); }, "this is a pipe, expected a"},
      {"device", [](const auto& path) { std::filesystem::create_symlink("/dev/zero", path); },
       "this is a device, expected a"},
      {"folder", [](const auto& path) { std::filesystem::create_directory(path); },
       "this is a folder, expected a"},
      {"socket", makeSocket, "this is a socket, expected a"},
      {"nothing", [](const auto& path) { std::filesystem::create_symlink("gone", path); },
       "there is no such file, expected a"}};
  if (kind == InputKind::session) return things;  // may have any size
  const std::uintmax_t bytes = (limitOf(kind).most_MiB << 20U) + 1;
  things.push_back({"large",
                    [bytes](const auto& path) {
                      ::close(::open(path.c_str(), O_CREAT | O_WRONLY, 0600));
                      std::filesystem::resize_file(path, bytes);  // takes no space on the disk
                    },
                    "the file is too large, "});
  return things;
}

}  // namespace carom::test
