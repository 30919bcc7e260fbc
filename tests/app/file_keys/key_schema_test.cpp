// The JSON Schema and the page of a small kind of file, against those that were written by hand.
#include "app/file_keys/key_schema.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace carom {
namespace {

using namespace declare;
using nlohmann::json;

FileKey smallFile() {
  FileKey leg =
      tables("leg", "a part", {required(number("from_s", kNotNegative, "when")), flag("last", "the end")});
  leg.notInFirst = "from_s";
  FileKey file = table(
      "small file", "Carom small file",
      {required(text("name", "unique")),
       number("beta", {.least = 0.0, .most = 1.0, .above = true}, "speed", 0.5),
       number("span", kUnlimited, "any"), choice("kind", {"a", "b"}, "which", 1),
       numbers("corner", 3, {}, "where", {0.0, 1.5, 0.0}), ofSize(1, 4, ofLetters(9, texts("words", "some"))),
       points("outline_m", 2, "corners"), ofSize(1, kAnyNumber, leg)});
  file.rules = {{{.with = {"beta"}, .without = {}}, {.with = {}, .without = {"kind", "span"}}}};
  return file;
}

TEST(KeySchema, IsTheOneWrittenByHand) {
  const json expected = json::parse(R"({
    "$schema": "http://json-schema.org/draft-07/schema#", "title": "Carom small file",
    "type": "object", "additionalProperties": false, "required": ["name"],
    "properties": {
      "name": {"type": "string", "minLength": 1, "description": "unique"},
      "beta": {"type": "number", "exclusiveMinimum": 0.0, "maximum": 1.0, "description": "speed",
               "default": 0.5},
      "span": {"type": "number", "minimum": 0.0, "description": "any"},
      "kind": {"enum": ["a", "b"], "description": "which", "default": "b"},
      "corner": {"type": "array", "items": {"type": "number", "minimum": -1e9, "maximum": 1e9},
                 "minItems": 3, "maxItems": 3, "description": "where", "default": [0, 1.5, 0]},
      "words": {"type": "array", "items": {"type": "string", "minLength": 1, "maxLength": 9},
                "minItems": 1, "maxItems": 4, "description": "some"},
      "outline_m": {"type": "array", "description": "corners",
                    "items": {"type": "array", "items": {"type": "number", "minimum": -1e9, "maximum": 1e9},
                              "minItems": 2, "maxItems": 2}},
      "leg": {"type": "array", "minItems": 1, "description": "a part",
              "items": [{"type": "object", "additionalProperties": false,
                         "properties": {"last": {"type": "boolean", "description": "the end",
                                             "default": false}}}],
              "additionalItems": {"type": "object", "additionalProperties": false, "required": ["from_s"],
                                  "properties": {"from_s": {"type": "number", "minimum": 0.0, "maximum": 1e9,
                                                            "description": "when"},
                                                 "last": {"type": "boolean", "description": "the end",
                                                          "default": false}}}}
    },
    "allOf": [{"anyOf": [{"required": ["beta"]},
                         {"not": {"anyOf": [{"required": ["kind"]}, {"required": ["span"]}]}}]}]
  })");
  EXPECT_EQ(json::parse(schemaOf(smallFile())), expected) << schemaOf(smallFile());
}

TEST(KeySchema, APageHasARowForEachKey) {
  EXPECT_EQ(pageOf(smallFile()),
            "# Keys of a small file\n"
            "\n| key | value | left out | meaning |\n| --- | --- | --- | --- |\n"
            "| `name` | a text | required | unique |\n"
            "| `beta` | a number above 0 up to 1 (c) | `0.5` | speed |\n"
            "| `span` | a number from 0 |  | any |\n"
            "| `kind` | `\"a\"`, `\"b\"` | `\"b\"` | which |\n"
            "| `corner` | 3 numbers | `[0,1.5,0]` | where |\n"
            "| `words` | [1 to 4 texts] of at most 9 letters |  | some |\n"
            "| `outline_m` | [points of 2 numbers] (m) |  | corners |\n"
            "| `leg` | tables |  | a part |\n"
            "\n## [[leg]]\n\na part\n"
            "\n| key | value | left out | meaning |\n| --- | --- | --- | --- |\n"
            "| `from_s` | a number from 0 (s) | required | when |\n"
            "| `last` | `true` or `false` | `false` | the end |\n");
}

}  // namespace
}  // namespace carom
