// XML as a tree: places of elements, attributes and texts, document types, and files that are refused.
#include "app/room_import/xml_tree.h"

#include <gtest/gtest.h>

#include <string>

#include "app/import_faults.h"

namespace carom {
namespace {

using test::placed;

XmlFile parse(const std::string& text, Doctype doctype = Doctype::none) {
  return parseXml("a.xml", text, doctype);
}

/// "LINE:COLUMN MESSAGE" of the fault of a text; empty if it has none.
std::string faultOf(const std::string& text, Doctype doctype = Doctype::none) {
  try {
    parse(text, doctype);
  } catch (const InputErrors& errors) {
    return placed({errors.line(), errors.column()}) + " " + errors.message();
  }
  return {};
}

TEST(XmlTree, ElementsAttributesAndTextsHaveTheirPlaces) {
  const XmlElement root = parse(
                              "<?xml version='1.0'?>\n<a  one='1'\n\ttwo = \"it's\">\n  <b/>\n"
                              "  first <c>\n inner </c> last \n</a>")
                              .root;
  EXPECT_EQ(root.name, "a");
  EXPECT_EQ(placed(root.at), "2:1");
  ASSERT_EQ(root.attributes.size(), 2u);
  EXPECT_EQ(placed(root.attributes[0].nameAt), "2:5");
  EXPECT_EQ(placed(root.attributes[0].valueAt), "2:10");
  EXPECT_EQ(root.attributes[1].value, "it's");
  EXPECT_EQ(placed(root.attributes[1].nameAt), "3:2");
  EXPECT_EQ(placed(root.attributes[1].valueAt), "3:9");
  ASSERT_NE(root.attribute("one"), nullptr);
  EXPECT_EQ(root.attribute("one")->value, "1");
  EXPECT_EQ(root.attribute("three"), nullptr);
  ASSERT_EQ(root.children.size(), 2u);
  EXPECT_EQ(placed(root.children[0].at), "4:3");
  EXPECT_EQ(root.children[1].text, "inner");
  EXPECT_EQ(placed(root.children[1].textAt), "6:2");
  EXPECT_EQ(placed(root.textAt), "5:3");
  EXPECT_TRUE(root.text.starts_with("first ") && root.text.ends_with(" last")) << root.text;
}

// Nothing that a file names is opened; a document type that could grow is refused at its place.
TEST(XmlTree, DocumentTypesNameFilesAtMost) {
  const std::string named = "<!DOCTYPE a [\n<!ENTITY part SYSTEM 'part.xml'>\n]>\n<a><b/>&part;</a>";
  EXPECT_EQ(faultOf(named), "1:13 the file declares a document type, expected elements alone");
  const XmlFile file = parse(named, Doctype::outside);
  EXPECT_EQ(file.root.children.size(), 1u);
  ASSERT_EQ(file.leftOut.size(), 1u);
  EXPECT_EQ(file.leftOut[0].file, "part.xml");
  EXPECT_EQ(placed(file.leftOut[0].at), "4:8");
  EXPECT_NE(faultOf("<!DOCTYPE a [\n<!ENTITY x 'xx'>\n]>\n<a>&x;</a>", Doctype::outside)
                .find("defines an entity with a text of its own"),
            std::string::npos);
  EXPECT_NE(faultOf("<!DOCTYPE a [\n<!ATTLIST a b CDATA 'c'>\n]>\n<a/>", Doctype::outside)
                .find("defines attributes"),
            std::string::npos);
}

TEST(XmlTree, RefusesWhatItCannotHold) {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "<a>";
    for (std::size_t i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  EXPECT_EQ(faultOf(nested(32)), "");
  EXPECT_EQ(faultOf(nested(33)), "1:97 elements are nested too deep, expected at most 32");
  const auto many = [](std::size_t elements) {
    std::string text = "<a>";
    for (std::size_t i = 0; i < elements; ++i) text += "<b c=''/>\n";
    return text + "</a>";
  };
  EXPECT_EQ(faultOf(many(49'999)), "");
  EXPECT_EQ(faultOf(many(50'000)), "50000:1 too many elements and attributes, expected at most 100000");
  EXPECT_EQ(faultOf("<a>\n<b>"), "2:4 the file ends within <b> of line 2, expected </b>");
  EXPECT_TRUE(faultOf("<a>\n</b>").starts_with("2:3 this is no XML (")) << faultOf("<a>\n</b>");
}

}  // namespace
}  // namespace carom
