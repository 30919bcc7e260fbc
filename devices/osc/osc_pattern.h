#pragma once
// An address of Open Sound Control with places for numbers, such as /wand/{sensor}/button/{n}.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

class OscPattern {
 public:
  /// The numbers that an address has in the places of {sensor} and {n}; 0 where the pattern has no such
  /// place.
  struct Numbers {
    std::int32_t sensor = 0;
    std::int32_t index = 0;
  };

  /// Reads a pattern. Each place may be there once, and {n} only where `hasIndex`. Throws
  /// std::invalid_argument, which says the fault and the expectation.
  OscPattern(std::string_view text, bool hasIndex);

  /// Returns the numbers of an address that fits; none if it does not. A number has 1 to 5 digits.
  std::optional<Numbers> match(std::string_view address) const;
  const std::string& text() const { return text_; }

 private:
  enum class Place { none, sensor, index };
  /// A text, and the place behind it.
  struct Piece {
    std::string text;
    Place place = Place::none;
  };
  void add(std::string_view name, std::string&& before, bool hasIndex);

  std::string text_;
  std::vector<Piece> pieces_;
};

}  // namespace carom
