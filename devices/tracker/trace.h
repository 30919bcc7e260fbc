#pragma once
// Recorded tracker traces: CSV files of one sensor's poses.
//
//   # comments, only before the header
//   time_s,x_m,y_m,z_m,qx,qy,qz,qw
//   0.0,0.0,1.7,0.5,0,0,0,1
//
// Metres and seconds in the tracker's axes; time strictly increases; the four quaternion columns may be
// left out altogether. Quaternions are normalised when read.

#include <filesystem>
#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

#include "devices/tracker/tracker.h"

namespace carom {

/// Reads a trace file. Throws InputError at the first fault: a missing file, another header, a line with more
/// or fewer columns, text that is not one whole finite number, time that does not increase, a quaternion that
/// is no rotation, no samples at all, or a file beyond the bounds of trace.cpp.
std::vector<TrackerSample> readTrace(const std::filesystem::path& file);

/// Reads a trace from a stream; messages call it `name`.
std::vector<TrackerSample> readTrace(std::istream& in, const std::string& name);

/// Records a trace. Writes to a file beside it and moves that into place at `commit`, so that a trace appears
/// whole or not at all. Numbers are written as short as possible so that they read back to the same bits.
/// Throws std::runtime_error if the file cannot be written.
class TraceWriter {
 public:
  /// `hasOrientation` decides whether quaternion columns are written; `comments` come before the header,
  /// a `#` in front of each line.
  TraceWriter(std::filesystem::path file, bool hasOrientation, const std::string& comments = {});
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;
  ~TraceWriter();  // without commit: leaves nothing behind

  /// Times must increase; the sensor is not recorded.
  void add(const TrackerSample& sample);
  void commit();

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;
  std::ofstream out_;
  bool hasOrientation_;
};

}  // namespace carom
