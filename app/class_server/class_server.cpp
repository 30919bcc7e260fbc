#include "app/class_server/class_server.h"

#include <utility>

#include <boost/asio/post.hpp>

#include "app/class_server/class_host.h"

namespace carom {

ClassServer::ClassServer(const ClassServerOptions& options, const std::optional<ClassLeft>& left)
    : host_(std::make_unique<ClassHost>(options, left)) {
  host_->begin();
}

ClassServer::~ClassServer() = default;

const ClassInvitation& ClassServer::invitation() const { return host_->room().invitation(); }

void ClassServer::tell(LessonNews news) {
  asio::post(host_->io(), [host = host_.get(), news = std::move(news)] {
    host->room().follow(news, secondsOf(SteadyClock::now()));
    host->settle();
  });
}

void ClassServer::ask(ClassStep step) {
  asio::post(host_->io(), [host = host_.get(), step] {
    host->room().take(step, secondsOf(SteadyClock::now()));
    host->settle();
  });
}

void ClassServer::offer(const std::string& code, std::string page) {
  asio::post(host_->io(), [host = host_.get(), code, page = std::move(page)]() mutable {
    host->offer(code, std::move(page));
  });
}

Mailbox<LessonWish>& ClassServer::wishes() { return host_->outbox().wishes; }
Mailbox<ClassVote>& ClassServer::votes() { return host_->outbox().votes; }
Mailbox<ClassView>& ClassServer::views() { return host_->outbox().views; }

}  // namespace carom
