// The lists of fields are whole: each byte of a frame's record that means something belongs to a field that
// they name.
#include "cave/record/record_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace carom {
namespace {

/// Marks the bytes of the fields that a list names.
class Named : public FieldVisitor {
 public:
  explicit Named(const FrameRecord& record) : first_(reinterpret_cast<const std::byte*>(&record)) {}

  template <typename Value, typename Kind>
  void operator()(std::string_view, Value& value, const Kind&) {
    const auto at = reinterpret_cast<const std::byte*>(&value) - first_;
    std::fill_n(isNamed_.begin() + at, sizeof(value), true);
  }

  const std::vector<bool>& isNamed() const { return isNamed_; }

 private:
  const std::byte* first_;
  std::vector<bool> isNamed_ = std::vector<bool>(sizeof(FrameRecord));
};

/// Returns how many bytes of a record are padding. GCC 12 counts them rightly and misplaces those of arrays.
std::ptrdiff_t paddingBytes() {
  alignas(FrameRecord) static std::array<unsigned char, sizeof(FrameRecord)> bytes;
  bytes.fill(0xFF);
  __builtin_clear_padding(reinterpret_cast<FrameRecord*>(bytes.data()));
  return std::count(bytes.begin(), bytes.end(), 0);
}

TEST(RecordFieldLists, NameEveryByteThatMeansSomething) {
  FrameRecord record;
  record.viewerCount = kMostViewers;
  Named named(record);
  visitAll(record, named);
  EXPECT_EQ(std::count(named.isNamed().begin(), named.isNamed().end(), false), paddingBytes())
      << "a field of FrameRecord is in no list of cave/record/record_fields.h";
}

}  // namespace
}  // namespace carom
