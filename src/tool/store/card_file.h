// Whether a file may be opened as a memory card, seen from outside: what it is for the operating
// system, its length, its first bytes. Somebody else's file is not even touched.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/problem.h"

namespace merker::store {

// In the header of the database: "MRKC", and the version of docs/formats/card.md.
constexpr std::uint32_t kApplicationId = 0x4D524B43;
constexpr std::int64_t kFormat = 2, kOldestFormat = 1;

// Bytes of the database and of its log: many times what the largest CPU holds.
constexpr std::uintmax_t kLargestCard = 64 * 1024 * 1024;

// Why not (P1002 foreign, P1003 damaged); nothing if it may, or if there is no such file yet.
std::optional<Problem> whyNoCard(const std::string& file, const Position& at);

// A journal lies beside a card only if its creation was cut off. SQLite would bring an older state
// back before anything can be looked at.
bool hasJournal(const std::string& file);

// SQLite makes an empty log beside a card that it only looks at. One that was not there goes again.
class NewLog {
 public:
  explicit NewLog(const std::string& file);
  NewLog(const NewLog&) = delete;
  NewLog& operator=(const NewLog&) = delete;
  ~NewLog();
  void keep() { isNew_ = false; }

 private:
  std::string log_;
  bool isNew_;
};

}  // namespace merker::store
