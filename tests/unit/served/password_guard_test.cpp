// Guessing passwords is slow (docs/safety.md).
#include "served/password_guard.h"

#include <gtest/gtest.h>

namespace merker::served {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const PasswordGuard::Time kFirstGuess{};

TEST(PasswordGuard, eachAnswerIsLater) {
  PasswordGuard guard;
  EXPECT_EQ(guard.wrong("10.0.0.1", kFirstGuess), milliseconds(100));
  EXPECT_EQ(guard.wrong("10.0.0.1", kFirstGuess + seconds(1)), milliseconds(200));
  EXPECT_EQ(guard.wrong("10.0.0.2", kFirstGuess + seconds(1)), milliseconds(100));
  EXPECT_EQ(guard.wrong("10.0.0.1", kFirstGuess + seconds(61)), milliseconds(100));
}

TEST(PasswordGuard, tenWithinAMinute) {
  PasswordGuard guard;
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(guard.mayTry("10.0.0.1", kFirstGuess + seconds(i)));
    guard.wrong("10.0.0.1", kFirstGuess + seconds(i));
  }
  EXPECT_FALSE(guard.mayTry("10.0.0.1", kFirstGuess + seconds(59)));
  EXPECT_TRUE(guard.mayTry("10.0.0.2", kFirstGuess + seconds(59)));
  EXPECT_TRUE(guard.mayTry("10.0.0.1", kFirstGuess + seconds(60)));
}

TEST(PasswordGuard, addressesAreBounded) {
  PasswordGuard guard;
  for (std::size_t i = 0; i < PasswordGuard::kMostAddresses; ++i)
    guard.wrong(std::to_string(i), kFirstGuess);
  EXPECT_FALSE(guard.mayTry("new", kFirstGuess));
  EXPECT_TRUE(guard.mayTry("7", kFirstGuess));
  EXPECT_TRUE(guard.mayTry("new", kFirstGuess + seconds(60)));
}

}  // namespace
}  // namespace merker::served
