// What a programmer (PG) can do with the PLC (S5-PG): variables, addresses, blocks, start and stop,
// the pictures of a STOP. What is refused gives the message as text; empty text is success.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "softplc/interrupt_stack.h"
#include "softplc/variable.h"

namespace merker::sinumerik {

// A line of the block directory ("Buchhalter").
struct DirectoryEntry {
  mc5::BlockId id;
  std::uint32_t address = 0;  // as displayed: words, with the offset of S5-MEM-07
  std::uint32_t words = 0;    // with the header; 0 for resident macros
  bool resident = false;
};

class Programmer {
 public:
  explicit Programmer(OperatingSystem& os) : os_(os) {}

  // STATUS VARIABLE, Steuern Variable. Blocks of the system take no values, but for the trigger
  // DW 9 of DB 1 (S5-DB-12, OP-03).
  std::optional<std::uint32_t> status(const Reference& variable) const;
  std::string control(const Reference& variable, std::uint32_t value);

  // Auskunft Adresse: words of the segment that the segment switch selects, and the pseudo
  // addresses E000 and F000 … F016 (S5-MEM-04, -05, S5-ERR-11).
  std::optional<std::uint16_t> address(std::uint16_t address) const;
  bool correctAddress(std::uint16_t address, std::uint16_t value);

  // Blocks. While the program runs they change between two cycles.
  std::string load(const mc5::Block& block);
  std::string erase(mc5::BlockId id);
  std::optional<mc5::Block> read(mc5::BlockId id) const;  // code or data as it is in memory
  std::vector<DirectoryEntry> directory() const;
  std::string compress();

  // AG-Start is a cold start, AG-Stop is alarm 6149.
  bool start() { return os_.start(Start::Cold); }
  void stop() { os_.stopByProgrammer(); }

  // Ausgabe USTACK and BSTACK, in STOP only (S5-ERR-06).
  std::optional<StopPicture> stopPicture() const;
  ControlBits controlBits() const { return os_.controlBits(); }
  std::string controlBitText() const;  // eight rows of names, NB for unused places

 private:
  bool resident(mc5::BlockId id) const;
  bool system(mc5::BlockId id) const;
  bool hasRoom(const mc5::Block& block) const;
  std::uint16_t pseudoAddress(unsigned index) const;

  OperatingSystem& os_;
};

}  // namespace merker::sinumerik
