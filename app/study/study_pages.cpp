#include "app/study/study_pages.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "app/tables/html_text.h"

namespace carom {
namespace {

constexpr std::array<const char*, 4> kSure{"guess", "unsure", "fairly sure", "certain"};

std::string whole(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>{}</title><link rel=\"stylesheet\" "
      "href=\"/study.css\"></head><body><main>{}</main></body></html>\n",
      htmlOf(title), body);
}

std::string noticeOf(const std::string& words) {
  return words.empty() ? "" : fmt::format("<p class=\"notice\" role=\"alert\">{}</p>", htmlOf(words));
}

std::string hidden(const char* name, const std::string& value) {
  return fmt::format("<input type=\"hidden\" name=\"{}\" value=\"{}\">", name, htmlOf(value));
}

/// A button with `more`, formnovalidate, sends a form whose fields are empty.
std::string button(const char* go, const char* words, const char* kind = "", const char* more = "") {
  return fmt::format("<button name=\"go\" value=\"{}\" class=\"{}\"{}>{}</button>", go, kind, more, words);
}

/// Returns a page with one form. Everybody may stop on every page.
std::string formPage(const StudyPageFrame& frame, const std::string& title, const std::string& body,
                     const std::string& buttons, bool mayStop = true) {
  return whole(title, fmt::format("<h1>{}</h1>{}<form method=\"post\" action=\"/study\" "
                                  "autocomplete=\"off\">{}{}{}{}<p class=\"go\">{}{}</p></form>",
                                  htmlOf(title), noticeOf(frame.notice), hidden("token", frame.token),
                                  hidden("step", std::to_string(frame.step)),
                                  hidden("item", std::to_string(frame.item)), body, buttons,
                                  mayStop ? button("stop", "I want to stop", "quiet") : ""));
}

std::string radio(const char* name, const std::string& value, const std::string& words, bool isChosen) {
  return fmt::format("<label><input type=\"radio\" name=\"{}\" value=\"{}\"{}> {}</label>", name,
                     htmlOf(value), isChosen ? " checked" : "", htmlOf(words));
}

std::string fieldset(const std::string& legend, const std::string& body, const char* kind = "") {
  return fmt::format("<fieldset class=\"{}\"><legend>{}</legend>{}</fieldset>", kind, htmlOf(legend), body);
}

std::string checkBox(const char* name, const char* words) {
  return fmt::format("<label><input type=\"checkbox\" name=\"{}\" value=\"yes\"> {}</label>", name, words);
}

/// Returns how a page says a band of the questions about the person.
std::string bandWords(std::string band) {
  if (band.ends_with('-')) return band.replace(band.size() - 1, 1, " or more");
  if (band.starts_with("under-")) return band.replace(5, 1, " ");
  if (band == "none") return "nothing";
  if (band == "read") return "I have read about it";
  if (band == "course") return "I have had a course";
  return band;
}

/// Returns the words of one paragraph of Markdown as HTML.
std::string inlineHtml(const std::string& words) {
  static const std::regex strong(R"(\*\*([^*]+)\*\*)"), em(R"(\*([^*]+)\*)");
  return std::regex_replace(std::regex_replace(htmlOf(words), strong, "<strong>$1</strong>"), em,
                            "<em>$1</em>");
}

std::string markdownHtml(const std::string& text) {
  std::string html, paragraph;
  const auto end = [&] {
    if (!paragraph.empty()) html += "<p>" + inlineHtml(paragraph) + "</p>";
    paragraph.clear();
  };
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t level = line.find_first_not_of('#');
    if (line.empty() || (level != std::string::npos && level > 0)) end();
    if (line.empty()) continue;
    if (level != std::string::npos && level > 0)
      html += "<h2>" + inlineHtml(line.substr(line.find_first_not_of("# "))) + "</h2>";
    else
      paragraph += (paragraph.empty() ? "" : " ") + line;
  }
  end();
  return html;
}

}  // namespace

std::string codePage(const std::string& title, const std::string& notice) {
  return whole(
      title,
      fmt::format("<h1>{}</h1>{}<form method=\"post\" action=\"/study\" autocomplete=\"off\"><p><label "
                  "for=\"code\">The code of your slip</label><input id=\"code\" name=\"code\" "
                  "maxlength=\"12\" autocapitalize=\"characters\" spellcheck=\"false\" "
                  "required></p><p class=\"go\">{}</p></form>",
                  htmlOf(title), noticeOf(notice),
                  button("code", "Go on", "main") +
                      button("called", "My code was typed for me", "", " formnovalidate")));
}

std::string consentPage(const StudyPageFrame& frame, const std::string& consent) {
  const std::string boxes =
      checkBox("part", "I have read this and take part.") +
      checkBox("paths", "The path of my head and hand may be handed on to other researchers (if you like).") +
      checkBox("publish", "My answers may be published without my name (if you like).") +
      checkBox("guardian", "I am under age, and my guardian's consent is here on paper.");
  return formPage(frame, "Before you begin", markdownHtml(consent) + fieldset("Your consent", boxes),
                  button("next", "Go on", "main"));
}

std::string backgroundPage(const StudyPageFrame& frame, bool asksGender) {
  std::string body;
  for (const BackgroundQuestion& question : kBackground) {
    if (std::string_view(question.id) == "gender" && !asksGender) continue;
    std::string bands;
    for (const char* band : question.bands) {
      if (band) bands += radio(question.id, band, bandWords(band), false);
    }
    if (bands.empty())
      bands = fmt::format("<input name=\"{0}\" aria-label=\"{1}\" maxlength=\"40\">", question.id,
                          htmlOf(question.words));
    body += fieldset(question.words, bands);
  }
  return formPage(frame, "About you", "<p>You may leave out what you like.</p>" + body,
                  button("next", "Go on", "main"));
}

