#include "mc5/resident_blocks.h"

namespace merker::mc5 {
namespace {

Parameter data(const char* name, Format format) {
  return {name, ParameterKind::Data, Width::Word, format};
}
Parameter input(const char* name, Width width) {
  return {name, ParameterKind::Input, width, Format::Hex};
}
Parameter output(const char* name, Width width) {
  return {name, ParameterKind::Output, width, Format::Hex};
}

Block macro(std::uint16_t number, const char* name, std::vector<Parameter> parameters = {}) {
  Block block;
  block.id = {BlockType::Fb, number};
  block.name = name;
  block.parameters = std::move(parameters);
  return block;
}

// FB 61 and FB 62 differ in the names of the first and the last parameter (S5-FM-24).
std::vector<Parameter> transfer(const char* order, const char* place) {
  return {input(order, Width::Bit),         input("NSBY", Width::Byte),
          data("ANZ", Format::Fixed),       data("DTY1", Format::Characters),
          data("DTY2", Format::Characters), data("DTY3", Format::Characters),
          data("WER1", Format::Fixed),      data("WER2", Format::Fixed),
          data("WER3", Format::Fixed),      data("ZFPN", Format::Characters),
          data(place, Format::Bytes)};
}

}  // namespace

// Types of FB 11, 60 and 190 are reconstructed (OP-57).
std::span<const Block> residentBlocks() {
  static const std::vector<Block> kBlocks = {
      macro(11, "EINR-DB", {data("DBAN", Format::Bytes), data("DWNR", Format::Fixed)}),
      macro(56, "VORSCHUB"),
      macro(57, "SCHLEPPA"),
      macro(58, "SPINDIST"),
      macro(60, "BLOCK-TR",
            {data("DBQZ", Format::Bytes), data("DWQ", Format::Fixed), data("DZ/A", Format::Bytes)}),
      macro(61, "NCD-LESE", transfer("LESE", "ZIEL")),
      macro(62, "NCD-SCHR", transfer("SCHR", "QUEL")),
      macro(65, "M STACK"),
      macro(66, "STACK M"),
      macro(190, "K-LEITPC",
            {data("ADPR", Format::Fixed), data("DBDW", Format::Bytes), data("R/A", Format::Bytes),
             output("MELD", Width::Byte)})};
  return kBlocks;
}

const Block* findResident(std::uint16_t functionBlock) {
  for (const Block& block : residentBlocks())
    if (block.id.number == functionBlock) return &block;
  return nullptr;
}

}  // namespace merker::mc5
