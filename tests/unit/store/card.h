// A folder of its own for each test, and something to put on a card.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "store/memory_card.h"

namespace merker::store::test {

class CardTest : public testing::Test {
 protected:
  CardTest()
      : folder_((std::filesystem::temp_directory_path() /
                 ("merker-card-" + std::to_string(::getpid()) + "-" +
                  testing::UnitTest::GetInstance()->current_test_info()->name()))
                    .string()) {
    std::filesystem::remove_all(folder_);
  }
  ~CardTest() override { std::filesystem::remove_all(folder_); }

  std::string file() const { return folder_ + "/card.sqlite"; }
  ProblemCode refusal() const {
    const auto card = MemoryCard::open(folder_);
    EXPECT_FALSE(card);
    return card ? ProblemCode::P0101 : card.error().code;
  }

  std::string folder_;
};

block::Block functionBlock(std::uint16_t number, std::uint8_t constant);
block::Block dataBlock(std::uint16_t number, std::size_t bytes, std::uint8_t value);
// FC 1, DB 1 (600 bytes of 1), DB 2 (10 bytes of 2).
LoadMemory loadMemory();
// Every kind of thing that is kept; values depend on `seed`.
block::RetentiveData retentiveData(std::uint8_t seed);
// As it comes back: eventsAdded is not kept.
block::RetentiveData withoutCount(block::RetentiveData data);

}  // namespace merker::store::test
