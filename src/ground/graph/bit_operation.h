// The operations that join an operand or a bracket to the signal, one row each.
#pragma once

#include "graph/network.h"

namespace merker::graph {

struct BitOperation {
  Op op;
  Join join;
  bool negated, bracket;
};

constexpr BitOperation kBitOperations[] = {
    {Op::AND, Join::And, false, false},     {Op::AND_NOT, Join::And, true, false},
    {Op::OR, Join::Or, false, false},       {Op::OR_NOT, Join::Or, true, false},
    {Op::XOR, Join::Xor, false, false},     {Op::XOR_NOT, Join::Xor, true, false},
    {Op::AND_OPEN, Join::And, false, true}, {Op::OR_OPEN, Join::Or, false, true},
    {Op::XOR_OPEN, Join::Xor, false, true}};

constexpr const BitOperation* bitOperation(Op op) {
  for (const BitOperation& row : kBitOperations)
    if (row.op == op) return &row;
  return nullptr;
}

constexpr Op operationFor(Join join, bool negated, bool bracket) {
  for (const BitOperation& row : kBitOperations)
    if (row.join == join && row.negated == negated && row.bracket == bracket) return row.op;
  return Op::OTHER;
}

}  // namespace merker::graph
