// A program as a listing in the manual's form; compiling it gives the same words.
#include <fmt/format.h>

#include <map>

#include "mc5/constant.h"
#include "step5/block_source.h"
#include "step5/call_list.h"
#include "step5/compiler.h"
#include "step5/declaration.h"
#include "step5/jump_targets.h"
#include "step5/operand.h"
#include "step5/symbol.h"

namespace merker::step5 {
namespace {

using mc5::Block;
using mc5::BlockType;
using mc5::OperandKind;
using mc5::Parameter;

constexpr std::size_t kPrintedComment = 32;

class Printer {
 public:
  Printer(const mc5::Program& program, const Block& block, const source::SymbolTable* symbols)
      : program_(program), block_(block), symbols_(symbols) {
    for (const mc5::Comment& comment : block.comments) comments_.emplace(comment.offset, &comment);
    for (const mc5::Network& network : block.networks) networks_[network.offset] = &network;
  }

  std::string print() {
    head();
    if (block_.id.type == BlockType::Db)
      data();
    else
      code();
    commentsBefore(static_cast<std::uint32_t>(block_.words.size()));
    return std::move(out_);
  }

 private:
  template <typename... Arguments>
  void put(fmt::format_string<Arguments...> pattern, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(out_), pattern, std::forward<Arguments>(arguments)...);
  }

  // A line of what stands at a word, with its comment.
  void line(std::string text, std::uint32_t at) {
    const auto [first, end] = comments_.equal_range(at);
    for (auto comment = first; comment != end; ++comment)
      if (comment->second->behind)
        text = fmt::format("{:<{}} {}", text, kPrintedComment, comment->second->text);
    put("{}\n", text);
  }

  void commentsBefore(std::uint32_t at) {
    const auto [first, end] = comments_.equal_range(at);
    for (auto comment = first; comment != end; ++comment)
      if (!comment->second->behind) put("{}\n", comment->second->text);
  }

  void head() {
    for (const std::string& comment : block_.heading) put("{}\n", comment);
    put("{}", toString(block_.id));
    if (!block_.name.empty()) put("   {}", block_.name);
    if (block_.library != 0) put("   BIB={}", block_.library);
    put("\n");
    for (const Parameter& parameter : block_.parameters) declaration(parameter);
  }

  void declaration(const Parameter& parameter) {
    const std::string type = typeText(parameter);
    put("BEZ  : {:<4}  E/A/D/B/T/Z: {}", parameter.name, type.substr(0, 1));
    const bool data = parameter.kind == mc5::ParameterKind::Data;
    if (type.size() > 2)
      put("  {}: {}", data ? "KM/KH/KY/KC/KT/KZ/KF/KG" : "BI/BY/W/D", type.substr(2));
    put("\n");
  }

  void data() {
    for (std::uint32_t at = 0; at < block_.words.size();) {
      commentsBefore(at);
      at = block_.texts.contains(at) ? characters(at) : dataWord(at);
    }
  }

  // KS = 'TEXT'
  std::uint32_t characters(std::uint32_t at) {
    const std::uint32_t end = at + block_.texts.at(at);
    std::string text;
    for (std::uint32_t i = at; i < end; ++i) {
      text += static_cast<char>(block_.words[i] >> 8);
      text += static_cast<char>(block_.words[i] & 0xFF);
    }
    line(fmt::format("{:>5}: KS '{}'", at, text), at);
    return end;
  }

  std::uint32_t dataWord(std::uint32_t at) {
    const mc5::Format format = at < block_.formats.size() ? block_.formats[at] : mc5::Format::Hex;
    const bool pair = format == mc5::Format::Float && at + 1 < block_.words.size();
    std::uint32_t value = block_.words[at];
    if (pair) value = value << 16 | block_.words[at + 1];
    const std::string text = mc5::constantText(
        {.kind = OperandKind::Constant, .format = pair ? format : plain(format), .value = value});
    line(fmt::format("{:>5}: {}", at, text), at);
    return at + (pair ? 2 : 1);
  }

