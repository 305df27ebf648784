// The machine code of a block as regions of intermediate code.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "catalogue/cpu_model.h"
#include "icode/region.h"
#include "mc7/listing.h"

namespace merker::translate {

constexpr std::uint32_t kLongestRegion = 128;

// A block that the program calls, as it is now. Longer ones are called: what a call takes is then
// little beside the block itself.
constexpr std::uint32_t kLongestCallee = 40;
struct Callee {
  const mc7::Listing* listing = nullptr;
  const std::uint32_t* parameters = nullptr;  // of its calls, one list behind the other
  std::uint32_t localBytes = 0;
  const void* mark = nullptr;  // icode::Inlined::mark
};
// By kind and number; null: it must be called.
using FindCallee = std::function<const Callee*(bool functionBlock, std::uint32_t number)>;

// What else is known of the block that is translated.
struct Context {
  // By instruction, those that stay with the interpreter; empty: none.
  std::vector<bool> apart{};
  std::uint32_t longest = kLongestRegion;
  bool isOb = false;
  std::uint32_t localBytes = 0;
  const std::uint32_t* parameters = nullptr;  // as in Callee
  FindCallee find{};                          // none: each block is called
};

// In the order of the code. Instructions that belong to no region have no translation; regions end
// in front of them. Every jump target that can be translated begins a region.
//
// A region in which the clock cannot reach the horizon is executed in one go; shorter ones lose
// less when an event is near. Brackets are never divided. In a loop a region goes on with the next
// turns as far as it may be long: they stand in it once more. So does a short block that is called
// (callees.h), as often as it is called.
std::vector<icode::Region> translate(const mc7::Listing& listing, const CpuModel& model,
                                     const Context& context = {});

}  // namespace merker::translate
