#pragma once
// The questions of a study's tests: templates in three forms that ask the same of other scenes.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/toml/findings.h"

namespace carom {

/// The answer that every item has besides its own.
inline constexpr const char* kDontKnow = "dont-know";

/// The forms of a test, one after the other before the lessons, after them, and later.
inline constexpr std::array<const char*, 3> kForms{"A", "B", "C"};

struct ItemAnswer {
  std::string id, text;
  bool isRight = false;
  std::string misconception;  ///< may be empty
};

struct Item {
  std::string id;  ///< of the template: the same in each form
  std::string concept_;
  std::size_t form = 0;  ///< index of kForms
  std::string question;
  std::vector<ItemAnswer> answers;

  /// Returns the answer of this id, or null.
  const ItemAnswer* answer(std::string_view answerId) const;
};

struct ItemBank {
  std::string title;
  std::vector<Item> items;
  std::vector<Finding> odd;  ///< oddities that are no errors

  /// Returns the items of a form in the order of the file.
  std::vector<const Item*> ofForm(std::size_t form) const;
  /// Returns the item of a template in a form, or null.
  const Item* find(std::string_view id, std::size_t form) const;
  /// Returns the concepts in the order of the file.
  std::vector<std::string> concepts() const;
};

/// Reads and checks a bank: the file or, if given, `kept`, its content when a session began. Throws
/// InputErrors with the place of every fault: an item without a key or with two, an id that stands twice, a
/// form without an item of a concept.
ItemBank readItemBank(const std::filesystem::path& file, const std::optional<std::string>& kept = {});

}  // namespace carom
