// The interface part (SSB) of a block container: declarations without names, and start values. In
// this part all words are little-endian (MC7 section 8, docs/formats/block.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "block/block.h"

namespace merker::block {

std::vector<std::uint8_t> writeInterface(const Block& block);

// Fills variables, return type, instance length and the FB of an instance DB. False if the bytes
// are no interface or describe more than a block can hold.
[[nodiscard]] bool readInterface(std::span<const std::uint8_t> bytes, Block& block);

// Marks in the section byte of a declaration.
constexpr std::uint8_t kHasStartValue = 0x08;
constexpr std::uint8_t kExtended = 0x10;  // one more byte of unknown meaning follows

// First byte of the part.
enum class InterfaceKind : std::uint8_t {
  Code = 0x01,
  Data = 0x05,
  InstanceOfFb = 0x0A,
  InstanceOfSfb = 0x0B
};

constexpr std::size_t kInterfaceHeader = 7;

// A multiple instance; in the number of members of a STRUCT it and the STRUCT behind it are two.
constexpr bool isInstance(TypeCode code) {
  return code == TypeCode::FunctionBlock || code == TypeCode::SystemFunctionBlock;
}

// Start values are kept by data that are stored in an instance or a data block: not by temporary
// variables, parameters of functions and composite in/out parameters (S7-SRC-04). A variable of a
// user-defined type brings its values along; they are left out there, as no source can hold them.
constexpr bool keepsStartValue(BlockKind block, Section section, bool composite) {
  if (block == BlockKind::FC || block == BlockKind::SFC) return false;
  if (section == Section::Temp || section == Section::Return) return false;
  return section != Section::InOut || !composite;
}

constexpr bool isComposite(TypeCode code) {
  return code == TypeCode::Struct || code == TypeCode::Array || code == TypeCode::String;
}

}  // namespace merker::block
