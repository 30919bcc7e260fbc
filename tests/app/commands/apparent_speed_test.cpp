// How fast pucks seem to come and go, read from the pictures that a session captures: v/(1 − β) and v/(1 +
// β).
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "app/program.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::exact;
using test::runCarom;
using test::TemporaryFolder;

constexpr double kC_m_s = 1.42, kFrame_s = 1.0 / 60.0;
constexpr double kPuck_m = 0.004;   // radius and height
constexpr double kAbove_m = 0.15;   // the eye above the line of the pucks' centres
constexpr double kFloor_m = -0.75;  // of the room, from the cloth: the default

// The eye is at x = y = 0, over the pucks' line, which is the y axis. Two walls, a metre before it and behind
// it, show what is from kNear_m to kFar_m away on the line.
constexpr double kNear_m = 2.2, kFar_m = 8.0;
constexpr double kTop_m = kAbove_m / kFar_m, kBottom_m = kAbove_m / kNear_m;  // below the eye, on a wall
constexpr int kRows = 1600, kColumns = 240;

double eyeInRoom_m() { return kPuck_m / 2 + kAbove_m - kFloor_m; }

std::string wallText(const char* name, double side) {
  const double pixel_m = (kBottom_m - kTop_m) / kRows, half_m = side * 0.5 * kColumns * pixel_m;
  const double bottom_m = eyeInRoom_m() - kBottom_m, top_m = eyeInRoom_m() - kTop_m;
  std::ostringstream text;
  text.precision(17);
  text << "[[wall]]\nname = \"" << name << "\"\nlower_left = [" << -half_m << ", " << bottom_m << ", "
       << -side << "]\nlower_right = [" << half_m << ", " << bottom_m << ", " << -side << "]\nupper_left = ["
       << -half_m << ", " << top_m << ", " << -side << "]\npixels = [" << kColumns << ", " << kRows
       << "]\nwindow = { position = [0, 0], size = [100, 200] }\nstereo = \"mono\"\n";
  return text.str();
}

std::string rigText() {
  return "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"still\"\neye_separation = 0.0\n"
         "[[tracker]]\nname = \"still\"\nkind = \"recorded\"\nsource = \"still.csv\"\n" +
         wallText("front", 1.0) + wallText("back", -1.0);
}

std::string traceText() {
  const std::string eye = ",0," + exact(eyeInRoom_m()) + ",0\n";
  std::string text = "time_s,x_m,y_m,z_m\n";
  for (int i = 0; i < 1000; ++i) text += exact(0.01 * i) + eye;
  return text;
}

/// A puck on the y axis that is seen at `seen_m` in the first frame, moving towards −y.
std::string puckText(const char* name, double seen_m, double beta) {
  const double light_s = std::hypot(seen_m, kAbove_m) / kC_m_s;
  const double start_m = seen_m - beta * kC_m_s * light_s;
  return std::string("[[puck]]\nname = \"") + name + "\"\nradius_m = " + exact(kPuck_m) +
         "\nheight_m = " + exact(kPuck_m) + "\nmass_kg = 0.2\nposition_m = [0.0, " + exact(start_m) +
         "]\nbeta = [0.0, " + exact(-beta) + "]\n";
}

using Image = std::vector<double>;  // brightness, row after row from the top

Image brightnessOf(const std::filesystem::path& file) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData& data = *reader->GetOutput();
  const int channels = data.GetNumberOfScalarComponents();
  EXPECT_EQ(data.GetDimensions()[0], kColumns) << file;
  EXPECT_EQ(data.GetDimensions()[1], kRows) << file;
  const auto* pixel = static_cast<const unsigned char*>(data.GetScalarPointer());
  Image image(std::size_t{kColumns} * kRows);
  for (int row = kRows - 1; row >= 0; --row) {  // VTK's rows begin at the bottom
    for (int column = 0; column < kColumns; ++column, pixel += channels) {
      image[static_cast<std::size_t>(row) * kColumns + column] = pixel[0] + pixel[1] + pixel[2];
    }
  }
  return image;
}

