#include "app/page/page_file.h"

#include <fmt/format.h>

#include <stdexcept>

#include "app/page/page_bulk.h"
#include "app/page/page_content.h"
#include "app/page/still_picture.h"
#include "app/tables/html_text.h"
#include "cave/frame/bodies.h"
#include "cave/texts/texts.h"
#include "pages/controls_js.h"
#include "pages/data_js.h"
#include "pages/engine_js.h"
#include "pages/live_js.h"
#include "pages/observer_js.h"
#include "pages/picture_js.h"
#include "pages/play_js.h"
#include "pages/room_js.h"
#include "pages/start_js.h"
#include "pages/visit_css.h"
#include "pages/visit_html.h"
#ifdef CAROM_BROWSER
#include "pages/engine_b64.h"
#endif

namespace carom {
namespace {

std::string engineLetters() {
#ifdef CAROM_BROWSER
  return pages::engine_b64;
#else
  throw std::runtime_error(
      "this program was built without the engine for browsers, expected one that was configured and built "
      "after "
      "config/install-packages page had installed clang-19, lld-19, libc++-19-dev-wasm32, "
      "libc++abi-19-dev-wasm32, libclang-rt-19-dev-wasm32 and wasi-libc");
#endif
}

/// Returns the world lines of all bodies with all that the visit knows.
std::vector<WorldLine> linesOf(const Visit& visit) {
  std::vector<WorldLine> lines = visit.atStart;
  for (const VisitChange& change : visit.changes) {
    for (std::size_t puck = 0; puck < visit.scenario.billiard.pucks.size(); ++puck)
      if (change.cutFrom_s < std::numeric_limits<double>::infinity())
        lines[kFirstPuck + puck].truncateFrom(change.cutFrom_s);
    for (const BodyKnot& knot : change.knots) lines.at(knot.body).append(knot.knot);
  }
  return lines;
}

}  // namespace

bool canMakePages() {
#ifdef CAROM_BROWSER
  return true;
#else
  return false;
#endif
}

std::string pageOf(const Visit& visit, const Scene& scene) {
  const std::string engine = engineLetters(), content = lettersOf(pageContent(visit, scene));
  PageWords words{{"title", htmlOf(texts::other(visit.scenario.title))},
                  {"language", texts::languageCode()},
                  {"style", pages::visit_css},
                  {"reaches", visit.live ? "'self'" : "'none'"},
                  {"script", std::string("\"use strict\";\n(() => {\n") + pages::engine_js + pages::data_js +
                                 pages::room_js + pages::picture_js + pages::observer_js + pages::play_js +
                                 pages::live_js + pages::controls_js + pages::start_js + "})();\n"},
                  {"picture", stillPicture(visit, linesOf(visit))},
                  {"engine", engine},
                  {"engineLength", std::to_string(engine.size())},
                  {"visit", content},
                  {"visitLength", std::to_string(content.size())}};
  for (const auto& [name, text] : texts::pageWords("page")) words[name] = htmlOf(text);
  return filled(pages::visit_html, words);
}

}  // namespace carom
