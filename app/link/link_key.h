#pragma once
// The key that two linked rooms share: 130 random bits, written as 26 letters and two that check them.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace carom {

class LinkKey {
 public:
  /// Returns a new key of random bits. Throws std::runtime_error if the operating system gives none.
  static LinkKey random();

  /// Returns the key of these letters, in groups or not, of either case. Throws std::runtime_error with what
  /// is wrong with them: their number, a sign that is none, or check letters that do not match.
  static LinkKey of(std::string_view letters);

  /// Reads the key of a file. Throws std::runtime_error with the file's name if it is missing, if others than
  /// its owner may read it, or as `of` does.
  static LinkKey read(const std::filesystem::path& file);

  /// Writes the key to a new file that its owner alone may read. Throws std::runtime_error if the file is
  /// there already or cannot be written.
  void write(const std::filesystem::path& file) const;

  /// Returns the letters with the check letters, in groups of four.
  std::string letters() const;

  /// Returns the first eight hexadecimal digits of the SHA-256 of the 26 letters: names the key in logs, and
  /// does not tell it.
  std::string fingerprint() const;

  /// Returns the secret for TLS, HKDF-SHA256 (RFC 5869) of the 26 letters with the words "carom link 1".
  std::array<std::uint8_t, 32> secret() const;

 private:
  explicit LinkKey(std::string letters) : letters_(std::move(letters)) {}

  std::string letters_;  ///< 26 of Crockford's base 32
};

}  // namespace carom
