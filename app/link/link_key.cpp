#include "app/link/link_key.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <openssl/kdf.h>
#include <openssl/sha.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace carom {
namespace {

constexpr std::string_view kLetters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";  // Crockford's base 32
constexpr std::size_t kSize = 26, kChecks = 2, kGroup = 4;
constexpr std::string_view kWords = "carom link 1";

/// Returns the value of a letter, 0 to 31; −1 if it is none. O is read as 0, I and L as 1.
int valueOf(char letter) {
  char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  if (upper == 'O') upper = '0';
  if (upper == 'I' || upper == 'L') upper = '1';
  const std::size_t value = kLetters.find(upper);
  return value == std::string_view::npos ? -1 : static_cast<int>(value);
}

/// Returns the check letters: Σ vᵢ·7ⁱ⁺¹ modulo the prime 1021. One wrong letter changes the sum by a multiple
/// of 7ⁱ⁺¹ that is smaller than 1021, and two letters that changed places by (v − w)(7ⁱ − 7ʲ), where 7 has an
/// order above 26: neither is divisible by 1021, so both are always noticed.
std::string checksOf(std::string_view letters) {
  constexpr int kPrime = 1021, kBase = 7;
  int sum = 0, power = 1;
  for (const char letter : letters) {
    power = power * kBase % kPrime;
    sum = (sum + valueOf(letter) * power) % kPrime;
  }
  return {kLetters[static_cast<std::size_t>(sum / 32)], kLetters[static_cast<std::size_t>(sum % 32)]};
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error(fmt::format("key file {}: {}", file.string(), why));
}

/// A file that is closed in the end.
class OpenFile {
 public:
  explicit OpenFile(int number) : number_(number) {}
  ~OpenFile() {
    if (number_ >= 0) close(number_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int operator*() const { return number_; }

 private:
  int number_;
};

}  // namespace

LinkKey LinkKey::random() {
  std::array<unsigned char, kSize> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the operating system gave no random numbers");
  std::string letters;
  for (const unsigned char byte : bytes) letters += kLetters[byte % kLetters.size()];
  return LinkKey(letters);
}

LinkKey LinkKey::of(std::string_view text) {
  std::string letters;
  for (const char letter : text) {
    if (letter == '-' || std::isspace(static_cast<unsigned char>(letter)) != 0) continue;
    const int value = valueOf(letter);
    if (value < 0) throw std::runtime_error("it has a sign that no key has, expected letters and digits");
    letters += kLetters[static_cast<std::size_t>(value)];
  }
  if (letters.size() != kSize + kChecks)
    throw std::runtime_error(fmt::format("it has {} letters, expected {}", letters.size(), kSize + kChecks));
  if (checksOf(letters.substr(0, kSize)) != letters.substr(kSize))
    throw std::runtime_error("its check letters do not match: a letter is mistyped");
  return LinkKey(letters.substr(0, kSize));
}

LinkKey LinkKey::read(const std::filesystem::path& file) {
  constexpr std::size_t kMost = 4096;
  const OpenFile opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (*opened < 0)
    refuse(file, fmt::format("{}, expected what carom link --new-key wrote", std::strerror(errno)));
  struct stat status {};
  if (fstat(*opened, &status) != 0 || !S_ISREG(status.st_mode)) refuse(file, "it is no file");
  if ((status.st_mode & 077U) != 0)
    refuse(file, fmt::format("others may read it (mode {:04o}), expected 0600: chmod 600 {}",
                             status.st_mode & 0777U, file.string()));
  std::string text(kMost, '\0');
  const ssize_t size = ::read(*opened, text.data(), text.size());
  if (size < 0) refuse(file, std::strerror(errno));
  text.resize(static_cast<std::size_t>(size));
  try {
    return of(text);
  } catch (const std::runtime_error& error) {
    refuse(file, error.what());
  }
}

void LinkKey::write(const std::filesystem::path& file) const {
  const OpenFile opened(open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (*opened < 0)
    refuse(file, errno == EEXIST ? "it is there already, expected a new name" : std::strerror(errno));
  const std::string text = letters() + "\n";
  if (::write(*opened, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    refuse(file, std::strerror(errno));
}

std::string LinkKey::letters() const {
  const std::string all = letters_ + checksOf(letters_);
  std::string groups;
  for (std::size_t i = 0; i < all.size(); i += kGroup) groups += (i > 0 ? "-" : "") + all.substr(i, kGroup);
  return groups;
}

std::string LinkKey::fingerprint() const {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(letters_.data()), letters_.size(), digest.data());
  return fmt::format("{:02x}{:02x}{:02x}{:02x}", digest[0], digest[1], digest[2], digest[3]);
}

std::array<std::uint8_t, 32> LinkKey::secret() const {
  std::array<std::uint8_t, 32> secret{};
  std::size_t size = secret.size();
  const std::unique_ptr<EVP_PKEY_CTX, decltype(&EVP_PKEY_CTX_free)> derivation(
      EVP_PKEY_CTX_new_id(EVP_PKEY_HKDF, nullptr), EVP_PKEY_CTX_free);
  const auto bytesOf = [](std::string_view text) {
    return reinterpret_cast<const unsigned char*>(text.data());
  };
  const bool isDone =
      derivation && EVP_PKEY_derive_init(derivation.get()) == 1 &&
      EVP_PKEY_CTX_set_hkdf_md(derivation.get(), EVP_sha256()) == 1 &&
      EVP_PKEY_CTX_set1_hkdf_key(derivation.get(), bytesOf(letters_), static_cast<int>(letters_.size())) ==
          1 &&
      EVP_PKEY_CTX_add1_hkdf_info(derivation.get(), bytesOf(kWords), static_cast<int>(kWords.size())) == 1 &&
      EVP_PKEY_derive(derivation.get(), secret.data(), &size) == 1 && size == secret.size();
  if (!isDone) throw std::runtime_error("OpenSSL could not derive the secret of the link's key");
  return secret;
}

}  // namespace carom
