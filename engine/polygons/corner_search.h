#pragma once
// The two searches behind corner_contact.h.

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/polygons/persistent_contact.h"

namespace carom {

/// From when on a contact counts: dot(frame, C − origin) >= from, above it if `strictly`.
struct ContactWindow {
  Vec21 frame, origin;
  double from = 0.0;
  bool strictly = false;  ///< both flights begin at board time 0, when nothing is in contact
  bool resumed = false;   ///< what touches already at `from` has been dealt with
  bool onlyNew = false;   ///< and what goes deeper after that

  double timeOf(const Vec21& event) const { return dot(frame, event - origin); }
  bool holds(double time) const { return strictly ? time > from : time >= from; }
};

/// A contact as the searches find it.
struct FoundContact {
  double time = 0.0;  ///< U · (C − X1)
  Vec21 event;
  Vec21 normal;  ///< from the first body to the second, to within a multiple of U
  bool withoutDelay = false;
  bool sideOnSide = false;
  bool unfinished = false;  ///< no contact: CornerContact's
};

/// Returns the window that begins at an earlier contact: when both bodies were there.
inline ContactWindow windowAt(const PersistentContact& earlier) {
  ContactWindow window;
  window.frame = equalSpeedFrame(earlier.flights[0].u, earlier.flights[1].u);
  window.origin = earlier.flights[0].start;
  window.from = dot(window.frame, earlier.event - window.origin);
  return window;
}

/// The angle between sides that look the same way.
constexpr double kSameNormal = 1e-6;
/// Slower than this, bodies that overlap do not approach.
constexpr double kLeastClosing = 1e-9;
/// Of the radii: what touches for less grazes.
constexpr double kLeastStep = 1e-6;
/// Likewise: piercings as near to each other in time are one.
constexpr double kSimultaneous = 1e-9;
/// Likewise of what slides in another, or stays near it for long.
constexpr double kSlideStep = 1e-3;
/// A search ends after this number of steps, to be continued from there.
constexpr int kMostSteps = 4096;

/// The steps of a search, of a length in which a body outside cannot come nearer than it is, or the least
/// one. This grows where it is taken again and again.
class AdvancingSteps {
 public:
  AdvancingSteps(double size, double fastest)
      : fastest_(fastest), fine_(kLeastStep * size / fastest), coarse_(kSlideStep * size / fastest) {}

  double next(double outside) {
    const double sure = outside / fastest_;
    if (!(outside > 0.0)) return coarse_;
    if (sure > coarse_) least_ = fine_;
    if (sure >= least_) return sure;
    least_ = std::min(coarse_, 1.01 * least_);
    return least_;
  }

 private:
  double fastest_, fine_, coarse_;
  double least_ = fine_;
};
/// Relative to the radii: nearer places touch, after rounding.
constexpr double kCornerTouches = 1e-11;

/// Of two bodies with corners.
std::optional<FoundContact> findPiercing(const MovingShape& first, const MovingShape& second, const Vec21& U,
                                         const ContactWindow& window, const PersistentContact* earlier);
/// Moves a piercing at which sides come to lie on each other to the middle of what touches at this time, and
/// marks it.
void settleSimultaneous(const MovingShape& first, const MovingShape& second, const Vec21& U,
                        FoundContact& best);
/// Of a disc and a body with corners, in either order.
std::optional<FoundContact> findRimContact(const MovingShape& first, const MovingShape& second,
                                           const Vec21& U, const ContactWindow& window,
                                           const PersistentContact* earlier);
/// Where the corners of each body are to the other, or the centre of a disc, at the time `window.from`.
PenetrationState penetrationOfCorners(const MovingShape& first, const MovingShape& second, const Vec21& U,
                                      const ContactWindow& window, const PersistentContact& earlier);
/// Returns from when on bodies with corners that have not parted since an earlier contact will have done so
/// on these flights, found in steps that grow, until about a time; infinity if they do not, or had done so
/// already.
double partingOfCorners(const MovingShape& first, const MovingShape& second, const Vec21& U,
                        const ContactWindow& window, const PersistentContact& earlier, double until);
/// How two convex bodies go through each other from a contact on.
struct Passage {
  bool overlapping = true;
  bool elsewhere = false;   ///< they last came out of each other on another side than that of the contact
  double leastAlong = 1.0;  ///< the least cosine between such a side's normal and that of the contact

  /// Whether they have come out on the side of the contact. Then it is over: what touches next is another
  /// one.
  bool isOver() const { return !overlapping && !elsewhere; }
};
/// Follows two convex bodies up to a time of `windowAt(earlier)`.
void followPassage(const MovingShape& first, const MovingShape& second, const PersistentContact& earlier,
                   double until, Passage& passage);
PenetrationState penetrationOfDisc(const MovingShape& first, const MovingShape& second, const Vec21& U,
                                   const ContactWindow& window, const PersistentContact& earlier);

/// Adds all places at which two bodies touch, nearer than `within`, or overlap at the time `window.from`.
void addPiercedPlaces(const MovingShape& first, const MovingShape& second, const Vec21& U,
                      const ContactWindow& window, double within, const PersistentContact* earlier,
                      std::vector<FoundContact>& places);
void addRimPlaces(const MovingShape& first, const MovingShape& second, const Vec21& U,
                  const ContactWindow& window, double within, const PersistentContact* earlier,
                  std::vector<FoundContact>& places);

}  // namespace carom
