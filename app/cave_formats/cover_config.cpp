#include "app/cave_formats/cover_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

#include "app/room_checks/foreign_room.h"

namespace carom {
namespace {

constexpr std::size_t kMostWork = 5'000'000;  // parts looked at while sections are merged
constexpr std::size_t kMostHosts = 512;

/// Returns the computers of a list such as "a,b".
std::vector<std::string> hostsOf(const std::string& list) {
  std::vector<std::string> hosts;
  constexpr std::string_view kBetween = ", \t\r\n";
  std::size_t end = 0;
  for (std::size_t begin = list.find_first_not_of(kBetween); begin != std::string::npos;
       begin = list.find_first_not_of(kBetween, end)) {
    end = std::min(list.find_first_of(kBetween, begin), list.size());
    hosts.push_back(list.substr(begin, end - begin));
  }
  return hosts;
}

bool contains(const std::vector<std::string>& hosts, const std::string& host) {
  return std::find(hosts.begin(), hosts.end(), host) != hosts.end();
}

/// The part of a section that says something of rooms; newer files call it VIVE.
bool isCover(const Part& part) { return alike(part.name, "COVER") || alike(part.name, "VIVE"); }

/// The elements of it that do; the rest is about plug-ins and drawing.
constexpr std::array<std::string_view, 17> kOfRoom{
    "ScreenConfig", "ChannelConfig", "ViewportConfig", "WindowConfig", "PipeConfig",           "NumScreens",
    "Input",        "MultiPC",       "Stereo",         "FloorHeight",  "ViewerPosition",       "NumWindows",
    "PBOConfig",    "StereoMode",    "MonoView",       "HMD",          "BlendingTextureConfig"};

bool isOfRoom(const Part& part) {
  return std::any_of(kOfRoom.begin(), kOfRoom.end(),
                     [&](std::string_view name) { return alike(part.name, name); });
}

/// Warns of a part of a section whose name is nearly one of a room's: the others are none of its business.
void tellMistyped(const Part& part, Room& room) {
  const std::vector<std::string> known(kOfRoom.begin(), kOfRoom.end());
  const auto nearest = room.findings.isLong() ? std::nullopt : nearestWord(part.name, known);
  if (nearest)
    addWarning(room, part.at,
               fmt::format("'{}' is left out, expected '{}'?", printable(part.name), *nearest));
}

/// What makes two parts the same: their name and, of elements, the attribute `name`.
std::pair<std::string, std::string> keyOf(const Part& part) {
  std::string low = part.name;
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Part& child : part.parts) {
    if (alike(child.name, "name") && child.parts.empty()) return {low, child.text};
  }
  return {low, ""};
}

}  // namespace

CoverSections::CoverSections(const Part& root, Room& room) : room_(room) {
  for (const Part& part : root.parts) {
    CoverSection section{CoverSection::Kind::global, {}, &part};
    if (alike(part.name, "CLUSTER")) {
      section.kind = CoverSection::Kind::cluster;
      section.hosts = hostsOf(part.textOf("MASTER"));
      for (const std::string& master : section.hosts) {
        if (!contains(masters_, master) && masters_.size() < kMostHosts) masters_.push_back(master);
      }
    } else if (alike(part.name, "LOCAL")) {
      section.kind = CoverSection::Kind::local;
      section.hosts = hostsOf(part.textOf("HOST"));
      for (const std::string& host : section.hosts) {
        if (!contains(hosts_, host) && hosts_.size() < kMostHosts) hosts_.push_back(host);
      }
    } else if (!alike(part.name, "GLOBAL")) {
      if (!part.parts.empty())
        addWarning(room_, part.at,
                   fmt::format("'{}' is left out, expected GLOBAL, CLUSTER, LOCAL or INCLUDE",
                               printable(part.name)));
      continue;
    }
    if (section.kind != CoverSection::Kind::global && section.hosts.empty())
      addWarning(room_, part.at,
                 fmt::format("this section names no computer and is left out, expected {}=\"NAME\"",
                             section.kind == CoverSection::Kind::local ? "HOST" : "MASTER"));
    for (const Part& cover : part.parts) {
      if (!isCover(cover)) continue;
      for (const Part& each : cover.parts) {
        if (!isOfRoom(each)) tellMistyped(each, room_);
      }
    }
    sections_.push_back(std::move(section));
  }
}

FilePlace CoverSections::placeOfMaster(const std::string& master) const {
  for (const CoverSection& section : sections_) {
    if (section.kind == CoverSection::Kind::cluster && contains(section.hosts, master))
      return section.part->at;
  }
  return {};
}

Part CoverSections::configOf(const std::string& host, const std::string& master) {
  Part whole{"COVER", {}, {}, {}};
  for (const auto kind :
       {CoverSection::Kind::global, CoverSection::Kind::cluster, CoverSection::Kind::local}) {
    for (const CoverSection& section : sections_) {
      ++work_;
      if (section.kind != kind) continue;
      if (kind == CoverSection::Kind::cluster && !master.empty() && !contains(section.hosts, master))
        continue;
      if (kind == CoverSection::Kind::local && !contains(section.hosts, host)) continue;
      for (const Part& cover : section.part->parts) {
        if (!isCover(cover)) continue;
        Part ofRoom{cover.name, {}, cover.at, cover.textAt};
        for (const Part& part : cover.parts) {
          if (isOfRoom(part)) ofRoom.parts.push_back(part);
        }
        whole.at = cover.at;
        merge(whole, ofRoom);
      }
    }
  }
  return whole;
}

void CoverSections::merge(Part& whole, const Part& section) {
  work_ += whole.parts.size() + section.parts.size() + 1;
  if (work_ > kMostWork) {
    if (!isRefused_) addError(room_, section.at, "there are too many sections to be merged, expected fewer");
    isRefused_ = true;
    return;
  }
  std::vector<const Part*> screens;
  for (const Part& part : section.parts) {
    if (alike(part.name, "Screen") && !part.parts.empty()) screens.push_back(&part);
  }
  refuseTwins(screens, "name", room_);
  std::map<std::pair<std::string, std::string>, std::size_t> index;
  for (std::size_t i = 0; i < whole.parts.size(); ++i) index[keyOf(whole.parts[i])] = i;
  for (const Part& part : section.parts) {
    const auto [known, isNew] = index.emplace(keyOf(part), whole.parts.size());
    if (isNew) {
      whole.parts.push_back({part.name, part.text, part.at, part.textAt});
    } else {
      whole.parts[known->second].text = part.text;
      whole.parts[known->second].at = part.at;
      whole.parts[known->second].textAt = part.textAt;
    }
    if (!part.parts.empty()) merge(whole.parts[known->second], part);
  }
}

}  // namespace carom
