#pragma once
// The server of a class: pages over HTTP and messages over WebSockets, on one address and in a thread of its
// own that frames never wait for. Whatever comes in is hostile until it is parsed: few paths, small requests,
// few messages a second, our own Host and Origin, limited sockets and times.

#include <memory>
#include <optional>
#include <string>

#include "app/class_server/class_server_options.h"
#include "app/class_server/mailbox.h"
#include "app/classroom/classroom.h"

namespace carom {

class ClassHost;

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

  /// Keeps a page under its code, and offers it on the walls. From any thread.
  void offer(const std::string& code, std::string page);

  // What the class has for the frames.
  Mailbox<LessonWish>& wishes();
  Mailbox<ClassVote>& votes();
  Mailbox<ClassView>& views();

 private:
  std::unique_ptr<ClassHost> host_;
};

}  // namespace carom
