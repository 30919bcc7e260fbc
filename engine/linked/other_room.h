#pragma once
// Another room of a linked game, as it is known here: what it has told, and where eyes here may be. Theory:
// app/doc/physics.md, Linked rooms.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/linked/promise.h"
#include "engine/linked/told.h"

namespace carom {

/// How something is judged that another room told.
enum class Judgement {
  taken,   ///< it is new, and keeps every promise
  old,     ///< it was known, or something later was
  broken,  ///< it breaks a promise: it changes nothing here, and nothing more should be heard from this room
};

class OtherRoom {
 public:
  /// Knows its first present, with all strokes before it. No eye may be in the future of its promises.
  OtherRoom(const Present& first, double lightSpeed_m_s);

  /// Takes a present. Its promises count once all its strokes are here.
  Judgement hear(const Present& present);
  /// Takes a stroke. One that is `taken` is to be played.
  Judgement hear(const StrokeTold& stroke);
  /// Returns the promise that was broken, in words for people, or nothing.
  const std::string& broken() const { return broken_; }

  /// Returns whether an eye may receive light at this event: none in the future of a promise may.
  bool allows(const Event& eye) const;

  /// The newest present all of whose strokes are here.
  const Present& present() const { return present_; }
  /// The newest present told; its strokes may still be on their way.
  const Present& newest() const { return newest_ ? *newest_ : present_; }
  /// The number of strokes that are here without a gap.
  std::uint32_t strokes() const { return withoutGap_; }
  /// Returns a stroke that is here, or null.
  const StrokeTold* stroke(std::uint32_t number) const;

 private:
  Judgement refuse(const char* why);
  bool keepsPromises(const Present& present) const;
  void useNewest();

  double c_m_s_;
  Present present_;
  std::optional<Present> newest_;  ///< waits for its strokes
  std::vector<std::optional<StrokeTold>> strokes_;
  std::uint32_t withoutGap_ = 0;
  std::string broken_;
};

}  // namespace carom
