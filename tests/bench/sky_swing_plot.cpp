// Draws what the head filter does for the eye, and prints it: sky_swing_plot FILE.png (or .svg).

#include <array>
#include <cstdio>
#include <exception>
#include <glm/trigonometric.hpp>

#include "aberration_error.h"
#include "app/report/chart_file.h"

namespace {

using namespace carom;
using test::SwingSample;

/// A figure from two seconds before the walk to one after it, in degrees.
ChartLine lineOf(const std::vector<SwingSample>& samples, const char* name, double SwingSample::*figure,
                 const glm::vec3& colour, float width_px) {
  ChartLine line{.name = name, .points = {}, .colour = colour, .width_px = width_px};
  for (const SwingSample& sample : samples) {
    if (sample.time_s < test::kWalkBegin_s - 3.0) continue;
    line.points.emplace_back(sample.time_s - test::kWalkBegin_s, glm::degrees(sample.*figure));
  }
  return line;
}

ChartLine speedLine(const std::vector<SwingSample>& samples) {
  ChartLine line{
      .name = "speed in c", .points = {}, .colour = {0.45F, 0.45F, 0.45F}, .style = ChartLine::Style::dashed};
  for (const SwingSample& sample : samples) {
    if (sample.time_s < test::kWalkBegin_s - 3.0) continue;
    line.points.emplace_back(sample.time_s - test::kWalkBegin_s, sample.beta);
  }
  return line;
}

/// RMS swings in degrees, mean of eight seeds.
void printTable() {
  constexpr int kSeeds = 8;
  struct Part {
    const char* name;
    bool (*counts)(const SwingSample&);
    double filtered_deg = 0.0, unfiltered_deg = 0.0;
  };
  std::array<Part, 3> parts{
      {{"standing", test::isStanding}, {"beyond 0.65 c", test::isFast}, {"the whole way", test::isOnTheWay}}};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::vector<SwingSample> samples = test::aberrationError(test::kWalkEnd_s, seed);
    for (Part& part : parts) {
      part.filtered_deg += test::rms_deg(samples, &SwingSample::filtered_rad, part.counts) / kSeeds;
      part.unfiltered_deg += test::rms_deg(samples, &SwingSample::unfiltered_rad, part.counts) / kSeeds;
    }
  }
  std::printf("%-14s %12s %24s\n", "", "head filter", "difference of positions");
  for (const Part& part : parts) {
    std::printf("%-14s %11.3f° %23.3f°\n", part.name, part.filtered_deg, part.unfiltered_deg);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("sky_swing_plot FILE.png: expected one file to write\n", stderr);
    return 2;
  }
  printTable();
  try {
    const std::vector<SwingSample> samples = test::aberrationError(test::kWalkEnd_s + 2.0, 1);
    writeChart(
        {.title = "A landmark at right angles: how far from its place it is seen",
         .xTitle = "seconds since setting off (tracker: 60 Hz, 0.3 mm; light: 1.42 m/s)",
         .yTitle = "degrees",
         .xRange = {-3.0, 6.0},
         .yRange = {0.0, 3.0},
         .lines = {lineOf(samples, "difference of positions", &SwingSample::unfiltered_rad,
                          {0.85F, 0.45F, 0.1F}, 1.5F),
                   speedLine(samples),
                   lineOf(samples, "head filter", &SwingSample::filtered_rad, {0.1F, 0.3F, 0.7F}, 2.5F)},
         .size_px = {1000, 400}},
        argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
