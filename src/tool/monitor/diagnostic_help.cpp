// Cause and remedy of the events of S7-DIAG-02 and S7-DIAG-03, in the words of a help page.
#include "monitor/diagnostic_list.h"

namespace merker::monitor {
namespace {

struct Row {
  std::uint16_t event;
  std::string_view help;
};

constexpr Row kRows[] = {
    {0x2521,
     "AKKU 1 does not contain a BCD number. Check the value before BTI, BTD, a timer or a "
     "counter."},
    {0x2522,
     "The operand read is beyond the end of its area or data block. Check address, "
     "pointer and length."},
    {0x2523,
     "The operand written is beyond the end of its area or data block. Check address, "
     "pointer and length."},
    {0x2524,
     "The pointer used for reading has no valid operand area. Check bits 31..24 of the "
     "pointer."},
    {0x2525,
     "The pointer used for writing has no valid operand area. Check bits 31..24 of the "
     "pointer."},
    {0x2526, "The CPU has no timer with this number."},
    {0x2527, "The CPU has no counter with this number."},
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
     "The cycle took longer than the monitoring time. Shorten the program, look for an "
     "endless loop, or set a longer time."},
    {0x3502, "An OB was called again while it still ran. Lengthen its interval or shorten the OB."},
    {0x3842, "The module works again."},
    {0x3942, "A module reports a fault. Check the diagnostics of the module."},
    {0x4562,
     "Load OB 121, even an empty one, to continue the program; or better, correct the cause "
     "in the entry below."},
    {0x4563,
     "Load OB 122, even an empty one, to continue the program; or better, correct the cause "
     "in the entry below."},
    {0x4568, "Load OB 80 to continue the program; the cause is in the entry below."},
    {0x456A, "Load OB 82 to continue the program when a module reports a fault."},
    {0x456B, "Load OB 83 if modules are removed or inserted while the CPU runs."},
    {0x456C, "Load OB 84 to continue the program after a CPU hardware fault."},
    {0x456D, "An OB that the event needs is not loaded (OB 1 for a start, OB 85)."},
    {0x456E, "Load OB 87 to continue the program after a communication error."},
    {0x456F, "Load OB 86 to continue the program when a rack or station fails."},
    {0x4570, "Load OB 40, or disable the hardware interrupt of the module."},
    {0x4571, "More brackets were opened than the CPU can store, or one too many was closed."},
    {0x4572, "MCR( and )MCR do not match, or are nested too deeply."},
    {0x4573, "An error OB caused errors itself, too deeply nested. Look at OB 121 and OB 122."},
    {0x4574, "More interrupts are nested than the CPU can store."},
    {0x4575, "Blocks call each other too deeply. Look for a block that calls itself."},
    {0x4576, "The blocks of one priority class need more local data than the CPU provides."},
    {0x4578, "The block contains an invalid instruction. Load the block again."},
    {0x457A, "The block ends without BE. Load the block again."},
};

}  // namespace

std::string_view diagnosticHelp(std::uint16_t event) {
  for (const Row& row : kRows)
    if (row.event == event) return row.help;
  return {};
}

}  // namespace merker::monitor
