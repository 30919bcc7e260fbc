#include "app/classroom/take_codes.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

constexpr double kRemembered_s = 24.0 * 3600.0;  // that there was such a page

}  // namespace

/// Lets pages go whose hour is over.
void TakeCodes::forget(double now_s) {
  std::erase_if(pages_, [&](const auto& one) { return now_s - one.second.since_s >= kRemembered_s; });
  for (auto& [code, kept] : pages_)
    if (now_s - kept.since_s >= kKept_s) kept.page.reset();
}

void TakeCodes::keep(const std::string& code, std::string page, double now_s) {
  forget(now_s);
  newest_ = code;
  pages_[code] = {std::make_shared<const std::string>(std::move(page)), now_s};
  const auto isThere = [](const auto& one) { return one.second.page != nullptr; };
  if (std::count_if(pages_.begin(), pages_.end(), isThere) <= static_cast<std::ptrdiff_t>(kMostPages)) return;
  const auto age = [&](const auto& one) { return isThere(one) ? now_s - one.second.since_s : -1.0; };
  std::max_element(pages_.begin(), pages_.end(), [&](const auto& a, const auto& b) {
    return age(a) < age(b);
  })->second.page.reset();
}

std::string TakeCodes::offered(double now_s) const {
  const auto found = pages_.find(newest_);
  return found != pages_.end() && now_s - found->second.since_s < kOffered_s ? newest_ : "";
}

TakeCodes::Found TakeCodes::find(std::string_view code, const std::string& address, double now_s) {
  forget(now_s);
  if (gate_.isShut(address, now_s)) return {Answer::silence};
  const auto found = pages_.find(code);
  if (found == pages_.end()) {
    gate_.wrong(address, now_s);
    return {Answer::unknown};
  }
  if (!found->second.page) return {Answer::expired};
  return {Answer::page, found->second.page};
}

}  // namespace carom
