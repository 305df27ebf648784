#include "cpu/memory_access.h"

#include "base/bytes.h"
#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

struct Span {
  std::uint8_t* data = nullptr;
  std::uint32_t length = 0;
  bool exists = false;
};

Span open(const OpenBlock& block) { return {block.data, block.length, true}; }

Span local(const Frame* frame) {
  if (frame == nullptr) return {};
  return {frame->local, frame->localLength, true};
}

Span spanOf(Machine& m, Area area) {
  switch (area) {
    case Area::Input:
    case Area::Output:
    case Area::Flag:
      return {m.image + m.areas.base(area), m.areas.length(area), true};
    case Area::DataBlock:
      return open(m.registers.db);
    case Area::Instance:
      return open(m.registers.di);
    case Area::Local:
      return local(m.top);
    case Area::CallerLocal:
      return local(m.caller());
    case Area::Peripheral:
    case Area::None:
      break;
  }
  return {};
}

SyncError fail(ErrorCode code, Area area, Width width, std::uint32_t byte) {
  return {.code = code, .area = area, .width = width, .detail = byte};
}

ErrorCode lengthError(const Machine& m, Area area, Access access, std::uint32_t end) {
  if (access == Access::Read) return ErrorCode::LengthRead;
  if (area == Area::DataBlock && end <= m.registers.db.length) return ErrorCode::ProtectedDb;
  if (area == Area::Instance && end <= m.registers.di.length) return ErrorCode::ProtectedDi;
  return ErrorCode::LengthWrite;
}

std::uint32_t writable(const Machine& m, Area area, std::uint32_t length) {
  if (area == Area::DataBlock) return m.registers.db.writable;
  if (area == Area::Instance) return m.registers.di.writable;
  return length;
}

// Bytes, words and double words begin at bit 0 (S7-IND-07).
bool misaligned(Width width, BitAddress address) {
  return width != Width::Bit && (address & 7) != 0;
}

// PE: the terminals. Only whole bytes (S7-OPND-07, -08).
SyncError readPeripheral(Machine& m, Width width, BitAddress address, std::uint32_t& value) {
  const std::uint32_t byte = address / 8;
  if (width == Width::Bit) return fail(ErrorCode::AreaRead, Area::Peripheral, width, byte);
  if (misaligned(width, address))
    return fail(ErrorCode::AlignmentRead, Area::Peripheral, width, byte);
  if (!m.areas.answers(m.areas.inputPresent, byte, byteCount(width)))
    return fail(ErrorCode::PeripheralRead, Area::Peripheral, width, byte);
  if (byte + byteCount(width) > m.areas.imageBytes) m.outlook.access();
  m.cpu->modules().reading();
  value = loadBytes(&m.areas.inputs[byte], width);
  return {};
}

// PA: the terminals and, inside the process image, the image too (S7-OPND-10).
SyncError writePeripheral(Machine& m, Width width, BitAddress address, std::uint32_t value) {
  const std::uint32_t byte = address / 8, count = byteCount(width);
  if (width == Width::Bit) return fail(ErrorCode::AreaWrite, Area::Peripheral, width, byte);
  if (misaligned(width, address))
    return fail(ErrorCode::AlignmentWrite, Area::Peripheral, width, byte);
  if (!m.areas.answers(m.areas.outputPresent, byte, count))
    return fail(ErrorCode::PeripheralWrite, Area::Peripheral, width, byte);
  std::uint8_t* const outputs = &m.areas.outputs[byte];
  const std::uint32_t before = loadBytes(outputs, width);
  storeBytes(outputs, width, value);
  if (loadBytes(outputs, width) !=
      before)  // a module sees more than what is left at the checkpoint
    m.outlook.until(m.clock, {.at = Look::At::Output, .number = byte});
  for (std::uint32_t i = byte; i < byte + count && i < m.areas.imageBytes; ++i)
    *m.areas.output(i) = m.areas.outputs[i];
  m.cpu->modules().written(byte, count);
  return {};
}

}  // namespace

std::uint32_t loadBytes(const std::uint8_t* bytes, Width width) {
  if (width == Width::DWord) return loadDWord(bytes);
  return width == Width::Word ? loadWord(bytes) : *bytes;
}

void storeBytes(std::uint8_t* bytes, Width width, std::uint32_t value) {
  if (width == Width::DWord) return storeDWord(bytes, value);
  if (width == Width::Word) return storeWord(bytes, value);
  *bytes = static_cast<std::uint8_t>(value);
}

Located locate(Machine& m, Area area, Width width, BitAddress address, Access access) {
  const bool reads = access == Access::Read;
  const std::uint32_t byte = address / 8, end = byte + byteCount(width);
  const Span span = spanOf(m, area);
  if (!span.exists)
    return {.error = fail(reads ? ErrorCode::AreaRead : ErrorCode::AreaWrite, area, width, byte)};
  if (misaligned(width, address))
    return {.error = fail(reads ? ErrorCode::AlignmentRead : ErrorCode::AlignmentWrite, area, width,
                          byte)};
  if (end > (reads ? span.length : writable(m, area, span.length)))
    return {.error = fail(lengthError(m, area, access, end), area, width, byte)};
  if (area == Area::Local) lookAtLocal(m, *m.top, byte, byteCount(width));
  if (area == Area::CallerLocal) lookAtLocal(m, *m.caller(), byte, byteCount(width));
  return {.bytes = span.data + byte,
          .mask = static_cast<std::uint8_t>(1u << (address & 7)),
          .error = {}};
}

SyncError read(Machine& m, Area area, Width width, BitAddress address, std::uint32_t& value) {
  value = 0;  // S7-ERR-03: a faulty read delivers 0
  if (area == Area::Peripheral) return readPeripheral(m, width, address, value);
  const Located place = locate(m, area, width, address, Access::Read);
  if (place.bytes == nullptr) return place.error;
  value = width == Width::Bit ? (*place.bytes & place.mask) != 0 : loadBytes(place.bytes, width);
  return {};
}

SyncError write(Machine& m, Area area, Width width, BitAddress address, std::uint32_t value) {
  if (area == Area::Peripheral) return writePeripheral(m, width, address, value);
  const Located place = locate(m, area, width, address, Access::Write);
  if (place.bytes == nullptr) return place.error;
  if (width != Width::Bit)
    storeBytes(place.bytes, width, value);
  else if (value != 0)
    *place.bytes |= place.mask;
  else
    *place.bytes &= static_cast<std::uint8_t>(~place.mask);
  return {};
}

}  // namespace merker::cpu
