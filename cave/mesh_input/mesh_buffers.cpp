#include "cave/mesh_input/mesh_buffers.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "engine/text/input_error.h"
#include "engine/text/outside_file.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

constexpr std::size_t kDeepest = 64;

bool isGltf(const std::filesystem::path& mesh) {
  std::string ending = mesh.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".gltf" || ending == ".glb";
}

/// Returns the JSON of a glTF; in a .glb it is the first chunk (glTF 2.0, section 4.4: after a header of 12
/// bytes come its length, its type and its content).
std::string_view jsonOf(std::string_view content) {
  constexpr std::size_t kLengthAt = 12, kJsonAt = 20;
  if (!content.starts_with("glTF")) return content;
  if (content.size() < kJsonAt) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, content.data() + kLengthAt, sizeof length);
  return content.substr(kJsonAt, length);
}

/// Collects the texts buffers[…].uri and images[…].uri without keeping anything else of the file.
class UriCollector : public nlohmann::json_sax<nlohmann::json> {
 public:
  std::vector<std::string> uris;
  bool isTooDeep = false;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool string(string_t& text) override {
    constexpr std::size_t kOfPart = 3;  // of the object in the array in the root
    if (depth_ == kOfPart && isInParts_ && isUri_ && !text.starts_with("data:")) uris.push_back(text);
    return true;
  }
  bool key(string_t& name) override {
    if (depth_ == 1) isInParts_ = name == "buffers" || name == "images";
    isUri_ = name == "uri";
    return true;
  }
  bool start_object(std::size_t) override { return enter(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;  // its reader tells where
  }

 private:
  bool enter() {
    isTooDeep = ++depth_ > kDeepest;
    return !isTooDeep;
  }
  bool leave() {
    --depth_;
    return true;
  }

  std::size_t depth_ = 0;
  bool isInParts_ = false, isUri_ = false;
};

UriCollector urisIn(const std::filesystem::path& mesh, std::string_view content) {
  UriCollector collector;
  if (isGltf(mesh)) nlohmann::json::sax_parse(jsonOf(content), &collector);
  return collector;
}

}  // namespace

std::vector<std::filesystem::path> meshParts(const std::filesystem::path& mesh, std::string_view content) {
  std::vector<std::filesystem::path> files;
  for (const std::string& uri : urisIn(mesh, content).uris) files.push_back(mesh.parent_path() / uri);
  return files;
}

void checkMeshParts(const std::filesystem::path& mesh, std::string_view content) {
  const UriCollector found = urisIn(mesh, content);
  const auto refuse = [&](const std::string& why) { throw InputError(mesh.string(), 1, 1, why); };
  if (found.isTooDeep) refuse(fmt::format("values are nested too deep, expected at most {}", kDeepest));
  const std::filesystem::path folder = mesh.parent_path();
  for (const std::string& uri : found.uris) {
    const std::filesystem::path part = folder / uri;
    std::error_code failed;
    const std::string name = printable(uri.substr(0, 200));
    if (std::filesystem::exists(part, failed) && !liesBelow(part, folder)) {
      refuse(fmt::format("it names '{}', which is {}, expected files below this folder", name,
                         outsideWords(part, folder)));
    }
    if (const std::string refusal = refusalOf(part, InputKind::meshPart); !refusal.empty())
      refuse(fmt::format("it names '{}': {}", name, refusal));
  }
}

}  // namespace carom
