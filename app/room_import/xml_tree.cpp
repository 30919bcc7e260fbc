#include "app/room_import/xml_tree.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace carom {

namespace {

constexpr std::size_t kDeepest = 32, kMostElements = 100'000;  // with their attributes
constexpr std::string_view kBlank = " \t\r\n";

/// The state of expat's handlers.
struct Reading {
  XML_Parser parser;
  std::string_view text;
  LineIndex lines;
  XmlElement root;
  std::vector<std::size_t> path;  // from the root to the open element, as indices among children
  std::size_t open = 0, elements = 0;
  std::string refusal;  // why reading stopped, if expat gave no reason

  XmlElement& current() {
    XmlElement* element = &root;
    for (const std::size_t child : path) element = &element->children[child];
    return *element;
  }
  void refuse(const char* why) {
    refusal = why;
    XML_StopParser(parser, XML_FALSE);
  }
};

/// Sets the positions of the attributes by scanning the tag, which is already known to be well formed,
/// because expat reports only their order.
void placeAttributes(XmlElement& element, std::string_view text, std::size_t tag, const LineIndex& lines) {
  std::size_t i = text.find_first_of(" \t\r\n/>", tag);
  for (XmlAttribute& attribute : element.attributes) {
    const std::size_t name = text.find_first_not_of(kBlank, i);
    const std::size_t quote = text.find_first_of("\"'", name);
    if (quote == std::string_view::npos) return;
    attribute.nameAt = lines.at(name);
    attribute.valueAt = lines.at(quote + 1);
    i = text.find(text[quote], quote + 1) + 1;
  }
}

void XMLCALL begin(void* user, const XML_Char* name, const XML_Char** attributes) {
  Reading& reading = *static_cast<Reading*>(user);
  if (reading.open >= kDeepest) return reading.refuse("elements are nested too deep, expected at most 32");
  const auto tag = static_cast<std::size_t>(XML_GetCurrentByteIndex(reading.parser));
  XmlElement element{name, reading.lines.at(tag), {}, {}};
  for (const XML_Char** next = attributes; *next; next += 2) ++reading.elements;
  if (++reading.elements > kMostElements)
    return reading.refuse("too many elements and attributes, expected at most 100000");
  for (; *attributes; attributes += 2) element.attributes.push_back({attributes[0], attributes[1], {}, {}});
  placeAttributes(element, reading.text, tag, reading.lines);
  if (reading.open++ == 0) {
    reading.root = std::move(element);
    return;
  }
  auto& siblings = reading.current().children;
  siblings.push_back(std::move(element));
  reading.path.push_back(siblings.size() - 1);
}

void XMLCALL end(void* user, const XML_Char*) {
  Reading& reading = *static_cast<Reading*>(user);
  --reading.open;
  if (!reading.path.empty()) reading.path.pop_back();
}

void XMLCALL beginDoctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
  static_cast<Reading*>(user)->refuse("the file declares a document type, expected elements alone");
}

}  // namespace

const XmlAttribute* XmlElement::attribute(std::string_view wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const XmlAttribute& attribute) { return attribute.name == wanted; });
  return found == attributes.end() ? nullptr : &*found;
}

XmlElement readXml(const std::filesystem::path& file) {
  const std::string text = readText(file, InputKind::xml);
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate("UTF-8"),
                                                                            &XML_ParserFree);
  Reading reading{parser.get(), text, LineIndex(text), {}, {}, 0, 0, {}};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), begin, end);
  XML_SetStartDoctypeDeclHandler(parser.get(), beginDoctype);
  if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) == XML_STATUS_OK) {
    return std::move(reading.root);
  }
  const auto where = static_cast<std::size_t>(std::max<XML_Index>(0, XML_GetCurrentByteIndex(parser.get())));
  const FilePlace at = reading.lines.at(where);
  throw InputErrors(
      {InputError(file.string(), at.line, at.column,
                  reading.refusal.empty() ? fmt::format("this is no XML ({}), expected well-formed elements",
                                                        XML_ErrorString(XML_GetErrorCode(parser.get())))
                                          : reading.refusal)});
}

}  // namespace carom
