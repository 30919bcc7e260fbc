#include "app/link/link_key.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

namespace carom {
namespace {

const std::string kLetters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";

/// Why the letters are refused; empty if they are not.
std::string refusal(const std::string& letters) {
  try {
    LinkKey::of(letters);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "link-key-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string refusalOf(const std::filesystem::path& file) {
  try {
    LinkKey::read(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(LinkKey, ReadsWhatItWrites) {
  const LinkKey key = LinkKey::random();
  EXPECT_EQ(key.letters().size(), 28U + 6U);
  EXPECT_EQ(LinkKey::of(key.letters()).letters(), key.letters());
  std::string spoken = key.letters();
  for (char& letter : spoken) letter = letter == '-' ? ' ' : static_cast<char>(std::tolower(letter));
  EXPECT_EQ(LinkKey::of(spoken).secret(), key.secret());
  EXPECT_NE(LinkKey::random().letters(), key.letters());
  EXPECT_NE(LinkKey::random().secret(), key.secret());
  EXPECT_EQ(key.fingerprint().size(), 8U);
}

TEST(LinkKey, HasAllLetters) {
  std::set<char> letters;
  for (int i = 0; i < 100; ++i)
    for (const char letter : LinkKey::random().letters()) letters.insert(letter);
  EXPECT_EQ(letters.size(), 33U);  // and the hyphen
}

TEST(LinkKey, NoticesEveryWrongLetterAndEveryTwoThatChangedPlaces) {
  std::string letters;
  for (const char letter : LinkKey::random().letters())
    if (letter != '-') letters += letter;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    for (const char wrong : kLetters) {
      std::string other = letters;
      other[i] = wrong;
      EXPECT_EQ(refusal(other).empty(), other == letters) << letters << " " << other;
    }
    for (std::size_t k = i + 1; k < 26; ++k) {
      std::string other = letters;
      std::swap(other[i], other[k]);
      EXPECT_EQ(refusal(other).empty(), other == letters) << letters << " " << other;
    }
  }
}

TEST(LinkKey, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("ABC"), "it has 3 letters, expected 28");
  EXPECT_EQ(refusal("AB!C"), "it has a sign that no key has, expected letters and digits");
  std::string letters = LinkKey::random().letters();
  letters[0] = letters[0] == 'A' ? 'B' : 'A';
  EXPECT_EQ(refusal(letters), "its check letters do not match: a letter is mistyped");
}

// By another program: python3's hmac with the two steps of RFC 5869.
TEST(LinkKey, SecretIsThatOfRfc5869) {
  const LinkKey key = LinkKey::of("0000-0000-0000-0000-0000-0000-0000");
  const auto secret = key.secret();
  EXPECT_EQ(secret[0], 0x5b);
  EXPECT_EQ(secret[31], 0x8f);
  EXPECT_EQ(key.fingerprint(), "575b8348");
}

TEST(LinkKey, FileIsForItsOwnerAlone) {
  const Folder folder;
  const auto file = folder / "room.key";
  EXPECT_NE(refusalOf(file).find("No such file"), std::string::npos);
  const LinkKey key = LinkKey::random();
  key.write(file);
  struct stat status {};
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  EXPECT_EQ(LinkKey::read(file).letters(), key.letters());
  EXPECT_THROW(key.write(file), std::runtime_error) << "it is there already";
  for (const mode_t mode : {0640U, 0604U, 0660U}) {
    chmod(file.c_str(), mode);
    EXPECT_NE(refusalOf(file).find("others may read it"), std::string::npos) << mode;
  }
  chmod(file.c_str(), 0600);
  std::ofstream(file, std::ios::trunc) << key.letters().substr(0, 20) << "\n";
  EXPECT_NE(refusalOf(file).find("letters, expected 28"), std::string::npos);
  EXPECT_NE(refusalOf(file.parent_path()).find("it is no file"), std::string::npos);
}

}  // namespace
}  // namespace carom
