#pragma once
// The configuration of one computer in OpenCOVER's XML. A file has sections for all computers (GLOBAL), for a
// cluster by its master (CLUSTER) and for some computers (LOCAL); what a computer sees is all of the first,
// then of the second, then of the third kind that name it, merged by element and name: later ones win.

#include <string>
#include <vector>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

inline constexpr double kCoverUnit_m = 1e-3;  ///< lengths are in millimetres

/// One section of a file.
struct CoverSection {
  enum class Kind { global, cluster, local };
  Kind kind = Kind::global;
  std::vector<std::string> hosts;  ///< a LOCAL's computers, or the CLUSTER's master
  const Part* part = nullptr;
};

class CoverSections {
 public:
  CoverSections(const Part& root, Room& room);

  /// Returns the masters that CLUSTER sections name, in the order of the file.
  const std::vector<std::string>& masters() const { return masters_; }
  /// Returns the computers that LOCAL sections name, in the order of the file.
  const std::vector<std::string>& hosts() const { return hosts_; }
  FilePlace placeOfMaster(const std::string& master) const;
  /// Returns what a computer of a master's cluster sees of <COVER>. Adds an error if the file makes that too
  /// much work.
  Part configOf(const std::string& host, const std::string& master);

 private:
  void merge(Part& whole, const Part& section);

  Room& room_;
  std::vector<CoverSection> sections_;
  std::vector<std::string> masters_, hosts_;
  std::size_t work_ = 0;
  bool isRefused_ = false;
};

}  // namespace carom
