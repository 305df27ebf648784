// Guessing passwords is slow (docs/safety.md).
#include "served/password_guard.h"

#include <gtest/gtest.h>

namespace merker::served {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const PasswordGuard::Time kFirstGuess{};

TEST(PasswordGuard, oneAfterTheOther) {
  PasswordGuard guard;
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess), milliseconds(0));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess), milliseconds(100));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess), milliseconds(200));
  EXPECT_EQ(guard.turn("10.0.0.2", kFirstGuess), milliseconds(0));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess + milliseconds(250)), milliseconds(50));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess + seconds(2)), milliseconds(0));
}

// Behind ten wrong ones the right one waits 1.1 s.
TEST(PasswordGuard, wrongOnesMakeTheNextOnesWait) {
  PasswordGuard guard;
  for (int i = 0; i < 10; ++i) guard.wrong("10.0.0.1", kFirstGuess + seconds(i));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess + seconds(10)), milliseconds(0));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess + seconds(10)), milliseconds(1'100));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess + seconds(65)), milliseconds(0));
  EXPECT_EQ(guard.turn("10.0.0.1", kFirstGuess + seconds(65)), milliseconds(500));
}

TEST(PasswordGuard, whatIsRememberedIsBounded) {
  PasswordGuard guard;
  int admitted = 0;
  while (guard.turn("10.0.0.1", kFirstGuess)) ++admitted;
  EXPECT_EQ(admitted, 301);  // 30 s
  for (std::size_t i = 1; i < PasswordGuard::kMostAddresses; ++i)
    guard.wrong(std::to_string(i), kFirstGuess);
  EXPECT_FALSE(guard.turn("new", kFirstGuess));
  EXPECT_TRUE(guard.turn("7", kFirstGuess));
  EXPECT_TRUE(guard.turn("new", kFirstGuess + seconds(60)));
}

}  // namespace
}  // namespace merker::served
