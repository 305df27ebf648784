// Parameters and signals of a plant by the names in its rows, looked up while Merker is compiled: a
// name that no row has does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "plant/kind.h"

namespace merker::plant {

constexpr std::string_view nameOf(const Parameter& row) { return row.key; }
constexpr std::string_view nameOf(const Signal& row) { return row.name; }

template <typename Rows>
constexpr std::uint32_t indexIn(const Rows& rows, std::string_view name) {
  for (std::uint32_t i = 0; i < std::size(rows); ++i)
    if (nameOf(rows[i]) == name) return i;
  throw "no row has this name";
}

// Whether `count` rows stand from the one to the other, so that Named::from reaches them all.
template <typename Rows>
constexpr bool areTogether(const Rows& rows, std::string_view first, std::string_view last,
                           std::size_t count) {
  return indexIn(rows, last) - indexIn(rows, first) + 1 == count;
}

// Made of a string literal.
template <const auto& rows>
struct RowName {
  std::uint32_t index;
  consteval RowName(const char* name) : index(indexIn(rows, name)) {}
};

// One value for each of the rows, in their order.
template <const auto& rows, typename Value>
class Named {
 public:
  using Name = RowName<rows>;
  explicit Named(std::span<Value> values) : values_(values) {}
  static consteval std::uint32_t at(Name name) { return name.index; }
  Value& operator[](Name name) const { return values_[name.index]; }
  // The value of this row, and those of the rows behind it.
  std::span<Value> from(Name name) const { return values_.subspan(name.index); }

 private:
  std::span<Value> values_;
};

inline constexpr std::array<Parameter, 0> kNoParameters{};

// A process that knows its parameters and signals by name.
template <const auto& parameters, const auto& signals>
class ProcessOf : public Process {
 public:
  using Parameters = Named<parameters, const double>;
  using Signals = Named<signals, double>;
  using Seen = Named<signals, const double>;

  virtual void begin(Signals values) = 0;
  virtual void advance(Instant from, Instant to, Signals values) = 0;
  virtual double silence(Seen) const { return 0; }

  void begin(std::span<double> values) final { begin(Signals(values)); }
  void advance(Instant from, Instant to, std::span<double> values) final {
    advance(from, to, Signals(values));
  }
  double silence(std::span<const double> values) const final { return silence(Seen(values)); }
};

// Kind::make of a process.
template <typename Made>
std::unique_ptr<Process> make(std::span<const double> parameters) {
  return std::make_unique<Made>(typename Made::Parameters(parameters));
}

}  // namespace merker::plant
