#include "app/link/link_stream.h"

#include <gtest/gtest.h>

#include "app/link/sample_messages.h"

namespace carom {
namespace {

std::vector<std::uint8_t> allBytes() {
  std::vector<std::uint8_t> bytes;
  for (const LinkMessage& message : test::sampleMessages()) append(message, bytes);
  return bytes;
}

TEST(LinkStream, FindsMessagesHoweverTheyAreCut) {
  const std::vector<std::uint8_t> bytes = allBytes();
  for (std::size_t piece = 1; piece <= bytes.size(); piece += 1 + piece / 3) {
    LinkStream stream;
    std::vector<std::uint8_t> back;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      stream.add(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)), 0.0);
      while (const auto message = stream.next()) append(*message, back);
    }
    EXPECT_EQ(back, bytes) << piece;
  }
}

TEST(LinkStream, ARoomThatPlaysIsNeverTooMuch) {
  LinkStream stream;
  std::vector<std::uint8_t> present;
  append(test::samplePresent(), present);
  for (int frame = 0; frame < 36000; ++frame) {
    stream.add(present, frame / 60.0);
    EXPECT_TRUE(stream.next());
  }
}

TEST(LinkStream, AFloodEndsTheLine) {
  const auto floods = [](const LinkMessage& message, double rate_1_s, double for_s) {
    LinkStream stream;
    std::vector<std::uint8_t> bytes;
    append(message, bytes);
    try {
      for (int i = 0; i < rate_1_s * for_s; ++i) {
        stream.add(bytes, i / rate_1_s);
        while (stream.next()) {
        }
      }
    } catch (const BrokenLink&) {
      return true;
    }
    return false;
  };
  EXPECT_TRUE(floods(LinkPing{}, 400.0, 2.0));
  EXPECT_FALSE(floods(LinkPing{}, 119.0, 60.0));
  LinkWelcome large = std::get<LinkWelcome>(test::sampleMessages()[3]);
  large.scenario.assign(60000, ' ');
  EXPECT_TRUE(floods(large, 20.0, 2.0));
  EXPECT_FALSE(floods(large, 4.0, 20.0));
}

TEST(LinkStream, OneWelcomeMayBeLarge) {
  LinkWelcome welcome = std::get<LinkWelcome>(test::sampleMessages()[3]);
  welcome.strokes.assign(15000, test::sampleStroke(0));
  std::vector<std::uint8_t> bytes;
  append(welcome, bytes);
  LinkStream stream;
  stream.add(bytes, 0.0);
  EXPECT_TRUE(stream.next());
  stream.add(bytes, 0.1);
  EXPECT_THROW(stream.next(), BrokenLink);
}

}  // namespace
}  // namespace carom
