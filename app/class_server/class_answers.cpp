// What the server of a class answers to a request.
#include "app/class_server/class_host.h"
#include "app/study/form_fields.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// The page may load and reach what this server has, nothing else, and no other page may frame it.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data:; "
    "frame-ancestors 'none'; base-uri 'none'";

/// A page of the engine (app/page/page_file.h) has all in itself; its own policy says whether it may ask
/// this server.
constexpr const char* kPagePolicy =
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src "
    "data:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'";

}  // namespace

void ClassHost::Connection::answer() {
  const auto& request = parser_->get();
  const beast::string_view target = request.target(), path = target.substr(0, target.find('?'));
  if (!host_.isOurs(request[http::field::host])) return respond(http::status::misdirected_request);
  if (host_.options().studyPage) return answerStudy(target, path);
  isFollower_ = path == "/follow/socket" && host_.options().followed;
  if (path == "/socket" || isFollower_) {
    if (!websocket::is_upgrade(request)) return respond(http::status::upgrade_required);
    return host_.isOurPage(request[http::field::origin]) ? openSocket() : respond(http::status::forbidden);
  }
  const ClassPages& pages = host_.pages();
  if (request.method() != http::verb::get) return respond(http::status::method_not_allowed);
  if (path == "/" || path == "/teacher")
    return respond(http::status::ok, "text/html; charset=utf-8", pages.page);
  if (path == "/class.css") return respond(http::status::ok, "text/css; charset=utf-8", pages.style);
  if (path == "/class.js") return respond(http::status::ok, "text/javascript; charset=utf-8", pages.script);
  if (!answerPages(path)) respond(http::status::not_found);
}

/// Answers a request for a page of the engine: the game that is played, or one to take home.
bool ClassHost::Connection::answerPages(beast::string_view path) {
  constexpr beast::string_view kTake = "/take/";
  if (path == "/follow" && host_.options().followed) {
    const auto page = host_.options().followed->page();
    if (!page) response_.set("Refresh", "2");  // the browser asks again by itself
    page ? respondPage(*page) : say(http::status::service_unavailable, texts::page::kNotYet);
    return true;
  }
  if (!path.starts_with(kTake)) return false;
  const beast::string_view code = path.substr(kTake.size());
  const auto found = host_.codes().find({code.data(), code.size()}, address, secondsOf(SteadyClock::now()));
  switch (found.answer) {
    case TakeCodes::Answer::page:
      respondPage(*found.page);
      break;
    case TakeCodes::Answer::unknown:
      say(http::status::not_found, texts::page::kNoSuchCode);
      break;
    case TakeCodes::Answer::expired:
      say(http::status::gone, texts::page::kExpired);
      break;
    case TakeCodes::Answer::silence:
      say(http::status::too_many_requests, texts::page::kSilence);
      break;
  }
  return true;
}

void ClassHost::Connection::respondPage(const std::string& page) {
  response_.set("Content-Security-Policy", kPagePolicy);
  respond(http::status::ok, "text/html; charset=utf-8", page);
}

void ClassHost::Connection::say(http::status status, const char* words) {
  respond(status, "text/plain; charset=utf-8", words);
}

/// Answers a request for a page of a study: by itself, or with a form that one of its own pages sends.
void ClassHost::Connection::answerStudy(beast::string_view target, beast::string_view path) {
  const auto& request = parser_->get();
  const bool isForm = request.method() == http::verb::post;
  if (!isForm && request.method() != http::verb::get) return respond(http::status::method_not_allowed);
  if (isForm && (path != "/study" || !host_.isOurPage(request[http::field::origin])))
    return respond(http::status::forbidden);
  if (path == "/study.css")
    return respond(http::status::ok, "text/css; charset=utf-8", host_.options().studyStyle);
  if (path != "/" && path != "/study") return respond(http::status::not_found);
  if (isForm) {  // the page that follows is asked for by itself: going back or reloading sends nothing again
    response_.set(http::field::location, host_.options().studyForm(request.body()));
    return respond(http::status::see_other);
  }
  const beast::string_view query = target.substr(std::min(path.size() + 1, target.size()));
  respond(http::status::ok, "text/html; charset=utf-8",
          host_.options().studyPage({query.data(), query.size()}));
}

void ClassHost::Connection::respond(http::status status, const char* type, const std::string& body) {
  response_.result(status);
  response_.set(http::field::content_type, type);
  response_.set(http::field::cache_control, "no-store");
  if (response_["Content-Security-Policy"].empty()) response_.set("Content-Security-Policy", kPolicy);
  response_.set("X-Content-Type-Options", "nosniff");
  // Under "no-referrer" a browser sends a form of ours with the origin "null", which isOurPage refuses.
  response_.set("Referrer-Policy", "same-origin");
  response_.keep_alive(false);
  response_.body() = body;
  response_.prepare_payload();
  stream_.expires_after(host_.limits().request);
  http::async_write(stream_, response_, [self = shared_from_this()](error_code, std::size_t) {
    error_code ignored;
    self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    self->end();
  });
}

}  // namespace carom
