#pragma once
// What the objects of a HEVS configuration inherit from others, by their member "inherit".

#include <cstddef>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

class HevsInheritance {
 public:
  /// `all`: the objects that can be inherited from, by their names.
  HevsInheritance(const Part& all, Room& room) : all_(all), room_(room) {}

  /// Returns an object with what it inherits, member by member; later ones win. Adds an error where it
  /// inherits from nothing, from itself or from too many.
  Part of(const Part& object);

 private:
  void add(const Part& object, Part& whole, std::size_t depth);
  void inheritFrom(const Part& name, Part& whole, std::size_t depth);

  const Part& all_;
  Room& room_;
  std::size_t copied_ = 0;
  bool isRefused_ = false;
};

}  // namespace carom