  static mc5::Format plain(mc5::Format format) {
    return format == mc5::Format::Float ? mc5::Format::Hex : format;
  }

  void code() {
    targets_ = jumpTargets(program_, block_);
    for (std::uint32_t at = 0; at < block_.words.size();) {
      commentsBefore(at);
      network(at);
      at = instruction(at);
    }
  }

  void network(std::uint32_t at) {
    const auto network = networks_.find(at);
    if (network != networks_.end()) put("NETZWERK {} {}\n", ++printed_, network->second->title);
  }

  // BLD 255 in front of a network is written by NETZWERK.
  bool endsNetwork(std::uint32_t at) const {
    return at != 0 && block_.words[at] == 0x10FF && networks_.contains(at + 1);
  }

  std::uint32_t instruction(std::uint32_t at) {
    const std::string label = targets_.contains(at) ? targets_.at(at) : std::string();
    if (endsNetwork(at)) {
      if (!label.empty()) put("{:<4} :\n", label);
      return at + 1;
    }
    const auto decoded = mc5::decode(std::span(block_.words).subspan(at));
    if (!decoded) {
      line(fmt::format("{:<4} : illegal {:04X}", label, block_.words[at]), at);
      return at + 1;
    }
    line(fmt::format("{:<4} : {}", label, statement(at, decoded->instruction)), at);
    const std::uint32_t next = at + decoded->words;
    const auto list = callList(program_, block_, decoded->instruction, next);
    return list ? parameters(*list) : next;
  }

  std::string statement(std::uint32_t at, const mc5::Instruction& instruction) const {
    const mc5::Operand& operand = instruction.operand;
    const std::string_view name = mc5::info(instruction.operation).name;
    if (operand.kind == OperandKind::Jump) {
      const std::uint32_t target = at + operand.value;
      if (targets_.contains(target) && sameNetwork(block_, at, target))
        return fmt::format("{:<5} ={}", name, targets_.at(target));
    }
    if (operand.kind == OperandKind::Formal) {
      const auto words = parameterWords(block_.parameters);
      for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == operand.value)
          return fmt::format("{:<5} ={}", name, block_.parameters[i].name);
    }
    if (const source::Symbol* symbol = symbolOf(operand, symbols_))
      return fmt::format("{:<5} {}", name, symbolText(symbol->name));
    return mc5::text(instruction);
  }

  // E, A and blocks of a list by their symbols; constants have none.
  std::string actual(const ListedParameter& parameter) const {
    const source::Symbol* const symbol = symbolOf(parameter.operand, symbols_);
    return symbol == nullptr ? parameter.actual : symbolText(symbol->name);
  }

  std::uint32_t parameters(const CallList& list) {
    put("NAME : {}\n", list.called->name);
    for (const ListedParameter& parameter : list.parameters) {
      commentsBefore(parameter.offset);
      line(fmt::format("{:<4} : {}", parameter.name, actual(parameter)), parameter.offset);
    }
    return list.end;
  }

  const mc5::Program& program_;
  const Block& block_;
  const source::SymbolTable* symbols_;
  std::string out_;
  std::multimap<std::uint32_t, const mc5::Comment*> comments_;
  std::map<std::uint32_t, const mc5::Network*> networks_;
  std::map<std::uint32_t, std::string> targets_;
  unsigned printed_ = 0;  // networks
};

}  // namespace

std::string listing(const mc5::Program& program, const source::SymbolTable* symbols) {
  std::string text;
  for (const auto& [id, block] : program) text += listing(program, block, symbols) + "\n";
  return text;
}

std::string listing(const mc5::Program& program, const mc5::Block& block,
                    const source::SymbolTable* symbols) {
  return Printer(program, block, symbols).print();
}

}  // namespace merker::step5
