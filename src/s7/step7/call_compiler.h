// CALL: the macro that STEP 7 makes of a call with parameters, instruction for instruction (code
// patterns, sections 1 to 3; architecture, decision 1).
#pragma once

#include "step7/call_parameters.h"

namespace merker::step7 {

class CallCompiler {
 public:
  explicit CallCompiler(BlockCompiler& compiler) : c_(compiler) {}

  // CALL has been read; the cursor stands before its operand. False after a problem.
  bool compile(std::size_t begin);

 private:
  bool target();
  bool instanceTarget(const block::Variable& variable, std::size_t begin);
  bool instanceDataBlock(std::size_t begin);
  void checkSystemBlock(std::size_t begin);
  void tellOtherBlock(const Position& place);

  // functions
  void callFunction();
  std::uint32_t entry(const block::Variable& formal, const Actual& actual);
  std::uint32_t elementaryEntry(const block::Variable& formal, const Actual& actual);
  void callWithList(const std::vector<std::uint32_t>& entries, BlockId id);

  // function blocks
  void callFunctionBlock();
  void switchToInstance();
  void openInstance();
  void passIn(const block::Variable& formal, const Actual& actual);
  void passNumber(const block::Variable& formal, const Access& actual);
  void passOut(const block::Variable& formal, const Actual& actual);
  void copiesBefore();
  void copiesAfterwards();
  mc7::Operand instanceOperand(BitAddress address, Width width) const;
  void copyBlock(const block::Variable& formal, const Actual& actual, bool in);

  // one value between the caller and the instance, both data block registers being exchanged
  enum class Way : std::uint8_t {
    Direct,      // E, A, M, L, P
    OwnData,     // of the calling FB, or by way of DI: now behind DB
    OtherBlock,  // DBn.DBx, or by way of the DB that was open
    Pointed,     // part of an own composite parameter
    Entry        // own parameter of a calling FC: copied before and afterwards
  };
  static Way wayTo(const Access& access);
  void valueIn(const Access& from, const mc7::Operand& to);
  void valueOut(const mc7::Operand& from, const Access& to);
  mc7::Operand otherBlock(const Access& access) const;
  void pointedIn(const Access& from);
  void pointedOut(const mc7::Operand& from, const Access& to);

  // POINTER and ANY: where its words are written, in local data or in the instance
  struct Cells {
    bool inInstance = false;
    std::uint32_t byte = 0;
  };
  mc7::Operand cell(const Cells& cells, std::uint32_t byte, Width width) const;
  Cells newCells(std::uint32_t bytes);
  void writeWord(const Cells& cells, std::uint32_t byte, std::uint32_t value);
  void writeHeader(const Cells& cells, TypeCode type, std::uint32_t count);
  void descriptor(const Actual& actual, bool any, const Cells& cells);
  void descriptorOfNumber(const mc7::Operand& operand, const Cells& cells);
  void descriptorAddress(const Access& access, const Cells& cells);
  void descriptorInInstance(std::uint32_t offset, const Cells& cells);
  bool isDescriptor(const Actual& actual, bool any) const;
  void copyDescriptor(const Access& access, std::uint32_t bytes, const Cells& cells);
  Area ownArea() const { return exchanged_ ? Area::DataBlock : Area::Instance; }

  // building blocks
  void put(mc7::Operation operation, const mc7::Operand& operand = {}) {
    (void)c_.emit(operation, operand);
  }
  void mark(std::uint32_t number) {
    put(mc7::Operation::BLD, mc7::number(mc7::OperandKind::ShiftCount, number));
  }
  void load(mc7::DataBlockQuery query) {
    put(mc7::Operation::LOAD,
        mc7::number(mc7::OperandKind::DataBlockInfo, static_cast<std::uint32_t>(query)));
  }
  static mc7::Operand local(Width width, std::uint32_t byte) {
    return mc7::memory(Area::Local, width, bitAddress(byte));
  }
  bool callerIsFunctionBlock() const { return c_.scope().block->id.kind == BlockKind::FB; }
  // An FB without multiple instances and without data of its own does not use AR2.
  bool savesAr2() const;
  mc7::Operand newPlace(Width width);
  void read(const Access& from);
  void write(const Access& to);
  static Access machine(const mc7::Operand& operand);
  static Access part(const Access& access, std::uint32_t byte, Width width);
  void constantTo(TypeCode type, const mc7::Operand& value, const mc7::Operand& to);
  // Parameters with an actual operand, in the order of the interface.
  std::vector<const block::Variable*> supplied() const;

  // A value to bring to its place when the called block has returned.
  struct CopyBack {
    mc7::Operand from;
    Access to;
  };

  BlockCompiler& c_;
  CallTarget target_;
  Actuals actuals_;
  std::vector<CopyBack> afterwards_;
  std::map<const block::Variable*, mc7::Operand> copiesOfEntries_;
  mc7::Operand ar2_, instanceNumber_, openNumber_;  // places in local data
  bool exchanged_ = false;                          // TDB: the caller's DI is in DB
};

}  // namespace merker::step7
