// Cause and remedy of the events of S7-DIAG-02 and S7-DIAG-03, in the words of a help page.
#include "monitor/diagnostic_list.h"

namespace merker::monitor {
namespace {

struct Row {
  std::uint16_t event;
  std::string_view help;
};

constexpr Row kRows[] = {
    {0x2521, "AKKU 1 holds no BCD number. Check the value before BTI, BTD, a timer or a counter."},
    {0x2522,
     "The operand read lies beyond the end of its area or data block. Check address, "
     "pointer and length."},
    {0x2523,
     "The operand written lies beyond the end of its area or data block. Check address, "
     "pointer and length."},
    {0x2524, "The pointer read through names no operand area. Check bits 31..24 of the pointer."},
    {0x2525,
     "The pointer written through names no operand area. Check bits 31..24 of the pointer."},
    {0x2526, "The CPU has no timer of this number."},
    {0x2527, "The CPU has no counter of this number."},
    {0x2528,
     "A byte, word or double word was read at a bit address other than 0. Check the "
     "pointer."},
    {0x2529,
     "A byte, word or double word was written at a bit address other than 0. Check the "
     "pointer."},
    {0x2530, "The data block is write-protected."},
    {0x2531, "The instance data block is write-protected."},
    {0x2532, "The number is too high for a data block."},
    {0x2533, "The number is too high for an instance data block."},
    {0x2534, "The number is too high for an FC."},
    {0x2535, "The number is too high for an FB."},
    {0x253A, "The data block is not loaded. Load it, create it with SFC 22, or correct the call."},
    {0x253C, "The FC is not loaded. Load it, or correct the call."},
    {0x253D, "This CPU has no such SFC."},
    {0x253E, "The FB is not loaded. Load it, or correct the call."},
    {0x253F, "This CPU has no such SFB."},
    {0x2942, "No module answers at this input address. Check configuration and module."},
    {0x2943, "No module answers at this output address. Check configuration and module."},
    {0x3501,
     "The cycle took longer than the monitoring time. Shorten the program, look for a loop "
     "without end, or set a longer time."},
    {0x3502, "An OB was called again while it still ran. Lengthen its interval or shorten it."},
    {0x3842, "The module works again."},
    {0x3942, "A module reports a fault. Look at the module's own diagnosis."},
    {0x4562,
     "Load OB 121, even an empty one, if the program shall go on; better mend the cause in "
     "the entry below."},
    {0x4563,
     "Load OB 122, even an empty one, if the program shall go on; better mend the cause in "
     "the entry below."},
    {0x4568, "Load OB 80 if the program shall go on; the cause stands in the entry below."},
    {0x456A, "Load OB 82 if the program shall go on when a module reports a fault."},
    {0x456B, "Load OB 83 if modules are taken out or put in while the CPU runs."},
    {0x456C, "Load OB 84 if the program shall go on after a fault of the CPU's hardware."},
    {0x456D, "An OB that the event needs is not loaded (OB 1 for a start, OB 85)."},
    {0x456E, "Load OB 87 if the program shall go on after a communication error."},
    {0x456F, "Load OB 86 if the program shall go on when a rack or station fails."},
    {0x4570, "Load OB 40, or switch the hardware interrupt of the module off."},
    {0x4571, "More brackets were opened than the CPU can keep, or one was closed too many."},
    {0x4572, "MCR( and )MCR do not match, or are nested too deeply."},
    {0x4573, "An error OB caused errors itself, too deeply nested. Look at OB 121 and OB 122."},
    {0x4574, "More interrupts wait inside each other than the CPU can keep."},
    {0x4575, "Blocks call each other too deeply. Look for a block that calls itself."},
    {0x4576, "The blocks of one priority class need more local data than the CPU has for it."},
    {0x4578, "The block contains a word that is no instruction. Load the block again."},
    {0x457A, "The block ends without BE. Load the block again."},
};

}  // namespace

std::string_view diagnosticHelp(std::uint16_t event) {
  for (const Row& row : kRows)
    if (row.event == event) return row.help;
  return {};
}

}  // namespace merker::monitor
