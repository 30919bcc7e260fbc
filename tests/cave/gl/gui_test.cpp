// Input of a Gui: every click counts, however short it is and whatever was pointed to before it.
#include "cave/gl/gui.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <utf8cpp/utf8.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "cave/gl/graphics.h"
#include "places.h"

namespace carom {
namespace {

using Kind = GuiEvent::Kind;

class GuiTest : public testing::Test {
 protected:
  /// A frame with three tabs and a button; notes which tab is open, and presses of the button.
  void frame() {
    gui_.begin({600, 300});
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize({600.0F, 300.0F});
    ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    if (ImGui::Button("button", {100.0F, 40.0F})) ++presses_;
    button_ = middleOfItem();
    if (ImGui::BeginTabBar("tabs")) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::string name = "tab " + std::to_string(i);
        if (ImGui::BeginTabItem(name.c_str())) {
          open_ = i;
          ImGui::EndTabItem();
        }
        tabs_[i] = middleOfItem();
      }
      ImGui::EndTabBar();
    }
    if (claims_) Gui::claim();
    ImGui::End();
    gui_.end();
  }
  static glm::vec2 middleOfItem() {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    return {0.5F * (low.x + high.x), 0.5F * (low.y + high.y)};
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }
  /// The pointer comes, and the button is pressed and let go, all between two frames.
  void click(const glm::vec2& at) {
    gui_.hear({Kind::pointer, at});
    gui_.hear({Kind::button, {}, 0, true});
    gui_.hear({Kind::button, {}, 0, false});
  }

  Graphics graphics_;
  Gui gui_{16.0F};
  glm::vec2 button_{0.0F}, tabs_[3]{};
  std::size_t open_ = 0;
  int presses_ = 0;
  bool claims_ = false;
};

TEST_F(GuiTest, AClickWithinAFrameOpensATabWhateverWasPointedToBefore) {
  frames(3);
  ASSERT_EQ(open_, 0U);
  for (const std::size_t tab : {2U, 1U, 0U, 2U, 0U, 1U}) {
    gui_.hear({Kind::pointer, button_});
    frames(2);
    click(tabs_[tab]);
    frames(5);
    EXPECT_EQ(open_, tab);
  }
  EXPECT_EQ(presses_, 0);
}

TEST_F(GuiTest, ClicksWithinAFrameAreAsManyPresses) {
  frames(3);
  for (int i = 0; i < 3; ++i) click(button_);
  frames(12);
  EXPECT_EQ(presses_, 3);
}

TEST_F(GuiTest, WhatIsClaimedIsKnownBetweenFrames) {
  frames(2);
  EXPECT_FALSE(gui_.isClaimed({10.0F, 10.0F}));
  claims_ = true;
  frame();
  EXPECT_TRUE(gui_.isClaimed({10.0F, 10.0F}));
  EXPECT_FALSE(gui_.isClaimed({700.0F, 10.0F}));
  gui_.forgetClaims();
  EXPECT_FALSE(gui_.isClaimed({10.0F, 10.0F}));
}

/// Returns the characters of a file beyond ASCII.
std::set<char32_t> lettersOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::set<char32_t> letters;
  for (auto at = text.begin(); at != text.end();) {
    const char32_t letter = utf8::next(at, text.end());
    if (letter > 0x7f) letters.insert(letter);
  }
  return letters;
}

TEST(GuiLetters, EveryLetterOfTheTextsAndTheGamesCanBeDrawn) {
  const Graphics graphics;
  Gui gui(16.0F);
  gui.begin({100, 100});
  gui.end();
  std::set<char32_t> letters = lettersOf(CAROM_TESTS_DIR "/../cave/texts/texts.h");
  for (const auto& file : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios"))
    letters.merge(lettersOf(file.path()));
  EXPECT_TRUE(letters.contains(U'γ') && letters.contains(U'−'));
  const ImFont* font = ImGui::GetIO().Fonts->Fonts[0];
  for (const char32_t letter : letters)
    EXPECT_NE(font->FindGlyphNoFallback(static_cast<ImWchar>(letter)), nullptr)
        << "U+" << std::hex << static_cast<unsigned>(letter);
}

// A window has the letters of the session's languages, of the fonts that have them; without them it has what
// it always had.
TEST(GuiLetters, AreThoseOfTheLanguagesInUse) {
  Graphics graphics;
  graphics.makeCurrent();
  const auto has = [](char32_t letter) {
    return ImGui::GetFont()->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr;
  };
  const auto heightOfAtlas = [](Gui& gui, auto&& look) {
    gui.begin({200, 100});
    look();
    const int height_px = ImGui::GetIO().Fonts->TexHeight;
    gui.end();
    return height_px;
  };
  int before_px = 0;
  {
    Gui gui(16.0F);
    before_px = heightOfAtlas(gui, [&] {
      EXPECT_TRUE(has(U'ö') && has(U'γ') && has(U'→'));
      EXPECT_FALSE(has(U'光'));
    });
  }
  Gui::setLetters(U"光は遅い、だから光");
  {
    Gui gui(16.0F, 21.0F);
    heightOfAtlas(gui, [&] {
      for (const char32_t letter : {U'光', U'は', U'遅', U'い', U'、', U'だ', U'か', U'ら', U'ö'})
        EXPECT_TRUE(has(letter)) << static_cast<unsigned>(letter);
      EXPECT_FALSE(has(U'早')) << "nobody asked for it";
      EXPECT_NEAR(ImGui::CalcTextSize("光は").x, 32.0F, 2.0F);
      EXPECT_EQ(ImGui::GetIO().Fonts->Fonts.Size, 2) << "the heading's is still number 1";
    });
  }
  Gui::setLetters({});
  Gui gui(16.0F);
  EXPECT_EQ(heightOfAtlas(gui, [&] { EXPECT_FALSE(has(U'光')); }), before_px);
}

}  // namespace
}  // namespace carom
