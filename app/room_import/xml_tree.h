#pragma once
// An XML file as a tree that knows where each element and attribute stands. Parsed by expat.

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
  FilePlace valueAt;  ///< of its first letter, behind the quote
};

struct XmlElement {
  std::string name;
  FilePlace at;  ///< of its <
  std::vector<XmlAttribute> attributes;
  std::vector<XmlElement> children;

  /// Null where there is none.
  const XmlAttribute* attribute(std::string_view wanted) const;
};

/// The root element. Text between elements is passed over. Throws InputErrors where the file cannot be read,
/// is no XML, is nested over 32 deep or declares a document type (whose entities could grow without end).
XmlElement readXml(const std::filesystem::path& file);

}  // namespace carom
