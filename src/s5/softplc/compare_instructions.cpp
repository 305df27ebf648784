// Comparisons of AKKU 2 with AKKU 1 (9.3.5, S5-CMP).
#include <compare>

#include "check/relation.h"
#include "mc5/s5_float.h"
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using block::Relation;
using mc5::Instruction;
using mc5::Operation;

template <typename Value>
bool judge(Processor& p, Value left, Value right, bool truth) {
  Displays& d = p.displays();
  d.setAnz(left > right, left < right);
  d.ov = false;
  d.vke = d.status = truth;
  d.orBit = false;
  d.chain = true;
  return true;
}

template <Relation R>
bool compareF(Processor& p, const Instruction&) {
  const auto left = static_cast<std::int16_t>(p.registers().low2());
  const auto right = static_cast<std::int16_t>(p.registers().low1());
  return judge(p, left, right, block::relates(left, R, right));
}
template <Relation R>
bool compareD(Processor& p, const Instruction&) {
  const auto left = static_cast<std::int32_t>(p.registers().akku2);
  const auto right = static_cast<std::int32_t>(p.registers().akku1);
  return judge(p, left, right, block::relates(left, R, right));
}
template <Relation R>
bool compareG(Processor& p, const Instruction&) {
  const double left = mc5::toDouble(p.registers().akku2);
  const double right = mc5::toDouble(p.registers().akku1);
  return judge(p, left, right, block::relates(left, R, right));
}

constexpr HandlerRow kCompareRows[] = {
    {Operation::EQUAL_F, compareF<Relation::Equal>},
    {Operation::UNEQUAL_F, compareF<Relation::NotEqual>},
    {Operation::GREATER_F, compareF<Relation::Greater>},
    {Operation::GREATER_EQUAL_F, compareF<Relation::GreaterEqual>},
    {Operation::LESS_F, compareF<Relation::Less>},
    {Operation::LESS_EQUAL_F, compareF<Relation::LessEqual>},
    {Operation::EQUAL_D, compareD<Relation::Equal>},
    {Operation::UNEQUAL_D, compareD<Relation::NotEqual>},
    {Operation::GREATER_D, compareD<Relation::Greater>},
    {Operation::GREATER_EQUAL_D, compareD<Relation::GreaterEqual>},
    {Operation::LESS_D, compareD<Relation::Less>},
    {Operation::LESS_EQUAL_D, compareD<Relation::LessEqual>},
    {Operation::EQUAL_G, compareG<Relation::Equal>},
    {Operation::UNEQUAL_G, compareG<Relation::NotEqual>},
    {Operation::GREATER_G, compareG<Relation::Greater>},
    {Operation::GREATER_EQUAL_G, compareG<Relation::GreaterEqual>},
    {Operation::LESS_G, compareG<Relation::Less>},
    {Operation::LESS_EQUAL_G, compareG<Relation::LessEqual>}};

}  // namespace

HandlerRows compareHandlers() { return kCompareRows; }

}  // namespace merker::sinumerik
