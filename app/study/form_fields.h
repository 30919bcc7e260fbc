#pragma once
// What a browser sends of a form (application/x-www-form-urlencoded). It comes from outside: it is bounded,
// and has no
// control characters afterwards but those of its lines.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace carom {

inline constexpr std::size_t kMostFormBytes = 8192, kMostFormFields = 64;

/// The fields of a form by their names. A missing field is empty.
class FormFields {
 public:
  /// Reads a form. Further fields than kMostFormFields, and a form of more than kMostFormBytes, count for
  /// nothing.
  explicit FormFields(std::string_view form);

  const std::string& operator[](std::string_view name) const;
  bool has(std::string_view name) const { return fields_.contains(name); }
  /// Returns a whole number from 0 to `most`, or `otherwise`.
  int number(std::string_view name, int most, int otherwise) const;

 private:
  std::map<std::string, std::string, std::less<>> fields_;
};

}  // namespace carom
