// The memory card of a CPU: a folder that holds load memory and what the CPU keeps without power
// (S7-MEM-02, S7-MEM-03). One process has it at a time. What is on it is always that of a whole
// cycle: each call that writes is one transaction.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "plc/retentive.h"
#include "store/load_memory.h"

namespace merker::store {

class MemoryCard {
 public:
  // Opens the card in this folder; a folder that is missing or holds no card becomes an empty one.
  // P1001 cannot be opened, P1002 foreign file, P1003 damaged, P1004 in use, P1005 newer format.
  // Beyond that nothing is written before the first download or save.
  static Result<MemoryCard> open(const std::string& folder);
  // One that has a program, else P1007; then nothing is made.
  static Result<MemoryCard> openLoaded(const std::string& folder);
  MemoryCard(MemoryCard&&) noexcept;
  MemoryCard& operator=(MemoryCard&&) noexcept;
  ~MemoryCard();

  bool empty() const;                    // no program on it
  const LoadMemory& loadMemory() const;  // as it was opened or downloaded
  // What the CPU kept; nothing if it was never switched on with this card.
  const std::optional<block::RetentiveData>& retentive() const;  // as it was opened

  // Blocks that differ are loaded, those that are no longer there deleted; data blocks among them
  // lose their actual values (S7-MEM-04). The card of another CPU model is cleared before. P1006
  // not writable, P1008 a block too long.
  Result<Download> download(LoadMemory wanted);
  // Only what changed since the last time. A failure (P1006) leaves the last cycle on the card.
  [[nodiscard]] std::optional<Problem> save(const block::RetentiveData& data);

 private:
  enum class Empty : bool { Allowed, Refused };
  static Result<MemoryCard> open(const std::string& folder, Empty empty);
  static Result<MemoryCard> openFile(const std::string& file, const Position& at, Empty empty);
  static std::optional<Problem> whyNotTheCopy(const std::string& file, const Position& at,
                                              Empty empty);
  struct Parts;
  explicit MemoryCard(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace merker::store
