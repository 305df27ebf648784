// Data types of declarations: elementary, composite and parameter types, with their place in memory
// (S7-TYPES-20, -21, -27). Types are shared and never changed once a declaration is complete.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "address/area.h"
#include "address/type_code.h"
#include "base/problem.h"

namespace merker::block {

struct Type;
using TypePtr = std::shared_ptr<const Type>;

struct Dimension {
  std::int32_t low = 0, high = 0;
  std::uint32_t count() const { return static_cast<std::uint32_t>(high - low + 1); }
  bool operator==(const Dimension&) const = default;
};

enum class Section : std::uint8_t { Input = 1, Output, InOut, Static, Temp, Return };

struct Variable {
  std::string name;
  Section section = Section::Static;
  TypePtr type;
  BitAddress address = 0;  // in its own frame: instance, local data or structure
  std::vector<std::uint8_t>
      initial;  // bytes of the start value (whole variable); empty = zero / default
  bool hasInitial = false;
  std::string comment;
  std::vector<std::pair<std::string, std::string>> attributes;  // { S7_m_c := 'true' }
  Position position;
};

struct Type {
  TypeCode code = TypeCode::Void;
  std::uint16_t length =
      0;  // STRING: maximal length; instances: block number; UDT: its number in `udt`
  std::vector<Dimension> dimensions;  // ARRAY
  TypePtr element;                    // ARRAY
  std::vector<Variable> members;      // STRUCT, UDT, instances (without temp)
  std::int32_t udt = -1;              // number of the UDT this structure is, else -1
  std::uint32_t bits = 0;             // size in bits; composite types: whole bytes, even number
};

// Bits that a value takes and whether it begins on an even byte; BOOL packs into the next free bit.
std::uint32_t sizeInBits(const Type& type);
inline std::uint32_t sizeInBytes(const Type& type) { return (sizeInBits(type) + 7) / 8; }
bool beginsAtWord(const Type& type);

// Place of an element from the start of the array; rows of a BOOL array begin at even bytes
// (S7-TYPES-20).
BitAddress elementOffset(const Type& array, const std::vector<std::int32_t>& indices);
// The places of all elements in their order: the last index runs fastest.
std::vector<BitAddress> elementOffsets(const Type& array);

TypePtr elementaryType(TypeCode code);
TypePtr stringType(std::uint16_t length);
TypePtr arrayType(std::vector<Dimension> dimensions, TypePtr element);
// Lays the members out one after the other and sets their addresses.
TypePtr structType(std::vector<Variable> members);
// Same layout and same types throughout (names do not matter): what a parameter of this type
// accepts.
bool sameStructure(const Type& a, const Type& b);

// Gives each variable its address from `start` on; every section (IN, OUT …) begins at an even
// byte. Returns the first free bit address, rounded to even bytes when `roundUp`.
BitAddress layOut(std::vector<Variable>& variables, BitAddress start, bool roundUp);

// "INT", "ARRAY [1..4] OF WORD", "STRING [20]", "UDT 3", "FB 10".
std::string toString(const Type& type);

// A composite IN_OUT parameter takes the 6 bytes of a POINTER in its frame (S7-PAR-03).
bool isStoredAsPointer(const Variable& variable);

// Writes the start values of `variable` into `image` (bytes of the frame), zero where none is
// declared, with STRING lengths and DT defaults (DT#1990-01-01-00:00:00.000). The variable lies at
// `place` of the image, which grows where it is too short.
void writeInitial(const Variable& variable, BitAddress place, std::vector<std::uint8_t>& image);

}  // namespace merker::block
