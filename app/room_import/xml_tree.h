#pragma once
// An XML file as a tree with the position of each element and attribute. Parsed by expat.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/toml/input_file.h"

namespace carom {

struct XmlAttribute {
  std::string name;
  std::string value;
  FilePlace nameAt;
  FilePlace valueAt;  ///< position of its first character, after the quote
};

struct XmlElement {
  std::string name;
  FilePlace at;  ///< position of its <
  std::vector<XmlAttribute> attributes;
  std::vector<XmlElement> children;
  std::string text{};  ///< the text between its tags, without that of its children and surrounding blanks
  FilePlace textAt{};  ///< position of its first character

  /// Returns null if there is none.
  const XmlAttribute* attribute(std::string_view wanted) const;
};

/// What a file may have before its root element.
enum class Doctype {
  none,    ///< no document type
  outside  ///< a document type that names files: none is opened, and each use of one is listed
};

/// The use of a file as an entity, which is left out.
struct OutsideEntity {
  std::string file;
  FilePlace at;
};

struct XmlFile {
  XmlElement root;
  std::vector<OutsideEntity> leftOut;
};

/// Returns the root element. Throws InputErrors if the file cannot be read, is not XML, is nested over 32
/// levels deep, has over 100 000 elements and attributes, or declares a document type that is not allowed;
/// entities with a text of their own never are: they could grow without limit.
XmlElement readXml(const std::filesystem::path& file);
XmlFile readXml(const std::filesystem::path& file, Doctype doctype);
/// The same of a text that has been read from the file.
XmlFile parseXml(const std::filesystem::path& file, const std::string& text, Doctype doctype);

}  // namespace carom
