#include "app/cave_formats/hevs_inheritance.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/room_checks/foreign_room.h"

namespace carom {
namespace {

constexpr std::size_t kMostInherited = 32, kMostParts = 200'000;  // objects in a chain; copied parts

std::size_t sizeOf(const Part& part) {
  std::size_t size = 1;
  for (const Part& child : part.parts) size += sizeOf(child);
  return size;
}

/// Overwrites parts by those of the same name, as HEVS does with what a platform or display inherits.
void overwrite(Part& whole, const Part& by) {
  for (const Part& part : by.parts) {
    const auto found = std::find_if(whole.parts.begin(), whole.parts.end(), [&](const Part& own) {
      return !part.name.empty() && own.name == part.name;
    });
    if (found == whole.parts.end()) {
      whole.parts.push_back(part);
    } else if (part.parts.empty() || found->parts.empty() || part.parts.front().name.empty()) {
      *found = part;
    } else {
      overwrite(*found, part);
    }
  }
}

}  // namespace

Part HevsInheritance::of(const Part& object) {
  Part whole{object.name, {}, object.at, object.textAt};
  add(object, whole, 0);
  return whole;
}

void HevsInheritance::add(const Part& object, Part& whole, std::size_t depth) {
  copied_ += sizeOf(object);
  if (depth > kMostInherited || copied_ > kMostParts) {
    if (!isRefused_) {
      addError(room_, object.at,
               fmt::format("'{}' inherits from itself or from too many others, expected none or a few",
                           printable(object.name)));
    }
    isRefused_ = true;
    return;
  }
  if (const Part* inherit = object.find("inherit")) {
    if (inherit->parts.empty()) inheritFrom(*inherit, whole, depth);
    for (const Part& name : inherit->parts) inheritFrom(name, whole, depth);
  }
  if (!isRefused_) overwrite(whole, object);
}

void HevsInheritance::inheritFrom(const Part& name, Part& whole, std::size_t depth) {
  name.isRead = true;
  if (const Part* other = all_.find(name.text)) {
    add(*other, whole, depth + 1);
  } else {
    addError(room_, name.textAt, fmt::format("there is no '{}' to inherit from", printable(name.text)));
  }
}

}  // namespace carom
