#pragma once
// What a DTRACK2 or DTRACK3 controller answers to a command: "dtrack2 ok", "dtrack2 err 12 \"text\"" or
// "dtrack2 set NAME VALUE" (as ART's own DTrackSDK reads them). A zero byte ends each command and answer.

#include <string>
#include <string_view>

namespace carom {

struct DtrackAnswer {
  enum class Kind {
    ok,
    refused,  ///< `text` is "error 12: what it says"
    value,    ///< `text` is the value that was asked for
    unknown,  ///< `text` is the answer
  };
  Kind kind = Kind::unknown;
  std::string text;  ///< printable, at most 200 bytes
};

/// Reads an answer, without its zero byte, to a question for the parameter `asked` ("status active") or to a
/// command, where `asked` is empty.
DtrackAnswer readDtrackAnswer(std::string_view answer, std::string_view asked = {});

}  // namespace carom
