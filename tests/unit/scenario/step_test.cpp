// What makes a type a step or an expectation: one that lacks a part does not compile in the list.
#include "scenario/step.h"

#include <gtest/gtest.h>

#include "scenario/step_words.h"

namespace merker::simulator {
namespace {

struct Whole {
  static constexpr std::string_view kWords = "x";
  bool parse(const StepLine&) { return true; }
  void resolve(const StepBinding&) {}
  bool perform(StepRun&) const { return true; }
};
struct NotParsed {
  static constexpr std::string_view kWords = "x";
  void resolve(const StepBinding&) {}
  bool perform(StepRun&) const { return true; }
};
struct NotResolved {
  static constexpr std::string_view kWords = "x";
  bool parse(const StepLine&) { return true; }
  bool perform(StepRun&) const { return true; }
};
struct NotPerformed : steps::Bare {
  static constexpr std::string_view kWords = "x";
};
struct PerformedWithoutResult : steps::Bare {
  static constexpr std::string_view kWords = "x";
  void perform(StepRun&) const {}
};

struct WithoutWords : steps::Bare {
  bool perform(StepRun&) const { return true; }
};

static_assert(IsStep<Whole>);
static_assert(!IsStep<WithoutWords>);
static_assert(!IsStep<NotParsed>);
static_assert(!IsStep<NotResolved>);
static_assert(!IsStep<NotPerformed>);
static_assert(!IsStep<PerformedWithoutResult>);

struct Silent : expectations::Mode {
  void actual() const {}
};
struct Undecided {
  bool parse(const StepLine&, const Claim&) { return true; }
  void resolve(const StepBinding&) {}
  bool holds(controller::Controller&) const { return true; }
  std::string actual(controller::Controller&) const { return {}; }
};

static_assert(IsExpectation<expectations::Mode>);
static_assert(!IsExpectation<Silent>);     // it cannot say what is there instead
static_assert(!IsExpectation<Undecided>);  // may the scenario end in STOP?

TEST(StepWords, LongerWordsComeFirst) {
  std::string_view line = "power on unbuffered";
  const StepWord* const word = takeStepWord(line);
  ASSERT_NE(word, nullptr);
  EXPECT_EQ(word->words, "power on unbuffered");
  EXPECT_EQ(line, "");
}

TEST(StepWords, TheListForProblemsNamesThemAll) {
  const std::string list = stepWords();
  for (const char* word : {"set, ", "copy RAM to ROM, ", "encoder, ", "repeat, end"})
    EXPECT_NE(list.find(word), std::string::npos) << word;
  EXPECT_EQ(list.find("scenario"), std::string::npos);
}

}  // namespace
}  // namespace merker::simulator