std::string itemPage(const StudyPageFrame& frame, const Item& item, std::size_t place, std::size_t count,
                     const FormAnswer& given, bool asksReason) {
  std::string answers, sure;
  for (const ItemAnswer& answer : item.answers)
    answers += radio("answer", answer.id, answer.text, given.answer == answer.id);
  answers += radio("answer", kDontKnow, "I do not know", given.answer == kDontKnow);
  for (std::size_t i = 0; i < kSure.size(); ++i)
    sure += radio("confidence", std::to_string(i + 1), kSure[i], given.confidence == static_cast<int>(i) + 1);
  std::string body = fieldset(item.question, answers) + fieldset("How sure are you?", sure, "row");
  if (asksReason)
    body += fmt::format(
        "<p><label for=\"reason\">Why? (You may leave this out.)</label><textarea id=\"reason\" "
        "name=\"reason\" maxlength=\"200\" rows=\"3\">{}</textarea></p>",
        htmlOf(given.reason));
  return formPage(frame, fmt::format("Question {} of {}", place + 1, count), body,
                  button("next", "Next", "main") + (place > 0 ? button("back", "Back") : ""));
}

std::string handInPage(const StudyPageFrame& frame, std::size_t unanswered) {
  const std::string words = unanswered == 0
                                ? "<p>You have answered all questions.</p>"
                                : fmt::format("<p>{} of the questions have no answer yet.</p>", unanswered);
  return formPage(frame, "Hand in", words + "<p>Afterwards you can change nothing more.</p>",
                  button("next", "Hand in", "main") + button("back", "Back to the questions"));
}

std::string ratingPage(const StudyPageFrame& frame, std::span<const RatingQuestion> questions) {
  std::string body;
  for (const RatingQuestion& question : questions) {
    std::string scale = fmt::format("<span>{}</span>", question.least);
    for (int value = 0; value <= 10; ++value)
      scale += radio(question.id, std::to_string(value), std::to_string(value), false);
    body += fieldset(question.words, scale + fmt::format("<span>{}</span>", question.most), "row");
  }
  return formPage(frame, "How are you?", body, button("rate", "Go on", "main"));
}

std::string stopPage(const StudyPageFrame& frame, bool isUnwell) {
  const char* words =
      isUnwell ? "You feel unwell. It is all right to stop now; sit down, and tell the person who leads."
               : "Afterwards you cannot go on with this code. What you answered so far is kept, but left out "
                 "of the analysis; with the code of your slip you can have it deleted.";
  return formPage(frame, "Do you want to stop?", fmt::format("<p>{}</p>", words),
                  button("stop-now", "Stop now", "main") + button("stay", "I want to go on"), false);
}

std::string onwardsPage(const StudyPageFrame& frame) {
  return formPage(frame, "Go on all the same?", "<p>The lesson has not explained itself yet.</p>",
                  button("stay", "Back to the lesson", "main") + button("anyway", "Go on all the same"));
}

std::string lessonPage(const StudyPageFrame& frame, std::size_t place, std::size_t count, bool isWaiting) {
  if (isWaiting)
    return formPage(frame, "Please wait", "<p>The room is not ready for you yet.</p>",
                    button("next", "Try again", "main"));
  return formPage(frame, fmt::format("Lesson {} of {}", place + 1, count),
                  "<p>This lesson runs in the room: go in and follow it there. Come back here when it has "
                  "explained itself.</p>",
                  button("next", place + 1 == count ? "The lessons are over" : "The next lesson", "main"));
}

std::string endPage(const std::string& words) {
  return whole("Thank you",
               fmt::format("<h1>Thank you</h1><p>{}</p><p>Keep your slip: with its code you can "
                           "have your data deleted.</p><p class=\"go\"><a href=\"/study\">The next "
                           "code</a></p>",
                           htmlOf(words)));
}

std::string studyStyle() {
  return "*{box-sizing:border-box}body{margin:0;font:18px/1.5 sans-serif;color:#1b1b1b;background:#fff}\n"
         "main{max-width:40em;margin:0 auto;padding:1em}h1{font-size:1.3em}h2{font-size:1.1em}\n"
         "fieldset{border:1px solid #888;border-radius:6px;margin:1em 0;padding:.5em .8em}\n"
         "legend{font-weight:bold;padding:0;float:left;width:100%}label{display:block;"
         "padding:.45em 0;min-height:44px}\n"
         ".row label{display:inline-block;margin-right:.9em}.row span{color:#444;margin-right:.9em}\n"
         "input[type=radio],input[type=checkbox]{width:22px;height:22px;vertical-align:-4px}\n"
         "#code{font:bold 1.5em monospace;text-transform:uppercase;width:8em;display:block;padding:.3em}\n"
         "textarea,input:not([type]){width:100%;font:inherit;padding:.4em}\n"
         "button,a{font:inherit;min-height:44px;padding:.5em 1.2em;margin:.3em .5em .3em 0;border:1px solid "
         "#555;border-radius:6px;background:#f2f2f2;color:#1b1b1b}\n"
         ".main{background:#15497f;border-color:#15497f;color:#fff}.quiet{float:right}\n"
         ":focus-visible{outline:3px solid #c2571a;outline-offset:2px}\n"
         ".notice{background:#fff0c2;border-left:5px solid #a86f00;padding:.5em 1em}\n"
         "@media(prefers-color-scheme:dark){body{background:#161616;color:#eee}button,a{background:#333;"
         "color:#eee}.main{background:#8ab8ec;color:#111}.row span{color:#bbb}.notice{color:#222}}\n";
}

}  // namespace carom
