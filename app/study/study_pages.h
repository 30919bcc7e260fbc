#pragma once
// The pages that a participant fills in on a phone or a tablet: plain forms, without a script.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/study/item_bank.h"
#include "app/study/study_progress.h"

namespace carom {

/// What each page of a participant carries.
struct StudyPageFrame {
  std::string token;  ///< of the participant; empty before the code was typed
  int step = 0;       ///< StudyStep
  std::size_t item = 0;
  std::string notice;  ///< what went wrong; may be empty
};

/// An answer as it stands in a form.
struct FormAnswer {
  std::string answer;
  int confidence = 0;
  std::string reason;
};

std::string codePage(const std::string& title, const std::string& notice);
/// `consent` is Markdown: paragraphs, headings, **strong** and *other* words.
std::string consentPage(const StudyPageFrame& frame, const std::string& consent);
std::string backgroundPage(const StudyPageFrame& frame, bool asksGender);
/// `place` of `count` items.
std::string itemPage(const StudyPageFrame& frame, const Item& item, std::size_t place, std::size_t count,
                     const FormAnswer& given, bool asksReason);
/// The page from which a test is handed in.
std::string handInPage(const StudyPageFrame& frame, std::size_t unanswered);
std::string ratingPage(const StudyPageFrame& frame, std::span<const RatingQuestion> questions);
/// Asks whether somebody stops who wants to, or offers it to somebody who feels unwell.
std::string stopPage(const StudyPageFrame& frame, bool isUnwell);
/// Asks whether to go on from a lesson that has not explained itself yet.
std::string onwardsPage(const StudyPageFrame& frame);
/// While the lessons run in the room; `isWaiting`: somebody else is in there.
std::string lessonPage(const StudyPageFrame& frame, std::size_t place, std::size_t count, bool isWaiting);
std::string endPage(const std::string& words);

/// Returns the style of these pages.
std::string studyStyle();

}  // namespace carom
