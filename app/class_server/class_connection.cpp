// One connection to the server of a class: its request, and its WebSocket. What a request is answered with is
// in class_answers.cpp.
#include <boost/asio/buffer.hpp>

#include "app/class_server/class_host.h"
#include "app/study/form_fields.h"

namespace carom {
namespace {

constexpr std::size_t kMostUnsent = 2;  // messages to a follower, with the one that is under way

}  // namespace

void ClassHost::Connection::begin() {
  parser_.emplace();
  parser_->header_limit(static_cast<std::uint32_t>(host_.limits().requestBytes));
  parser_->body_limit(host_.options().studyPage ? kMostFormBytes : 0);
  stream_.expires_after(host_.limits().request);
  http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](error_code failed, std::size_t) {
    failed ? self->end() : self->answer();
  });
}

void ClassHost::Connection::tell() {
  if (!socket_ || !isOpen_ || isFollower_) return;
  if (isTelling_) {
    tellsAgain_ = true;
    return;
  }
  isTelling_ = true;
  tellsAgain_ = false;
  told_ = host_.room().messageFor(id_);
  socket_->text(true);
  socket_->async_write(asio::buffer(told_), [self = shared_from_this()](error_code failed, std::size_t) {
    self->isTelling_ = false;
    if (failed) return self->end();
    if (self->tellsAgain_) self->tell();
  });
}

void ClassHost::Connection::follow(const std::shared_ptr<const std::string>& news) {
  if (unsent_.size() >= kMostUnsent) {
    hasGap_ = true;  // a slow phone is left out, not waited for
    return;
  }
  const auto message = hasGap_ ? host_.whole() : news;
  if (message->empty()) return;
  hasGap_ = false;
  unsent_.push_back(message);
  if (unsent_.size() == 1) send();
}

/// Sends what waits, one message after the other.
void ClassHost::Connection::send() {
  socket_->binary(true);
  socket_->async_write(asio::buffer(*unsent_.front()),
                       [self = shared_from_this()](error_code failed, std::size_t) {
                         if (failed) return self->end();
                         self->unsent_.pop_front();
                         if (!self->unsent_.empty()) self->send();
                       });
}

void ClassHost::Connection::drop() {
  error_code ignored;
  (socket_ ? beast::get_lowest_layer(*socket_) : stream_).socket().close(ignored);
  end();
}

void ClassHost::Connection::openSocket() {
  stream_.expires_never();  // the WebSocket has times of its own
  socket_.emplace(std::move(stream_));
  socket_->set_option(websocket::stream_base::timeout{host_.limits().request, host_.limits().silence, true});
  socket_->read_message_max(kMostMessageBytes);
  socket_->async_accept(parser_->get(), [self = shared_from_this()](error_code failed) {
    if (failed) return self->end();
    self->isOpen_ = true;
    self->heard_ = SteadyClock::now();
    self->buffer_.clear();
    self->read();
  });
}

void ClassHost::Connection::read() {
  socket_->async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t bytes) {
    failed ? self->end() : self->take(bytes);
  });
}

/// Takes a message of this size.
void ClassHost::Connection::take(std::size_t bytes) {
  heard_ = SteadyClock::now();
  if (!allowance_.take(secondsOf(heard_))) return drop();  // who floods would not hear why
  if (isFollower_ || !socket_->got_text()) return close(websocket::close_code::unknown_data);
  const std::string_view words(static_cast<const char*>(buffer_.data().data()), bytes);
  host_.received(*this, phoneMessageOf(words));
  buffer_.consume(buffer_.size());
  read();
}

void ClassHost::Connection::close(websocket::close_code why) {
  isOpen_ = false;
  socket_->async_close(why, [self = shared_from_this()](error_code) { self->end(); });
}

}  // namespace carom
