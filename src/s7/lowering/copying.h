// Writes the instructions of a called block into the region of its caller.
#pragma once

#include "lowering/callees.h"

namespace merker::translate {

class Copying {
 public:
  struct Means {
    const CpuModel& model;
    Shapes& shapes;
  };
  Copying(icode::Builder& builder, icode::Region& region, std::vector<Reach>& reached,
          const Means& means)
      : builder_(builder), region_(region), reached_(reached), means_(means) {}

  // The block that the region is in.
  struct Caller {
    const mc7::Listing& listing;
    std::uint32_t localBytes;
    bool isOb;
    const std::uint32_t* parameters;
  };
  // UC or CC at this place. False: the block must be called; nothing has changed.
  bool call(const Shape& shape, const Caller& caller, std::uint32_t place);

 private:
  // A block that runs now, or waits for what it called.
  struct Block {
    const mc7::Listing& listing;
    std::uint32_t local, localBytes;  // as in Inside
    bool isOb;
    const std::uint32_t* parameters;
    std::uint32_t inside = 0, depth = 0;  // as in icode::Inlined
    const Inside* here = nullptr;         // null: the region's own
  };
  bool enter(const Shape& shape, const Block& caller, std::uint32_t place);
  bool body(const Shape& shape, const Block& block);
  bool instruction(const Shape& shape, const Block& block, std::uint32_t& at);
  bool lower(const Shape& shape, const Block& block, std::uint32_t& at);
  void begin(const Block& block, std::uint32_t place);
  void finish();

  icode::Builder& builder_;
  icode::Region& region_;
  std::vector<Reach>& reached_;
  const Means means_;
  std::uint32_t own_ = 0;  // local data of the region's block
  // Of the block that runs now.
  std::vector<std::array<icode::Value, 3>> brackets_;
  std::map<std::uint32_t, BitPlace> ahead_;
};

}  // namespace merker::translate
