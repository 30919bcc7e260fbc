#include "app/page/page_shaders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "cave/record/effects.h"
#include "engine/colour/doppler_colour.h"

namespace carom {
namespace {

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// Replaces the fetches of a buffer by those of a texture with rows of `rowTexels`.
void fetchFromRows(std::string& text, const std::string& buffer, int rowTexels) {
  replaceAll(text, fmt::format("texelFetch({}, ", buffer),
             fmt::format("fetchedFrom{}({}, ", rowTexels, buffer));
}

std::string beginningOf(bool isVertex) {
  std::string text =
      "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
  text += isVertex ? "out float existsFor;\n" : "in float existsFor;\n";
  for (const int row : {kLegRowTexels, ColourTable::kColumns}) {
    text += fmt::format(
        "vec4 fetchedFrom{0}(sampler2D rows, int i) {{ return texelFetch(rows, ivec2(i % {0}, i / {0}), 0); "
        "}}\n",
        row);
  }
  return text;
}

int bitsOf(const Switches& switches) {
  int bits = 0;
  for (std::size_t i = 0; i < kNamedSwitches.size(); ++i)
    if (switches.*kNamedSwitches[i].value) bits |= 1 << i;
  return bits;
}

/// All states of the first three effects with the others as recorded.
std::vector<Switches> statesOf(const std::vector<Switches>& recorded) {
  std::vector<Switches> states;
  for (const Switches& one : recorded) {
    for (int bits = 0; bits < 8; ++bits) {
      Switches state = one;
      for (std::size_t i = 0; i < 3; ++i)
        state.*kNamedSwitches[i].value = static_cast<std::uint8_t>(bits >> i & 1);
      if (std::find(states.begin(), states.end(), state) == states.end()) states.push_back(state);
    }
  }
  return states;
}

}  // namespace

std::string nameOf(const BodyVariant& variant) {
  return fmt::format("{}/{}/{}/{}", static_cast<int>(variant.legs), static_cast<int>(variant.paint),
                     bitsOf(variant.switches), static_cast<int>(variant.moment));
}

std::string browserText(std::string text, bool isVertex) {
  replaceAll(text, "#version 150\n", beginningOf(isVertex));
  replaceAll(text, "samplerBuffer", "sampler2D");
  fetchFromRows(text, "legTexels", kLegRowTexels);
  fetchFromRows(text, "colourTexels", ColourTable::kColumns);
  replaceAll(text, "gl_ClipDistance[0] = ", "existsFor = ");
  if (!isVertex) replaceAll(text, "void main() {", "void main() {\n  if (existsFor < 0.0) discard;");
  return text;
}

PageShaders pageShaders(const std::vector<Paint>& resting, const std::vector<Paint>& moving,
                        const std::vector<Switches>& recorded, bool followsLamps) {
  PageShaders shaders;
  std::map<std::string, std::size_t> placeOf;
  const auto placesOf = [&](const ShaderParts& parts, bool isVertex) {
    std::vector<std::size_t> places;
    for (const std::string& part : parts) {
      const auto [found, isNew] = placeOf.try_emplace(browserText(part, isVertex), shaders.parts.size());
      if (isNew) shaders.parts.push_back(found->first);
      places.push_back(found->second);
    }
    return places;
  };
  const auto add = [&](const BodyVariant& variant) {
    shaders.variants.push_back(
        {variant, placesOf(bodyVertexParts(variant), true), placesOf(surfaceFragmentParts(variant), false)});
  };
  constexpr std::array kMovingLegs{Legs::one, Legs::oneSpinning, Legs::aroundTurn, Legs::many,
                                   Legs::manySpinning};
  for (const Switches& state : statesOf(recorded)) {
    for (const Paint paint : resting) add({Legs::rest, paint, state, ViewTime::seen, followsLamps});
    for (const Legs legs : kMovingLegs) {
      for (const Paint paint : moving) add({legs, paint, state, ViewTime::seen, followsLamps});
      for (const ViewTime moment : {ViewTime::boardNow, ViewTime::myNow})
        add({legs, Paint::plain, state, moment, followsLamps});
    }
  }
  return shaders;
}

}  // namespace carom
