// CALL: the macro that STEP 7 makes of a call with parameters (architecture, decision 1; MC7
// section 7.3).
#pragma once

#include "step7/call_parameters.h"

namespace merker::step7 {

class CallCompiler {
 public:
  explicit CallCompiler(BlockCompiler& compiler) : c_(compiler) {}

  // CALL has been read; the cursor stands before its operand. False after a problem.
  bool compile(std::size_t begin);

 private:
  // A value to bring to its place when the called block has returned.
  struct CopyBack {
    mc7::Operand from;
    Access to;
  };

  // An operand that can be reached whatever data blocks are open.
  static bool needsNoDataBlock(const Access& access);

  bool target();
  bool instanceTarget(const block::Variable& variable, std::size_t begin);
  bool instanceDataBlock(std::size_t begin);

  // functions
  void callFunction();
  std::uint32_t entry(const block::Variable& formal, const Actual& actual);
  std::uint32_t elementaryEntry(const block::Variable& formal, const Actual& actual);

  // function blocks
  struct Transfer {  // into the instance, after the instance is open
    BitAddress address;
    mc7::Operand from;  // constant or an operand that needs no data block
    TypeCode type;
  };
  void callFunctionBlock();
  // Parameters with an actual operand, in the order of the interface.
  std::vector<const block::Variable*> supplied() const;
  void collectInput(const block::Variable& formal, const Actual& actual);
  void collectComposite(const block::Variable& formal, const Actual& actual);
  void collectBytes(BitAddress instance, const mc7::Operand& local, std::uint32_t bytes);
  void collectOutputs();
  mc7::Operand instanceOperand(BitAddress address, Width width) const;
  void transferIn(const Transfer& transfer);
  void switchToInstance();
  void switchBack();

  // building blocks
  void put(mc7::Operation operation, const mc7::Operand& operand = {}) {
    (void)c_.emit(operation, operand);
  }
  static mc7::Operand local(Width width, std::uint32_t byte, std::uint32_t bit = 0) {
    return mc7::memory(Area::Local, width, bitAddress(byte, bit));
  }
  mc7::Operand staged(const Access& access, Width width, bool copyIn, bool copyOut);
  void move(Width width, const Access& from, const Access& to);
  static Access machine(const mc7::Operand& operand);
  static Access part(const Access& access, std::uint32_t byte, Width width);
  mc7::Operand constantInLocal(TypeCode type, std::uint32_t bits);
  void storeConstant(TypeCode type, std::uint32_t bits, const mc7::Operand& to);
  std::uint32_t descriptor(const Actual& actual, bool any);
  void descriptorAddress(const Actual& actual, std::uint32_t dbByte, std::uint32_t pointerByte);
  std::uint32_t copyOfOwn(const Access& access, std::uint32_t bytes);
  void copyBlock(const block::Variable& formal, const Actual& actual, bool in);
  void loadConstant(Width width, std::uint32_t value);
  void keepResult();
  void returnResult();
  bool touchesResult() const;

  BlockCompiler& c_;
  CallTarget target_;
  Actuals actuals_;
  std::vector<Transfer> transfers_;
  std::vector<CopyBack> fromInstance_;  // while the instance is open
  std::vector<CopyBack> afterwards_;    // when the caller's data blocks are back
  std::uint32_t ar2_ = 0, result_ = 0;
  bool keeps_ = false;
};

}  // namespace merker::step7
