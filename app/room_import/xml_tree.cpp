#include "app/room_import/xml_tree.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace carom {

namespace {

constexpr std::size_t kDeepestXml = 32, kMostElements = 100'000;  // with their attributes
constexpr std::string_view kBlank = " \t\r\n";

/// The state of expat's handlers.
struct XmlReading {
  XML_Parser parser;
  std::string_view text;
  LineIndex lines;
  XmlElement root;
  std::vector<std::size_t> path;  // from the root to the open element, as indices among children
  std::size_t open = 0, elements = 0;
  std::vector<OutsideEntity> leftOut;
  std::string refusal;  // why reading stopped, if expat gave no reason
  FilePlace refusedAt{};

  XmlElement& current() {
    XmlElement* element = &root;
    for (const std::size_t child : path) element = &element->children[child];
    return *element;
  }
  /// Returns why the text is no XML, in the parser's words; of a file that has lost its end, where it
  /// stopped.
  std::string faultOf(XML_Error error) const {
    const XmlElement* last = open > 0 ? &root : nullptr;
    for (const std::size_t child : path) last = &last->children[child];
    if (last && (error == XML_ERROR_NO_ELEMENTS || error == XML_ERROR_UNCLOSED_TOKEN))
      return fmt::format("the file ends within <{}> of line {}, expected </{}>", printable(last->name),
                         last->at.line, printable(last->name));
    return fmt::format("this is no XML ({}), expected well-formed elements", XML_ErrorString(error));
  }
  void refuse(const char* why) {
    refusal = why;
    refusedAt = lines.at(static_cast<std::size_t>(std::max<XML_Index>(0, XML_GetCurrentByteIndex(parser))));
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
  XmlReading& reading = *static_cast<XmlReading*>(user);
  if (reading.open >= kDeepestXml) return reading.refuse("elements are nested too deep, expected at most 32");
  const auto tag = static_cast<std::size_t>(XML_GetCurrentByteIndex(reading.parser));
  XmlElement element{name, reading.lines.at(tag), {}, {}};
  element.textAt = element.at;
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
  XmlReading& reading = *static_cast<XmlReading*>(user);
  --reading.open;
  if (!reading.path.empty()) reading.path.pop_back();
}

void XMLCALL characters(void* user, const XML_Char* text, int length) {
  XmlReading& reading = *static_cast<XmlReading*>(user);
  if (reading.open == 0) return;
  XmlElement& element = reading.current();
  std::string_view more(text, static_cast<std::size_t>(length));
  if (element.text.empty()) {
    const std::size_t first = more.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return;
    const auto at = static_cast<std::size_t>(XML_GetCurrentByteIndex(reading.parser));
    element.textAt = reading.lines.at(at + first);
    more.remove_prefix(first);
  }
  element.text += more;
}

void XMLCALL refuseDoctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
  static_cast<XmlReading*>(user)->refuse("the file declares a document type, expected elements alone");
}

void XMLCALL refuseEntity(void* user, const XML_Char*, int isParameter, const XML_Char* value, int,
                          const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
  if (!value && !isParameter) return;  // names a file
  static_cast<XmlReading*>(user)->refuse(
      "the document type defines an entity with a text of its own, expected none, or files alone");
}

void XMLCALL refuseAttributes(void* user, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*,
                              int) {
  static_cast<XmlReading*>(user)->refuse("the document type defines attributes, expected files alone");
}

int XMLCALL leaveOut(XML_Parser parser, const XML_Char*, const XML_Char*, const XML_Char* file,
                     const XML_Char*) {
  XmlReading& reading = *static_cast<XmlReading*>(XML_GetUserData(parser));
  const auto at = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser));
  constexpr std::size_t kMostLeftOut = 100;
  if (reading.leftOut.size() < kMostLeftOut)
    reading.leftOut.push_back({file ? file : "", reading.lines.at(at)});
  return XML_STATUS_OK;
}

/// Removes the blanks behind each element's text.
void trim(XmlElement& element) {
  element.text.erase(element.text.find_last_not_of(kBlank) + 1);
  for (XmlElement& child : element.children) trim(child);
}

}  // namespace

const XmlAttribute* XmlElement::attribute(std::string_view wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const XmlAttribute& attribute) { return attribute.name == wanted; });
  return found == attributes.end() ? nullptr : &*found;
}

XmlElement readXml(const std::filesystem::path& file) { return readXml(file, Doctype::none).root; }

XmlFile readXml(const std::filesystem::path& file, Doctype doctype) {
  return parseXml(file, readText(file, InputKind::xml), doctype);
}

XmlFile parseXml(const std::filesystem::path& file, const std::string& text, Doctype doctype) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate("UTF-8"),
                                                                            &XML_ParserFree);
  XmlReading reading{parser.get(), text, LineIndex(text), {}, {}, 0, 0, {}, {}, {}};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), begin, end);
  XML_SetCharacterDataHandler(parser.get(), characters);
  if (doctype == Doctype::none) {
    XML_SetStartDoctypeDeclHandler(parser.get(), refuseDoctype);
  } else {
    XML_SetEntityDeclHandler(parser.get(), refuseEntity);
    XML_SetAttlistDeclHandler(parser.get(), refuseAttributes);
    XML_SetExternalEntityRefHandler(parser.get(), leaveOut);
  }
  if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) == XML_STATUS_OK) {
    trim(reading.root);
    return {std::move(reading.root), std::move(reading.leftOut)};
  }
  const auto where = static_cast<std::size_t>(std::max<XML_Index>(0, XML_GetCurrentByteIndex(parser.get())));
  const FilePlace at = reading.refusal.empty() ? reading.lines.at(where) : reading.refusedAt;
  throw InputErrors({InputError(
      file.string(), at.line, at.column,
      reading.refusal.empty() ? reading.faultOf(XML_GetErrorCode(parser.get())) : reading.refusal)});
}

}  // namespace carom
