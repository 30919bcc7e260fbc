#include "cave/capture/movie.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "app/temporary_folder.h"
#include "cave/display/window.h"
#include "cave/screen/curved_screen.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// What a command writes on its standard output.
std::string outputOf(const std::string& command) {
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 65536> bytes{};
  for (std::size_t got = 0; (got = fread(bytes.data(), 1, bytes.size(), pipe)) > 0;)
    output.append(bytes.data(), got);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return output;
}

/// Frame `frame`, decoded: RGB, rows from the top down.
std::string decoded(const fs::path& movie, int frame) {
  return outputOf("ffmpeg -loglevel error -i '" + movie.string() + "' -vf 'select=eq(n\\," +
                  std::to_string(frame) + ")' -frames:v 1 -f rawvideo -pix_fmt rgb24 -");
}

Wall wallOf(const std::string& name, glm::ivec2 pixels, StereoMode stereo, WindowPlacement window = {}) {
  Wall wall;
  wall.name = name;
  wall.pixels = pixels;
  wall.stereo = stereo;
  wall.window = window;
  return wall;
}

/// A smooth picture that differs from frame to frame.
std::uint8_t shade(int x, int y, int channel, int frame, int wall) {
  const double value = 0.5 + 0.45 * std::sin(0.08 * x + 0.05 * (channel + 1) * y + 0.7 * frame + 2.0 * wall);
  return static_cast<std::uint8_t>(std::lround(255.0 * value));
}

void paint(RenderTarget& picture, int frame, int wall) {
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < picture.size_px().y; ++y) {
    for (int x = 0; x < picture.size_px().x; ++x) {
      for (int channel = 0; channel < 3; ++channel) rgb.push_back(shade(x, y, channel, frame, wall));
    }
  }
  picture.fill(rgb);
}

/// Two walls, 40 × 30 and 50 × 24 pixels, side by side; `frames` of them at 30 Hz.
void film(const fs::path& file, int frames) {
  const std::vector<Wall> walls{wallOf("a", {40, 30}, StereoMode::mono),
                                wallOf("b", {50, 24}, StereoMode::mono)};
  RenderTarget a({40, 30}), b({50, 24});
  Movie movie(file, movieLayout(walls, false), 30.0, WhenFull::wait);
  for (int frame = 0; frame < frames; ++frame) {
    paint(a, frame, 0);
    paint(b, frame, 1);
    const std::array<const RenderTarget*, 2> pictures{&a, &b};
    movie.add(7.0 + frame / 30.0, pictures);
  }
  EXPECT_FALSE(fs::exists(file)) << "before it is whole";
  movie.finish();
}

TEST(Movie, NamesAreOfTheirNodes) {
  EXPECT_EQ(movieOfNode("out/cave.mp4", 0, 1), fs::path("out/cave.mp4"));
  EXPECT_EQ(movieOfNode("out/cave.mp4", 1, 4), fs::path("out/cave-node1.mp4"));
  EXPECT_EQ(movieOfNode("cave.webm", 0, 2), fs::path("cave-node0.webm"));
  for (const char* name : {"a.mp4", "b.webm", "c/d.ogv"}) EXPECT_TRUE(isMovieName(name)) << name;
  for (const char* name : {"a", "mp4", "a.avi", "a.mp4.txt", ""}) EXPECT_FALSE(isMovieName(name)) << name;
}

TEST(Movie, WallsStandInARowOrAsInTheWindow) {
  std::vector<Wall> walls{
      wallOf("left", {600, 601}, StereoMode::sideBySide, {0, {0, 0}, {600, 300}, false}),
      wallOf("front", {600, 600}, StereoMode::sideBySide, {0, {600, 0}, {600, 300}, false}),
      wallOf("floor", {600, 600}, StereoMode::sideBySide, {0, {600, 300}, {600, 300}, false})};
  const MovieLayout row = movieLayout(walls, false);
  EXPECT_EQ(row.size_px, glm::ivec2(1800, 602)) << "even";
  EXPECT_EQ(row.places[1].position_px, glm::ivec2(600, 0));
  EXPECT_EQ(row.places[0].size_px, glm::ivec2(600, 601));
  const MovieLayout window =
      movieLayout(walls, true);  // one eye each: half as wide, then at the pictures' pixels
  EXPECT_EQ(window.size_px, glm::ivec2(1200, 1200));
  EXPECT_EQ(window.places[0].position_px, glm::ivec2(0, 0));
  EXPECT_EQ(window.places[2].position_px, glm::ivec2(600, 600));
  for (const Viewport& place : window.places) EXPECT_EQ(place.size_px, glm::ivec2(600, 600));
  for (Wall& wall : walls) wall.pixels = {1920, 1920};
  const MovieLayout large = movieLayout(walls, false);
  EXPECT_EQ(large.size_px, glm::ivec2(3840, 1280)) << "what encoders and players take";
}

