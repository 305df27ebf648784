#include "graph5/network_code.h"

#include <algorithm>

#include "graph5/operand_code.h"

namespace merker::graph5 {
namespace {

using graph::Statement;

// Where networks begin, and the end of the last one.
std::vector<std::uint32_t> bordersOf(const mc5::Block& block, std::uint32_t end) {
  std::vector<std::uint32_t> borders{0};
  for (const mc5::Network& network : block.networks)
    if (&network != &block.networks.front() && network.offset >= borders.back() &&
        network.offset <= end)
      borders.push_back(network.offset);
  borders.push_back(end);
  return borders;
}

constexpr std::uint16_t kNetworkEnd = 0x10FF;  // BLD 255 (S5-MISC-04)

// Without the BLD that stands behind a network.
std::uint32_t withoutMark(const mc5::Block& block, std::uint32_t begin, std::uint32_t end) {
  return end > begin && end <= block.words.size() && block.words[end - 1] == kNetworkEnd ? end - 1
                                                                                         : end;
}

// Without the BE that ends the block.
std::uint32_t endOf(const mc5::Block& block) {
  const auto size = static_cast<std::uint32_t>(block.words.size());
  if (size == 0) return 0;
  const auto last = mc5::decode(std::span(block.words).last(1));
  return last && last->instruction.operation == mc5::Operation::END ? size - 1 : size;
}

// A word that begins no instruction, and a code that the assembler would write otherwise, are
// OTHER.
std::uint32_t take(std::span<const std::uint16_t> code, Statement& statement) {
  const auto decoded = mc5::decode(code);
  if (!decoded) return 1;
  statement.op = operationOf(decoded->instruction.operation);
  statement.operand = operandOf(decoded->instruction.operand);
  const auto words = encode({statement});
  if (!words ||
      !std::equal(words->begin(), words->end(), code.begin(), code.begin() + decoded->words))
    statement.op = graph::Op::OTHER;
  return decoded->words;
}

}  // namespace

std::vector<NetworkCode> networks(const mc5::Block& block) {
  std::vector<NetworkCode> out;
  const auto borders = bordersOf(block, endOf(block));
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    NetworkCode& network = out.emplace_back();
    network.begin = borders[i];
    network.end = withoutMark(block, borders[i], borders[i + 1]);
    for (std::uint32_t at = network.begin; at < network.end;) {
      Statement& statement = network.statements.emplace_back();
      statement.offset = at;
      at += take(std::span(block.words).subspan(at, network.end - at), statement);
    }
  }
  return out;
}

std::optional<std::vector<std::uint16_t>> encode(const graph::Statements& statements) {
  std::vector<std::uint16_t> out;
  for (const Statement& statement : statements)
    if (!mc5::encode({machineOperation(statement.op), machineOperand(statement.operand)}, out))
      return std::nullopt;
  return out;
}

}  // namespace merker::graph5
