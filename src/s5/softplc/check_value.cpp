#include "softplc/check_value.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/check_record.h"
#include "mc5/s5_float.h"

namespace merker::sinumerik {
namespace {

using block::CheckRegister;
using block::CheckTerm;
using block::CheckValue;
using block::Relation;

std::uint32_t registerValue(Machine& m, CheckRegister which) {
  const Displays& d = m.displays();
  switch (which) {
    case CheckRegister::VKE:
      return d.vke;
    case CheckRegister::STA:
      return d.status;
    case CheckRegister::OR:
      return d.orBit;
    case CheckRegister::OS:
      return d.os;
    case CheckRegister::OV:
      return d.ov;
    case CheckRegister::A0:
      return d.anz0;
    case CheckRegister::A1:
      return d.anz1;
    case CheckRegister::ER:
      return d.chain;
    case CheckRegister::AKKU1:
      return m.registers().akku1;
    case CheckRegister::AKKU2:
      return m.registers().akku2;
    case CheckRegister::STW:
      return d.byte();
    case CheckRegister::DBNO:
      return m.frame().data.open ? m.frame().data.number : 0;
    default:
      return 0;  // registers of other machines; the front end does not know their words
  }
}

std::vector<std::uint16_t> wordsOf(const std::vector<std::uint8_t>& code) {
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; i + 1 < code.size(); i += 2)
    words.push_back(static_cast<std::uint16_t>(code[i] << 8 | code[i + 1]));
  return words;
}

std::uint32_t narrowed(std::uint32_t value, unsigned width) {
  return width >= 32 ? value : value & ((1u << width) - 1);
}

std::optional<std::uint32_t> valueOf(Processor& p, const CheckValue& value) {
  if (value.kind == CheckValue::Kind::Constant) return value.constant;
  if (value.kind == CheckValue::Kind::Register)
    return narrowed(registerValue(p.machine(), value.reg), value.width);
  const bool bit = value.kind == CheckValue::Kind::BitCode;
  const auto seen = p.probe(wordsOf(value.code), bit);
  if (!seen) return std::nullopt;
  return bit ? std::uint32_t{seen->displays.vke} : seen->akku1;
}

std::string shown(std::uint32_t value, const CheckTerm& term) {
  if (term.relation == Relation::About) return fmt::format("{:e}", mc5::toDouble(value));
  if (std::min(term.left.width, term.right.width) <= 1 && value <= 1)
    return fmt::format("{}", value);
  return value <= 0xFFFF ? fmt::format("KH {:04X}", value)
                         : fmt::format("KH {:04X} {:04X}", value >> 16, value & 0xFFFF);
}

}  // namespace

std::optional<std::string> judge(Processor& p, const CheckTerm& term) {
  return block::judge(term, valueOf(p, term.left), valueOf(p, term.right), mc5::toDouble, shown);
}

}  // namespace merker::sinumerik
