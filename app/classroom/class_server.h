#pragma once
// The server of a class: pages over HTTP and messages over WebSockets, on one address and in a thread of its
// own that frames never wait for. Whatever comes in is hostile until it is parsed: few paths, small requests,
// few messages a second, our own Host and Origin, limited sockets and times.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/classroom/classroom.h"
#include "app/classroom/mailbox.h"

namespace carom {

/// What one phone, one computer and all together may take up.
struct ClassLimits {
  std::size_t sockets = 300;                 ///< in all
  std::size_t socketsOfAddress = 250;        ///< from one address, so that it cannot keep others out
  std::size_t requestBytes = 8192;           ///< of a request's header
  std::chrono::milliseconds request{10000};  ///< until a connection has said who it is
  std::chrono::milliseconds silence{30000};  ///< of a phone that does not even answer a ping
  double messages_1_s = 10.0;                ///< of a phone, in the mean
  double burst = 20.0;                       ///< messages at once
};

struct ClassServerOptions {
  std::string address = "127.0.0.1";  ///< to listen on, in numbers
  std::uint16_t port = 0;             ///< 0: any that is free
  std::string word, pin;
  ClassLimits limits{};
  /// Of a study: returns the page of an address, from what follows its question mark. The server then has
  /// these pages alone. Called in the server's thread.
  std::function<std::string(std::string_view query)> studyPage{};
  /// Takes a form, and returns the address of the page that follows.
  std::function<std::string(std::string_view form)> studyForm{};
  std::string studyStyle{};
};

class ClassServer {
 public:
  /// Begins to listen. `left`: where the class of this session file broke off. Throws std::runtime_error
  /// with the fault of address or port.
  ClassServer(const ClassServerOptions& options, const std::optional<ClassLeft>& left = {});
  ~ClassServer();
  ClassServer(const ClassServer&) = delete;
  ClassServer& operator=(const ClassServer&) = delete;

  const ClassInvitation& invitation() const;

  /// Tell the class what has happened on the wall, or what the teacher wants at the console. From any thread.
  void tell(LessonNews news);
  void ask(ClassStep step);

  // What the class has for the frames.
  Mailbox<LessonWish>& wishes();
  Mailbox<ClassVote>& votes();
  Mailbox<ClassView>& views();

 private:
  class Host;
  std::unique_ptr<Host> host_;
};

}  // namespace carom
