#include "devices/protocol/qtm_bodies.h"

#include <expat.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t kMostBodies = 4096, kLongestBodyName = 100;
constexpr int kDeepest = 64;

/// Takes blanks off both ends.
void trim(std::string& text) {
  constexpr const char* kBlanks = " \t\r\n";
  text.erase(0, std::min(text.find_first_not_of(kBlanks), text.size()));
  text.erase(text.find_last_not_of(kBlanks) + 1);
}

/// What the parser has come across. A body's name is an element right within it.
class Names {
 public:
  explicit Names(XML_Parser parser) : parser_(parser) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser, [](void* self, const char* name, const char**) { static_cast<Names*>(self)->begin(name); },
        [](void* self, const char*) { static_cast<Names*>(self)->end(); });
    XML_SetCharacterDataHandler(parser, [](void* self, const char* text, int length) {
      static_cast<Names*>(self)->add({text, static_cast<std::size_t>(length)});
    });
    XML_SetStartDoctypeDeclHandler(parser, [](void* self, const char*, const char*, const char*, int) {
      static_cast<Names*>(self)->stop();
    });
  }

  std::vector<std::string> names;

 private:
  void begin(std::string_view element) {
    if (++depth_ > kDeepest || names.size() > kMostBodies) return stop();
    if (bodyDepth_ == 0 && element == "Body") {
      bodyDepth_ = depth_;
      names.emplace_back();
    }
    inName_ = bodyDepth_ > 0 && depth_ == bodyDepth_ + 1 && element == "Name";
  }
  void end() {
    if (inName_) trim(names.back());
    if (depth_ == bodyDepth_) bodyDepth_ = 0;
    inName_ = false;
    --depth_;
  }
  void add(std::string_view text) {
    if (inName_) names.back() += text.substr(0, kLongestBodyName - names.back().size());
  }
  void stop() { XML_StopParser(parser_, XML_FALSE); }

  XML_Parser parser_;
  int depth_ = 0, bodyDepth_ = 0;
  bool inName_ = false;
};

}  // namespace

std::optional<std::vector<std::string>> readQtmBodies(std::string_view xml) {
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), &XML_ParserFree);
  Names names(parser.get());
  const int size = static_cast<int>(xml.size());
  if (XML_Parse(parser.get(), xml.data(), size, XML_TRUE) != XML_STATUS_OK) return {};
  return std::move(names.names);
}

}  // namespace carom
