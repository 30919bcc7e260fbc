#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <expat.h>
#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/warp_grid.h"
#include "cave/warps/warp_formats.h"

namespace carom {
namespace {

/// The offsets along one axis.
struct Offsets {
  std::string_view name;
  std::string range, numbers;        ///< as they stand in the file
  std::size_t line = 0, column = 0;  ///< 0: there are none
};

/// What expat's handlers note. They throw nothing: expat is C.
struct Noted {
  XML_Parser parser = nullptr;
  std::array<Offsets, 2> offsets{{{"X-FlatParameters", {}, {}}, {"Y-FlatParameters", {}, {}}}};
  Offsets* open = nullptr;
  std::string fault;
};

void stop(Noted& noted, const std::string& why) {
  if (noted.fault.empty())
    noted.fault = fmt::format("{}:{}: {}", XML_GetCurrentLineNumber(noted.parser),
                              XML_GetCurrentColumnNumber(noted.parser) + 1, why);
  XML_StopParser(noted.parser, XML_FALSE);
}

void begin(void* user, const XML_Char* name, const XML_Char** attributes) {
  auto& noted = *static_cast<Noted*>(user);
  for (Offsets& offsets : noted.offsets) {
    if (offsets.name != name) continue;
    if (offsets.line != 0 || noted.open)
      return stop(noted, fmt::format("<{}> is here again, expected one", name));
    offsets.line = XML_GetCurrentLineNumber(noted.parser);
    offsets.column = XML_GetCurrentColumnNumber(noted.parser) + 1;
    for (std::size_t i = 0; attributes[i]; i += 2)
      if (std::string_view(attributes[i]) == "range") offsets.range = attributes[i + 1];
    noted.open = &offsets;
  }
}

void end(void* user, const XML_Char* name) {
  auto& noted = *static_cast<Noted*>(user);
  if (noted.open && noted.open->name == name) noted.open = nullptr;
}

void text(void* user, const XML_Char* characters, int length) {
  auto& noted = *static_cast<Noted*>(user);
  if (noted.open) noted.open->numbers.append(characters, static_cast<std::size_t>(length));
}

void refuseDoctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
  stop(*static_cast<Noted*>(user), "the file declares a document type, expected none");
}

Noted notedIn(std::string_view content) {
  Noted noted;
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                            &XML_ParserFree);
  noted.parser = parser.get();
  XML_SetUserData(parser.get(), &noted);
  XML_SetElementHandler(parser.get(), begin, end);
  XML_SetCharacterDataHandler(parser.get(), text);
  XML_SetStartDoctypeDeclHandler(parser.get(), refuseDoctype);
  if (XML_Parse(parser.get(), content.data(), static_cast<int>(content.size()), XML_TRUE) != XML_STATUS_OK &&
      noted.fault.empty())
    stop(noted, fmt::format("this is no XML ({}), expected a GeometryFile of SimCAD",
                            XML_ErrorString(XML_GetErrorCode(parser.get()))));
  if (!noted.fault.empty()) throw std::runtime_error(noted.fault);
  return noted;
}

/// Returns the offsets as shares of the window.
std::vector<double> sharesOf(const Offsets& offsets) {
  constexpr double kWidest = 1e6;
  const auto fault = [&](const std::string& why) {
    meshFault(std::max<std::size_t>(offsets.line, 1), std::max<std::size_t>(offsets.column, 1), why);
  };
  if (offsets.line == 0)
    fault(fmt::format("there is no <{}>, expected a GeometryFile of SimCAD", offsets.name));
  const auto range = numberIn(offsets.range);
  if (!range || !(*range >= 1.0 && *range <= kWidest))
    fault(fmt::format("<{}> has no range, expected one from 1 to {:g}", offsets.name, kWidest));
  std::vector<double> shares;
  MeshLines lines(offsets.numbers);
  while (lines.next()) {
    for (std::string_view word = lines.word(); !word.empty(); word = lines.word()) {
      const auto number = numberIn(word);
      if (!number || !(std::abs(*number) <= kFarthestInWindow * *range))
        fault(fmt::format("number {} of <{}> is wrong, expected one from {:g} to {:g}", shares.size() + 1,
                          offsets.name, -kFarthestInWindow * *range, kFarthestInWindow * *range));
      shares.push_back(*number / *range);
    }
  }
  return shares;
}

}  // namespace

Warp parseSimcadWarp(std::string_view content) {
  const Noted noted = notedIn(content);
  const std::vector<double> right = sharesOf(noted.offsets[0]), down = sharesOf(noted.offsets[1]);
  const auto across = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(right.size()))));
  if (right.size() != down.size() || across < 2 || across * across != right.size())
    meshFault(noted.offsets[1].line, noted.offsets[1].column,
              fmt::format("there are {} numbers for x and {} for y, expected as many, of a square grid",
                          right.size(), down.size()));
  WarpMesh mesh;
  for (std::size_t i = 0; i < right.size(); ++i) {
    const double x = static_cast<double>(i % across) / static_cast<double>(across - 1),
                 y = static_cast<double>(i / across) / static_cast<double>(across - 1);
    mesh.points.push_back(
        {.inWindow = glm::vec2(x + right[i], 1.0 - (y + down[i])), .inPicture = glm::vec2(x, 1.0 - y)});
  }
  addGridTriangles(across, across, mesh);
  return {mesh, mesh};
}

}  // namespace carom
