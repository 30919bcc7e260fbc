#include "app/room_formats/room_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "app/cave_formats/cover_file.h"
#include "app/cave_formats/eqc_file.h"
#include "app/cave_formats/eqc_syntax.h"
#include "app/cave_formats/hevs_file.h"
#include "app/cave_formats/jconf_file.h"
#include "app/room_formats/blender_file.h"
#include "app/room_formats/mpcdi_file.h"
#include "app/room_formats/ndisplay_file.h"
#include "app/room_formats/sgct_nodes.h"
#include "app/room_formats/sgct_trackers.h"
#include "app/room_formats/sgct_xml.h"
#include "app/room_import/pvx_file.h"
#include "app/room_import/sgct_file.h"
#include "app/room_parts/part.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

enum class Syntax { xml, json, equalizer, cfg };

/// Returns the syntax of the line of a file that is the first one without a comment; nothing if it is none of
/// these.
std::optional<Syntax> syntaxOf(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF", kBlank = " \t\r\n";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  if (text.starts_with("#Equalizer")) return Syntax::equalizer;
  for (std::size_t at = text.find_first_not_of(kBlank); at != std::string_view::npos;
       at = text.find_first_not_of(kBlank, at)) {
    const std::string_view rest = text.substr(at);
    if (rest[0] == '<') return Syntax::xml;
    if (rest[0] == '{' || rest.starts_with("//") || rest.starts_with("/*")) return Syntax::json;
    for (const char* word : {"server", "global", "config"}) {
      const std::size_t brace = rest.find_first_not_of(" \t\r\n", std::string_view(word).size());
      if (rest.starts_with(word) && brace != std::string_view::npos &&
          (rest[brace] == '{' || rest[brace] == '#'))
        return Syntax::equalizer;
    }
    for (const char* word :
         {"[cluster_node]", "[screen]", "[viewport]", "[camera]", "[scene_node]", "[input]", "[stereo]",
          "[general]", "[info]", "[network]", "[debug]", "[custom]"}) {
      if (rest.starts_with(word)) return Syntax::cfg;
    }
    if (rest[0] != '#') return {};
    at = text.find('\n', at);
    if (at == std::string_view::npos) return {};
  }
  return {};
}

constexpr std::size_t kBeginning = 1U << 16U;

[[noreturn]] void refuse(const std::filesystem::path& file, FilePlace at, const std::string& found) {
  throw InputErrors(
      {InputError(file.string(), at.line, at.column, fmt::format("{}, expected {}", found, kForeignRooms))});
}

bool isOneOf(const std::string& name, std::initializer_list<std::string_view> names) {
  return std::any_of(names.begin(), names.end(), [&](std::string_view known) { return alike(name, known); });
}

Room readSgctWithTrackers(const std::filesystem::path& file, const JsonNode& root,
                          const std::string& wanted) {
  refuseRoomName(wanted, file);
  Room room = readSgct(file, root);
  addSgctNodes(root, room);
  addSgctTrackers(root, room);
  return room;
}

Room readXmlRoom(const std::filesystem::path& file, const std::string& wanted) {
  const XmlFile xml = readXml(file, Doctype::outside);
  const std::string& name = xml.root.name;
  if (name == "pvx") {
    refuseRoomName(wanted, file);
    return readPvx(file);
  }
  if (isOneOf(name, {"COCONFIG"})) return readCover(file, partOf(xml.root), wanted);
  if (isOneOf(name, {"Cluster"})) return readSgctWithTrackers(file, sgctFromXml(partOf(xml.root)), wanted);
  if (isOneOf(name, {"blender_cave", "virtualEnvironment", "blendervr"}))
    return readBlender(file, partOf(xml.root), xml.leftOut, wanted);
  if (isOneOf(name, {"configuration"})) return readJconf(file, partOf(xml.root), wanted);
  if (file.extension() == ".pvx") return readPvx(file);  // says what it misses
  refuse(file, xml.root.at, fmt::format("the first element is <{}>", printable(name)));
}

Room readJsonRoom(const std::filesystem::path& file, const std::string& wanted) {
  const JsonNode root = readJsonWithComments(file);
  if (root.member("platforms")) return readHevs(file, partOf(root), wanted);
  if (root.member("nDisplay")) {
    refuseRoomName(wanted, file);
    return readNdisplay(file, partOf(root));
  }
  const bool isSgct =
      root.kind != JsonNode::Kind::object ||
      std::any_of(root.children.begin(), root.children.end(), [](const JsonNode& member) {
        return isOneOf(member.key, {"nodes", "masteraddress", "users", "version", "trackers"});
      });
  if (isSgct || root.children.empty()) return readSgctWithTrackers(file, readJson(file), wanted);
  refuse(file, root.at, "this object has neither 'nodes', 'nDisplay' nor 'platforms'");
}

}  // namespace

bool isForeignRoom(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (isOneOf(ending, {".toml"})) return false;
  if (isMpcdi(file)) return true;
  if (isOneOf(ending, {".pvx", ".json", ".xml", ".jconf", ".eqc", ".ndisplay", ".cfg"})) return true;
  if (!refusalOf(file, InputKind::xml).empty()) return false;
  return syntaxOf(beginningOf(file, InputKind::xml, kBeginning)).has_value();
}

Room readForeignRoom(const std::filesystem::path& file, const std::string& room) {
  if (isMpcdi(file)) {
    refuseRoomName(room, file);
    return readMpcdi(file);
  }
  const bool isJson = file.extension() == ".json";
  const std::string text = readText(file, isJson ? InputKind::json : InputKind::xml);
  const auto syntax = syntaxOf(text);
  if (syntax == Syntax::xml && !isJson) return readXmlRoom(file, room);
  const bool isPvx = file.extension() == ".pvx";
  if (!isPvx && (syntax == Syntax::json || isJson)) return readJsonRoom(file, room);
  if (!isPvx && syntax == Syntax::equalizer) return readEqc(file, readEqcParts(file), room);
  refuseRoomName(room, file);
  if (isPvx) return readPvx(file);
  if (syntax == Syntax::cfg) return readNdisplayCfg(file, readCfgLines(file));
  refuse(file, {}, "this begins as no room of another program");
}

}  // namespace carom
