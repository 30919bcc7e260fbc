#include "app/link/link_message.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <random>

#include "app/link/sample_messages.h"
#include "mutate.h"

namespace carom {
namespace {

using test::Bytes;
using test::samplePresent;
using test::sampleStroke;

Bytes bytesOf(const LinkMessage& message) {
  Bytes bytes;
  append(message, bytes);
  return bytes;
}

/// Why the bytes of a message are refused; empty if they are not.
std::string refusal(const Bytes& bytes) {
  try {
    linkMessageOf(bytes);
  } catch (const BrokenLink& broken) {
    return broken.what();
  }
  return {};
}
std::string refusal(const LinkMessage& message) { return refusal(bytesOf(message)); }

TEST(LinkMessage, ComesBackToTheBit) {
  std::size_t kind = 0;
  for (const LinkMessage& message : test::sampleMessages()) {
    const Bytes bytes = bytesOf(message);
    ASSERT_EQ(message.index(), kind++);
    EXPECT_EQ(sizeOfLinkMessage(bytes), bytes.size());
    const LinkMessage back = linkMessageOf(bytes);
    EXPECT_EQ(back.index(), message.index());
    EXPECT_EQ(bytesOf(back), bytes);
  }
  EXPECT_EQ(kind, std::variant_size_v<LinkMessage>);
}

TEST(LinkMessage, FieldsComeBackWhereTheyWere) {
  const auto back = std::get<LinkPresent>(linkMessageOf(bytesOf(samplePresent())));
  EXPECT_EQ(back.present.number, 77U);
  EXPECT_EQ(back.present.strokes, 3U);
  EXPECT_TRUE(back.present.waits);
  ASSERT_EQ(back.present.size, 2U);
  EXPECT_EQ(back.present.persons[1].promise.t_s, 21.0);
  EXPECT_EQ(back.present.persons[1].hand.r_m, Vec3(1.2, 2.25, 0.9));
  EXPECT_EQ(back.persons[1].held, 3U);
  EXPECT_EQ(back.boardFromRoom, samplePresent().boardFromRoom);
  const auto stroke = std::get<LinkStroke>(linkMessageOf(bytesOf(sampleStroke(9))));
  EXPECT_EQ(stroke.told.number, 9U);
  EXPECT_EQ(stroke.told.stroke.puck, 2U);
  EXPECT_EQ(*stroke.told.stroke.from_m, Vec3(-0.25, 1.5, 0.125));
}

// The bytes of others' programs: they stay as they are.
TEST(LinkMessage, IsLittleEndianAndAsShortAsItSays) {
  EXPECT_EQ(bytesOf(LinkDigest{81, 42}), (Bytes{8, 0, 12, 0, 0, 0, 81, 0, 0, 0, 42, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(bytesOf(sampleStroke(0)).size(), 6U + 72U);
  LinkPresent alone = samplePresent();
  alone.present.size = 1;
  EXPECT_LE(bytesOf(alone).size(), 400U) << "so that a room sends at most 25 kB/s";
}

TEST(LinkMessage, RefusesNumbersThatCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1000.1, -1000.1}) {
    LinkPresent present = samplePresent();
    present.present.persons[1].head.r_m.y = bad;
    EXPECT_NE(refusal(present).find("a place (m)"), std::string::npos) << bad;
    LinkStroke stroke = sampleStroke(0);
    stroke.told.stroke.from_m->z = bad;
    EXPECT_NE(refusal(stroke).find("a place (m)"), std::string::npos) << bad;
  }
  LinkPresent turned = samplePresent();
  turned.persons[0].attitude.w *= 1.0 + 3e-6;
  EXPECT_EQ(refusal(turned), "it sent an attitude that is no rotation");
  LinkPresent moved = samplePresent();
  moved.boardFromRoom[1][2] += 1e-3;
  EXPECT_EQ(refusal(moved), "it sent a motion that is no Lorentz transform");
  LinkPresent back = samplePresent();
  back.boardFromRoom = -1.0 * back.boardFromRoom;
  EXPECT_EQ(refusal(back), "it sent a motion that is no Lorentz transform");
  LinkStroke late = sampleStroke(0);
  late.told.stroke.at_s = nan;
  EXPECT_NE(refusal(late).find("a board time (s)"), std::string::npos);
  LinkStroke many = sampleStroke(kMostStrokesTold);
  EXPECT_NE(refusal(many).find("a stroke's number of 20000, expected 0 to 19999"), std::string::npos);
  LinkPresent nobody = samplePresent();
  nobody.present.size = 0;
  EXPECT_NE(refusal(nobody), "");
}

TEST(LinkMessage, RefusesNamesThatCouldHarm) {
  const auto named = [](const std::string& name) {
    LinkHello hello = std::get<LinkHello>(test::sampleMessages()[0]);
    hello.room = name;
    return refusal(hello);
  };
  EXPECT_EQ(named("Zürich ☕"), "");
  for (const char* bad : {"a\033[2J", "a\n", "a\x7f", "a\xc2\x85", "\xff", "\xc3", "\xc0\xaf", "\xed\xa0\x80",
                          "\xf4\x90\x80\x80"})
    EXPECT_EQ(named(bad), "it sent a room's name with control characters or that is not UTF-8") << bad;
  EXPECT_EQ(named(std::string(24, 'x')), "");
  EXPECT_NE(named(std::string(25, 'x')), "");
  LinkWelcome welcome = std::get<LinkWelcome>(test::sampleMessages()[3]);
  welcome.meshes[0].name = "../room.key";
  EXPECT_EQ(refusal(welcome), "it sent a mesh in a folder, expected a name without '/'");
}

TEST(LinkMessage, RefusesWhatIsTooLong) {
  LinkWelcome welcome = std::get<LinkWelcome>(test::sampleMessages()[3]);
  welcome.scenario.assign(kMostScenarioBytes, ' ');
  EXPECT_EQ(refusal(welcome), "");
  welcome.scenario += ' ';
  EXPECT_NE(refusal(welcome), "");
  welcome.scenario.clear();
  welcome.strokes.assign(kMostStrokesTold, sampleStroke(0));
  EXPECT_EQ(refusal(welcome), "") << "as many strokes as a game holds";
  EXPECT_EQ(refusal(Bytes{1, 0, 1, 0, 1, 0}), "it sent a message of 65537 bytes, which is too long");
  EXPECT_EQ(refusal(Bytes{99, 0, 0, 0, 0, 0}), "it sent a message of kind 99, which there is not");
  // A number of things that the message does not hold takes no memory.
  Bytes claims{0, 0, 32, 0, 0, 0};
  claims.resize(38);
  EXPECT_NE(refusal(claims), "");
}

TEST(LinkMessage, RefusesOtherProtocolsAndProgramsByName) {
  Bytes other = bytesOf(test::sampleMessages()[0]);
  other[10] = 1;
  EXPECT_EQ(refusal(other), "it sent a protocol of 1, expected 3 to 3");
  other[6] = 'X';
  EXPECT_EQ(refusal(other), "it is no carom");
}

TEST(LinkMessage, EveryShorterAndLongerOneIsRefused) {
  for (const LinkMessage& message : test::sampleMessages()) {
    const Bytes bytes = bytesOf(message);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_NE(refusal(part), "");
      if (size < 6) continue;
      const std::size_t body = size - 6;  // with a length that is true
      for (std::size_t i = 0; i < 4; ++i) part[2 + i] = static_cast<std::uint8_t>(body >> (8 * i));
      EXPECT_NE(refusal(part), "") << message.index() << ", " << size;
    }
    Bytes longer = bytes;
    longer.push_back(0);
    ++longer[2];
    EXPECT_NE(refusal(longer), "");
  }
}

// What is read from hostile bytes is written as the same bytes: nothing was read that is not there.
TEST(LinkMessage, AHundredThousandMutationsAreReadOrRefused) {
  std::mt19937_64 random(40);
  std::vector<Bytes> kept;
  for (const LinkMessage& message : test::sampleMessages()) kept.push_back(bytesOf(message));
  int readable = 0;
  for (int i = 0; i < 100000; ++i) {
    Bytes bytes = test::mutated(kept[random() % kept.size()], kept[random() % kept.size()], random);
    if (i % 2 == 0 && bytes.size() >= 6) {
      const std::size_t body = bytes.size() - 6;
      for (std::size_t k = 0; k < 4; ++k) bytes[2 + k] = static_cast<std::uint8_t>(body >> (8 * k));
    }
    try {
      const LinkMessage message = linkMessageOf(bytes);
      EXPECT_EQ(bytesOf(message), bytes);
      ++readable;
    } catch (const BrokenLink&) {
    }
  }
  EXPECT_GT(readable, 5000);
  EXPECT_LT(readable, 95000);
}

}  // namespace
}  // namespace carom
