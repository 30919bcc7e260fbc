#include "app/file_keys/playlist_keys.h"

#include "app/file_keys/common_keys.h"

namespace carom {

const FileKey& playlistKeys() {
  using namespace declare;
  constexpr std::size_t kMostGames = 100, kNoteLetters = 400;
  constexpr Range kFor_s{.least = 5.0, .most = 86400.0};
  static const FileKey keys = table(
      "playlist", "Carom playlist",
      {text("title", "for people"),
       languagesKey("in the place of the rig's: those through which a tile on the front wall and key F9 go"),
       required(ofSize(
           1, kMostGames,
           tables(
               "game", "the games that may be played, in their order; a session begins with the first",
               {required(text("scenario",
                              "a name that carom list tells, or a file, looked for beside the playlist")),
                number("for_s", kFor_s,
                       "after so many seconds the next game begins; left out: when somebody chooses one"),
                flag("attract", "played by itself, in turn, while nobody is there (--unattended)"),
                ofLetters(kNoteLetters,
                          text("note", "what the console shows to the person who leads the visitors"))})))});
  return keys;
}

}  // namespace carom
