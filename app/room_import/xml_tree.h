#pragma once
// An XML file as a tree with the position of each element and attribute. Parsed by expat.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/input_file.h"

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

  /// Returns null if there is none.
  const XmlAttribute* attribute(std::string_view wanted) const;
};

/// Returns the root element. Text between elements is ignored. Throws InputErrors if the file cannot be read,
/// is not XML, is nested over 32 levels deep, has over 100 000 elements and attributes, or declares a
/// document type (whose entities could grow without limit).
XmlElement readXml(const std::filesystem::path& file);

}  // namespace carom