TEST(Movie, EveryFrameIsThereAndLooksAsItWasDrawn) {
  constexpr double kAlike_dB = 30.0;  // what a lossy movie of good quality reaches
  const test::TemporaryFolder folder;
  Graphics graphics;
  for (const char* name : {"walls.mp4", "walls.webm", "walls.ogv"}) {
    const fs::path file = folder / name;
    film(file, 12);
    EXPECT_EQ(folder.entries(), 1) << "nothing else is left behind";
    EXPECT_EQ(outputOf("ffprobe -loglevel error -count_frames -select_streams v:0 -show_entries "
                       "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 '" +
                       file.string() + "'"),
              "90,30,30/1,12\n")
        << name;
    const std::string pixels = decoded(file, 9);
    ASSERT_EQ(pixels.size(), 90U * 30U * 3U) << name;
    double squares = 0.0;
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 90; ++x) {
        const bool second = x >= 40;
        const int up = (second ? 24 : 30) - 1 - y;  // rows of a picture go up
        for (int channel = 0; channel < 3; ++channel) {
          const int drawn = up < 0 ? 0 : shade(second ? x - 40 : x, up, channel, 9, second);
          const auto seen = static_cast<std::uint8_t>(
              pixels[3 * static_cast<std::size_t>(90 * y + x) + static_cast<std::size_t>(channel)]);
          squares += (seen - drawn) * (seen - drawn);
        }
      }
    }
    const double psnr_dB = 10.0 * std::log10(255.0 * 255.0 * 8100.0 / squares);
    EXPECT_GT(psnr_dB, kAlike_dB) << name;
    fs::remove(file);
  }
}

/// What players are told of the projection of a movie of these walls, and how many frames it has.
std::string projectionOf(const fs::path& file, const std::vector<Wall>& walls) {
  std::vector<std::unique_ptr<RenderTarget>> targets;
  std::vector<const RenderTarget*> pictures;
  for (const Wall& wall : walls) {
    targets.push_back(std::make_unique<RenderTarget>(wall.pixels));
    pictures.push_back(targets.back().get());
  }
  Movie movie(file, movieLayout(walls, true), 30.0, WhenFull::wait);
  for (int frame = 0; frame < 3; ++frame) movie.add(frame / 30.0, pictures);
  movie.finish();
  return outputOf(
      "ffprobe -loglevel error -count_frames -select_streams v:0 -show_entries "
      "stream=nb_read_frames:stream_side_data=projection,type -of csv=p=0 '" +
      file.string() + "' | tr ',\\n' '  ' | tr -s ' '");
}

// As read by another program: the projection, and for two eyes where the second one's picture is.
TEST(Movie, AMovieOfAllDirectionsSaysSoToPlayers) {
  const test::TemporaryFolder folder;
  Graphics graphics;
  const auto screenOf = [](SkyKind kind) {
    auto screen = std::make_shared<CurvedScreen>();
    Sky sky;
    sky.kind = kind;
    screen->shape = sky;
    return screen;
  };
  Wall all = wallOf("sky", {128, 64}, StereoMode::mono, {0, {0, 0}, {128, 64}, false});
  all.screen = screenOf(SkyKind::equirectangular);
  Wall left = all, right = all;
  left.stereo = StereoMode::left;
  right.stereo = StereoMode::right;
  right.window.position_px = {0, 64};
  EXPECT_EQ(projectionOf(folder / "mono.mp4", {all}), "3 equirectangular ");
  EXPECT_EQ(projectionOf(folder / "both.mp4", {left, right}), "3 top and bottom equirectangular ");
  Wall fisheye = all;
  fisheye.screen = screenOf(SkyKind::fisheye);
  EXPECT_EQ(projectionOf(folder / "fisheye.mp4", {fisheye}), "3 ");
  EXPECT_EQ(projectionOf(folder / "all.webm", {all}), "3 ");
  std::ofstream(folder / "none.mp4") << "this is no movie";
  EXPECT_THROW(markSpherical(folder / "none.mp4", Spherical::mono), std::runtime_error);
}

