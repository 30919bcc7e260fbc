#pragma once
// The pages to take home, each under a code. They stay for an hour. Times are seconds on any steady clock.

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "app/classroom/guess_gate.h"

namespace carom {

class TakeCodes {
 public:
  static constexpr double kKept_s = 3600.0;
  static constexpr double kOffered_s = 90.0;     ///< so long the walls offer a new page
  static constexpr std::size_t kMostPages = 40;  ///< the newest: a page has some megabytes
  static constexpr std::size_t kTries = 10;      ///< wrong codes from an address within a minute

  enum class Answer { page, unknown, expired, silence };
  struct Found {
    Answer answer = Answer::unknown;
    std::shared_ptr<const std::string> page{};  ///< null but for Answer::page
  };

  /// Keeps a page under its code.
  void keep(const std::string& code, std::string page, double now_s);
  /// Returns the code of the newest page while it is offered; otherwise nothing.
  std::string offered(double now_s) const;
  /// Returns what somebody at this address gets for a code.
  Found find(std::string_view code, const std::string& address, double now_s);

 private:
  struct Kept {
    std::shared_ptr<const std::string> page;  ///< null: its hour is over
    double since_s = 0.0;
  };
  void forget(double now_s);

  std::map<std::string, Kept, std::less<>> pages_;
  std::string newest_;
  GuessGate gate_{kTries};
};

}  // namespace carom
