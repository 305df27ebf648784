// The memory card of `merker run --card`: where the program comes from or goes to, and where the
// CPU finds and leaves what it keeps without power.
#pragma once

#include "build.h"
#include "cpu/ram_to_rom.h"
#include "store/memory_card.h"

namespace merker::app {

// P1003 if no CPU has such a card, else as MemoryCard::open or, without a program from elsewhere,
// openLoaded.
Result<store::MemoryCard> openCard(const std::string& folder, bool needsProgram);

// The program, CPU and configuration on the card, as if they were a project. P1003 if its blocks
// are none of this CPU.
Build buildFromCard(const store::MemoryCard& card, const std::string& folder,
                    const std::string& cpu);

// Puts the program on the card and switches the PLC on with what is kept there: after a power
// failure in RUN an automatic warm restart, otherwise (STOP, a changed program) a manual one; a new
// card begins with a memory reset.
std::optional<Problem> switchOn(store::MemoryCard& card, const Build& build,
                                controller::Controller& plc);

// Stops the CPU and writes the actual values of its data blocks into the blocks on the card
// (S7-MEM-04).
std::optional<Problem> copyRamToRom(store::MemoryCard& card, const Build& build,
                                    controller::Controller& plc, cpu::RamToRom& memory);

// Keeps the retentive memory on the card. Once a save fails nothing more is saved.
class CardKeeper {
 public:
  explicit CardKeeper(store::MemoryCard& card) : card_(card) {}
  bool save(controller::Controller& plc);  // false: it failed now or before
  // What programming devices load, delete or copy goes into load memory (S7-MEM-03): the card.
  bool saveProgram(controller::Controller& plc);
  const std::optional<Problem>& problem() const { return problem_; }

 private:
  store::MemoryCard& card_;
  std::shared_ptr<const block::Program> program_;  // that is on it; nothing: nobody has looked
  std::optional<Problem> problem_;
};

}  // namespace merker::app
