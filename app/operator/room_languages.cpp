#include "app/operator/room_languages.h"

namespace carom {

SessionLanguages languagesOf(const Rig& rig, const Playlist* playlist, const std::string& option) {
  const std::vector<std::string>& named =
      playlist && !playlist->languages.empty() ? playlist->languages : rig.languages;
  SessionLanguages languages{named, {}};
  const std::string usual = !rig.language.empty() ? rig.language : named.empty() ? kEnglish : named.front();
  for (std::size_t viewer = 0; viewer < rig.viewers.size(); ++viewer) {
    const std::string& own = rig.viewers[viewer].language;
    languages.atStart[viewer] = numberOf(languages, !option.empty() ? option : !own.empty() ? own : usual);
  }
  languages.hasTile = !named.empty() && languages.all.size() > 1;
  return languages;
}

}  // namespace carom
