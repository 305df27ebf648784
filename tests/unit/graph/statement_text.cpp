#include "statement_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "graph/missing.h"
#include "random_networks.h"

namespace merker::graph::test {
namespace {

struct Word {
  Op op;
  std::string_view text;
};
constexpr Word kWords[] = {
    {Op::AND, "U"},       {Op::AND_NOT, "UN"},  {Op::OR, "O"},
    {Op::OR_NOT, "ON"},   {Op::XOR, "X"},       {Op::XOR_NOT, "XN"},
    {Op::AND_OPEN, "U("}, {Op::OR_OPEN, "O("},  {Op::XOR_OPEN, "X("},
    {Op::CLOSE, ")"},     {Op::NOT, "NOT"},     {Op::EDGE_POSITIVE, "FP"},
    {Op::ASSIGN, "="},    {Op::SET_BIT, "S"},   {Op::RESET_BIT, "R"},
    {Op::LOAD, "L"},      {Op::TRANSFER, "T"},  {Op::TIMER_SE, "SE"},
    {Op::EQ_I, "==I"},    {Op::ADD_I, "+I"},    {Op::NOP0, "NOP"},
    {Op::BLD, "BLD"},     {Op::SPBNB, "SPBNB"}, {Op::AND_NOT, "UN"},
    {Op::SET, "SET"},     {Op::SAVE, "SAVE"},   {Op::CLR, "CLR"},
    {Op::CALL, "CALL"},   {Op::OPEN, "AUF"},    {Op::EDGE_NEGATIVE, "FN"},
    {Op::SPA, "SPA"},     {Op::SPB, "SPB"},     {Op::UC, "UC"},
    {Op::CC, "CC"},
};

Op operation(const std::string& word, bool bare) {
  if (word == "O" && bare) return Op::AND_BEFORE_OR;
  const auto at = std::find_if(std::begin(kWords), std::end(kWords),
                               [&word](const Word& row) { return row.text == word; });
  return at == std::end(kWords) ? Op::OTHER : at->op;
}

std::string_view word(Op op) {
  if (op == Op::AND_BEFORE_OR) return "O";
  const auto at = std::find_if(std::begin(kWords), std::end(kWords),
                               [op](const Word& row) { return row.op == op; });
  return at == std::end(kWords) ? "?" : at->text;
}

}  // namespace

Operand operand(const std::string& text) {
  if (text.starts_with(kMissingBegin)) return missing(text);
  Operand out;
  out.code = out.text = text;
  if (text == "BIE" || text == "OV") return {OperandKind::Status, 0, {}, text};
  unsigned byte = 0, number = 0;
  if (std::sscanf(text.c_str(), "L %u.%u", &byte, &number) == 2 && byte >= 20) {
    out = {OperandKind::Wire, byte * 8 + number, {}, text};
  } else if (text.find('.') != std::string::npos) {
    out.kind = OperandKind::Bit;
  } else {
    out.kind =
        text.starts_with("T ") || text.starts_with("FC") ? OperandKind::Number : OperandKind::Value;
  }
  return out;
}

Statements statements(const std::string& text) {
  Statements out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line, ';');) {
    std::istringstream words(line);
    std::string first, rest;
    words >> first >> std::ws;
    std::getline(words, rest);
    if (first.empty()) continue;
    Statement& statement = out.emplace_back();
    statement.op = operation(first, rest.empty());
    if (statement.op == Op::BLD)
      statement.operand = {
          OperandKind::Count, static_cast<std::uint32_t>(std::stoul(rest)), {}, {}};
    else if (statement.op == Op::SPBNB)
      statement.target = std::stoi(rest.substr(2));
    else if (!rest.empty())
      statement.operand = operand(rest);
    if (statement.op == Op::SPBNB) statement.operand.kind = OperandKind::Label;
  }
  return out;
}

std::string text(const Statements& statements) {
  std::string out;
  for (const Statement& statement : statements) {
    if (!out.empty()) out += "; ";
    out += word(statement.op);
    const Operand& operand = statement.operand;
    if (operand.kind == OperandKind::Count) out += fmt::format(" {}", operand.number);
    if (operand.kind == OperandKind::Status)
      out += operand.text.empty() ? " BIE" : " " + operand.text;
    else if (!operand.text.empty())
      out += " " + operand.text;
    if (statement.target >= 0) out += fmt::format(" ->{}", statement.target);
  }
  return out;
}

}  // namespace merker::graph::test