TEST(Movie, AFrameThatStaysIsThereAsOften) {
  const test::TemporaryFolder folder;
  Graphics graphics;
  const fs::path file = folder / "stay.mp4";
  const std::vector<Wall> walls{wallOf("a", {32, 32}, StereoMode::mono)};
  RenderTarget picture({32, 32});
  Movie movie(file, movieLayout(walls, false), 60.0, WhenFull::wait);
  const std::array<const RenderTarget*, 1> pictures{&picture};
  // Ticks 0, 1, 4 (two were missed), then a jump back and one far ahead through a recording: 5, 6, 7.
  for (const double display_s : {1.0, 1.0 + 1.02 / 60, 1.0 + 4.0 / 60, 0.2, 40.0, 40.0 + 1.0 / 60})
    movie.add(display_s, pictures);
  movie.finish();
  EXPECT_EQ(outputOf("ffprobe -loglevel error -count_frames -select_streams v:0 -show_entries "
                     "stream=nb_read_frames -of csv=p=0 '" +
                     file.string() + "'"),
            "8\n");
}

TEST(Movie, WhatIsWrongIsSaidAndNothingIsLeftBehind) {
  const test::TemporaryFolder folder;
  Graphics graphics;
  const MovieLayout layout = movieLayout(std::vector<Wall>{wallOf("a", {32, 32}, StereoMode::mono)}, false);
  const auto failureOf = [&](const fs::path& file) -> std::string {
    try {
      Movie movie(file, layout, 60.0, WhenFull::wait);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(failureOf("/nowhere/at/all.mp4"), "movie /nowhere/at/all.mp4: No such file or directory");

  const fs::path place = (folder / "a.mp4").parent_path();
  EXPECT_EQ(failureOf(place), "movie " + place.string() + ": it is a folder, expected the name of a file");

  const std::string path = std::getenv("PATH");
  setenv("PATH", place.c_str(), 1);
  const std::string missing = failureOf(folder / "a.mp4");
  // One that ends at once, before it has read anything.
  std::ofstream(folder / "ffmpeg") << "#!/bin/sh\nexit 3\n";
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  RenderTarget picture({32, 32});
  const std::array<const RenderTarget*, 1> pictures{&picture};
  std::string ended;
  try {
    Movie movie(folder / "b.mp4", layout, 60.0, WhenFull::wait);
    for (int frame = 0; frame < 200; ++frame) movie.add(frame / 60.0, pictures);
    movie.finish();
  } catch (const std::runtime_error& error) {
    ended = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(missing.find("ffmpeg, which encodes it, is not installed"), std::string::npos) << missing;
  EXPECT_NE(ended.find("ffmpeg"), std::string::npos) << ended;
  { Movie unfinished(folder / "c.mp4", layout, 60.0, WhenFull::wait); }
  fs::remove(folder / "ffmpeg");
  EXPECT_TRUE(fs::is_empty(place));
}

TEST(Movie, WhereItCannotHaveItsNameItStaysUnderTheOther) {
  const test::TemporaryFolder folder;
  Graphics graphics;
  const fs::path file = folder / "taken.mp4";
  RenderTarget picture({32, 32});
  const std::array<const RenderTarget*, 1> pictures{&picture};
  std::string said;
  try {
    Movie movie(file, movieLayout(std::vector<Wall>{wallOf("a", {32, 32}, StereoMode::mono)}, false), 60.0,
                WhenFull::wait);
    for (int frame = 0; frame < 5; ++frame) movie.add(frame / 60.0, pictures);
    fs::create_directory(file);
    movie.finish();
  } catch (const std::runtime_error& error) {
    said = error.what();
  }
  EXPECT_EQ(said,
            "movie " + file.string() + ": Is a directory; the whole movie is " + file.string() + ".partial");
  EXPECT_EQ(outputOf("ffprobe -loglevel error -count_frames -select_streams v:0 -show_entries "
                     "stream=nb_read_frames -of csv=p=0 '" +
                     file.string() + ".partial'"),
            "5\n");
}

}  // namespace
}  // namespace carom
