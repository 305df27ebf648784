// The code part of one block: statements to MC7. Third pass of the compiler.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "step7/code_builder.h"
#include "step7/local_data.h"
#include "step7/operand_parser.h"

namespace merker::step7 {

class BlockCompiler {
 public:
  BlockCompiler(const BlockSource& source, block::Block& target, Interfaces& interfaces,
                const CompileOptions& options, Problems& problems);

  // Fills the target's code, lines, networks, checks and its local data requirement.
  void compile();
  const MnemonicUse& mnemonicUse() const { return use_; }

  // --- for the CALL macro (call_compiler) ---
  const Scope& scope() const { return scope_; }
  CodeBuilder& builder() { return *builder_; }
  Cursor& cursor() { return cursor_; }
  Problems& problems() { return problems_; }
  std::optional<Access> operand();
  // For the duration of one statement.
  LocalData& localData() { return localData_; }
  // Code that performs `operation` on the operand, with what has to be opened before. Problem if
  // impossible.
  bool access(mc7::Operation operation, const Access& access);
  bool emit(mc7::Operation operation, const mc7::Operand& operand = {});
  bool emitAll(const std::vector<mc7::Instruction>& code);
  Position at(std::size_t begin, std::size_t end) const {
    return source_.file->position(begin, std::max(end, begin + 1) - begin);
  }
  Position here() { return at(cursor_.pos(), cursor_.pos() + 1); }

 private:
  bool pass(std::uint32_t localBase);
  std::uint32_t firstFreeLocalByte() const;
  void followParameter(const Access& access);
  mc7::Operand numberParameter(const Access& access);
  void keepAccumulators(std::uint32_t byte);
  void loadAccumulators(std::uint32_t byte);
  void statement();
  bool label();
  void labelDefinition(std::string_view word, std::size_t begin);
  bool networkHeader(std::string_view word);
  bool isGraphic() const { return target_.language != block::Language::Awl; }
  void nextNetwork();
  std::optional<mc7::Operation> operationOf(const std::string& mnemonic, std::size_t begin);
  void instruction(const std::string& mnemonic, std::size_t begin);
  void operate(mc7::Operation operation, std::size_t begin, const std::string& mnemonic);
  std::size_t jumpLabel();
  void jump(mc7::Operation operation, std::size_t begin);
  void addressRegister(mc7::Operation operation, const Access& access);
  void blockCall(mc7::Operation operation, const Access& access);
  void checkCallWithoutParameters(mc7::Operation operation, const Access& access);
  bool checkDirection(mc7::Operation operation, const Access& access, const std::string& mnemonic);
  void structure(mc7::Operation operation, std::size_t begin);
  void checkInstanceRegisters(mc7::Operation operation, const Access* access, std::size_t begin);
  void endOfNetwork();
  void endOfStatement();
  void checks();
  void endOfBlock();
  void skipStatement();

  const BlockSource& source_;
  block::Block& target_;
  const CompileOptions& options_;
  Problems& finalProblems_;
  Problems problems_;
  MnemonicUse use_;
  Scope scope_;
  Cursor cursor_;
  std::unique_ptr<CodeBuilder> builder_;
  std::uint32_t localTop_ = 0;     // absolute local data used by the program
  std::uint32_t declaredTop_ = 0;  // behind the declared ones
  NetworkTops networkTops_;        // KOP and FUP
  LocalData localData_;
  std::vector<std::size_t> brackets_;  // positions of open U( … in this network
  struct Place {
    std::string label;
    std::size_t bracket;  // position of the innermost open bracket, 0 outside of brackets
    Position position;
  };
  std::size_t bracket() const { return brackets_.empty() ? 0 : brackets_.back(); }
  void checkJumpsIntoBrackets();
  std::vector<Place> labels_, jumps_;
  std::vector<std::size_t> relays_;  // of open MCR(
  bool ended_ = false;               // BE was the last statement
  bool reportedAfterEnd_ = false;
  bool any_ = false;  // an instruction was made: a check has something to refer to
};

}  // namespace merker::step7
