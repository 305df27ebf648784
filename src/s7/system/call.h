// A call of one system function: its arguments by the names in its row. The body of SFB 47 takes an
// Sfb<47>& a and reads a.integer("CHANNEL"); a body for several functions is a template.
#pragma once

#include "system/arguments.h"
#include "system/parameter_name.h"

namespace merker::system {

template <BlockKind kind, std::uint16_t number>
class Call : public Arguments {
 public:
  using Arguments::Arguments;
  using Name = ParameterName<kind, number>;

  bool has(Name p) { return Arguments::has(p.index); }
  std::uint32_t value(Name p) { return Arguments::value(p.index); }
  bool flag(Name p) { return Arguments::flag(p.index); }
  std::int32_t integer(Name p) { return Arguments::integer(p.index); }
  std::int32_t longInteger(Name p) { return Arguments::longInteger(p.index); }
  float real(Name p) { return Arguments::real(p.index); }
  void set(Name p, std::uint32_t value) { Arguments::set(p.index, value); }
  void setReal(Name p, float value) { Arguments::setReal(p.index, value); }
  // Sets all parameters from `first` to `last` to 0.
  void clear(Name first, Name last) {
    for (std::size_t i = first.index; i <= last.index; ++i) Arguments::set(i, 0);
  }

  AnyPointer any(Name p) { return Arguments::any(p.index); }
  AnyPointer pointer(Name p) { return Arguments::pointer(p.index); }
  Region composite(Name p, std::uint32_t bytes, cpu::Access access) {
    return Arguments::composite(p.index, bytes, access);
  }
  Region structure(Name p, std::uint32_t bytes) { return Arguments::structure(p.index, bytes); }
  void parameterError(Name p, std::uint32_t code) { Arguments::parameterError(p.index, code); }
  void parameterError(Name p, cpu::ErrorCode code) { Arguments::parameterError(p.index, code); }
};

template <std::uint16_t number>
using Fc = Call<BlockKind::FC, number>;
template <std::uint16_t number>
using Sfc = Call<BlockKind::SFC, number>;
template <std::uint16_t number>
using Sfb = Call<BlockKind::SFB, number>;
// Of SIMATIC_NET_CP.
template <std::uint16_t number>
using CpFc = Call<BlockKind::FC, kCpRow + number>;
template <std::uint16_t number>
using CpFb = Call<BlockKind::FB, kCpRow + number>;

// A name in the row of whichever function `A` is a call of.
template <typename A>
using NameIn = typename A::Name;

}  // namespace merker::system