/// What the pictures show where nothing moves.
Image backgroundOf(const std::vector<Image>& pictures) {
  Image background(pictures.front().size());
  std::vector<double> values(pictures.size());
  for (std::size_t i = 0; i < background.size(); ++i) {
    for (std::size_t k = 0; k < pictures.size(); ++k) values[k] = pictures[k][i];
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
    background[i] = values[values.size() / 2];
  }
  return background;
}

/// Of the brighter pixels, the mean row; the puck is brighter than what it glides on, its shadow is not.
double rowOfPuck(const Image& picture, const Image& background) {
  constexpr double kBrighter = 60.0;  // of 765
  double least = kRows, most = -1.0;
  double sum = 0.0, weight = 0.0;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * kColumns + column;
      if (!(picture[i] - background[i] > kBrighter)) continue;
      sum += row + 0.5, weight += 1.0;
      least = std::min<double>(least, row), most = std::max<double>(most, row);
    }
  }
  EXPECT_GT(weight, 100.0) << "a puck's pixels";
  EXPECT_GT(least, 0) << "all of it on the wall";
  EXPECT_LT(most, kRows - 1) << "all of it on the wall";
  return sum / weight;
}

/// How far away on the pucks' line a row of a wall is.
double distanceOf_m(double row) { return kAbove_m / (kTop_m + (kBottom_m - kTop_m) * row / kRows); }

/// The slope of the line through points, by least squares.
double slopeOf(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// The mean speed at which what a wall shows moves away, from every `step`th of the captured pictures.
double apparentSpeed_m_s(const std::filesystem::path& folder, const char* wall, int frames, int step) {
  std::vector<Image> pictures;
  std::vector<double> times_s, distances_m;
  for (int frame = 0; frame < frames; frame += step) {
    char name[64];
    std::snprintf(name, sizeof name, "%s-mono-%06d.png", wall, frame);
    pictures.push_back(brightnessOf(folder / name));
    times_s.push_back(frame * kFrame_s);  // of an eye at rest, from the first frame on
  }
  const Image background = backgroundOf(pictures);
  for (const Image& picture : pictures) distances_m.push_back(distanceOf_m(rowOfPuck(picture, background)));
  return slopeOf(times_s, distances_m);
}

TEST(ApparentSpeed, OfPucksThatComeAndGoAsCapturedPicturesShowThem) {
  const TemporaryFolder folder;
  folder.file("still.csv", traceText());
  folder.file("room.toml", rigText());
  for (const double beta : {0.5, 0.8}) {
    SCOPED_TRACE(testing::Message() << beta << " c");
    const double coming_m_s = beta * kC_m_s / (1.0 - beta), going_m_s = beta * kC_m_s / (1.0 + beta);
    // From 6 m to 3.5 m away, and from 3.5 m on.
    const int frames = static_cast<int>(2.5 / coming_m_s / kFrame_s);
    folder.file("line.toml", "light_speed_m_s = 1.42\n[observer]\nposition_m = [0.0, 0.0, " +
                                 exact(kFloor_m) + "]\n" + puckText("white", 6.0, beta) +
                                 puckText("yellow", -3.5, beta));
    const auto played = runCarom(
        folder, {"cave", "--rig", folder / "room.toml", "--scenario", folder / "line.toml", "--frames",
                 std::to_string(frames), "--capture", folder / "pictures", "--no-window"});
    ASSERT_EQ(played.status, 0) << played.err;
    const int step = std::max(frames / 12, 1);
    const double came_m_s = -apparentSpeed_m_s(folder / "pictures", "front", frames, step);
    const double went_m_s = apparentSpeed_m_s(folder / "pictures", "back", frames, step);
    EXPECT_NEAR(came_m_s / coming_m_s, 1.0, 0.01);
    EXPECT_NEAR(went_m_s / going_m_s, 1.0, 0.01);
    std::printf(
        "%.1f c: comes at %.4f m/s, v/(1 - beta) = %.4f; goes at %.4f m/s, v/(1 + beta) = %.4f; light %.2f\n",
        beta, came_m_s, coming_m_s, went_m_s, going_m_s, kC_m_s);
    std::filesystem::remove_all(folder / "pictures");
  }
}

}  // namespace
}  // namespace carom
