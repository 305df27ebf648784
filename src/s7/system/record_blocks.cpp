// SFB 52 RDREC, 53 WRREC, 54 RALRM (S7-SFB-09). STATUS: the function (DE reading, DF writing), 80,
// and the second byte of the code that SFC 59 or 58 would give.
#include <algorithm>

#include "base/bytes.h"
#include "system/records.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kReading = 0xDE, kWriting = 0xDF;
constexpr std::uint32_t kOutputId = 0x8000;  // bit 15 of ID: an address of outputs

template <typename A>
RecordTarget targetOf(A& a) {
  const std::uint32_t id = a.value("ID");
  const auto record = static_cast<std::uint16_t>(a.integer("INDEX"));
  const std::uint32_t area = (id & kOutputId) != 0 ? kOutputArea : kInputArea;
  return recordTarget(a, area, id & 0x7FFF, record);
}

// `done`: VALID or DONE.
template <typename A>
void report(A& a, NameIn<A> done, std::uint32_t function, std::uint32_t code) {
  const bool error = (code & 0x8000) != 0;
  a.set(done, code == 0);
  a.set("BUSY", code == kJobBegins);
  a.set("ERROR", error);
  a.set("STATUS", error ? function << 24 | 0x800000u | (code & 0xFF) << 8 : code << 8);
  if (error) a.fail();
}

bool isModuleInterrupt(std::uint8_t ob) { return (ob >= 40 && ob <= 47) || ob == 82 || ob == 83; }

// As many bytes as the target has room for.
void store(Sfb<54>& a, Sfb<54>::Name parameter, const std::uint8_t* bytes, std::uint32_t count) {
  const AnyPointer where = a.any(parameter);
  count = std::min(count, byteCount(where));
  const Region region = a.region(where, count, cpu::Access::Write);
  if (count != 0 && region) std::copy_n(bytes, count, region.data);
}

}  // namespace

void readRecordBlock(Sfb<52>& a) {
  RecordTarget target = targetOf(a);
  const AnyPointer where = a.any("RECORD");
  if (target.code == 0 && where.type != TypeCode::Byte) target.code = kNotByte;
  std::uint32_t code = proceed(a, target, a.flag("REQ"));
  if (code != 0) return report(a, "VALID", kReading, code);
  std::vector<std::uint8_t> data;
  code = readFrom(a, target, data);
  // MLEN 0: as long as the record is
  const auto length = static_cast<std::uint32_t>(data.size());
  const auto most = static_cast<std::uint32_t>(std::max(a.integer("MLEN"), 0));
  const Region region = a.region(where, length, cpu::Access::Write);
  const bool fits = where.count >= length && (most == 0 || most >= length) && region;
  if (code == 0 && !fits) code = kWrongLength;
  if (code == 0) {
    std::copy(data.begin(), data.end(), region.data);
    a.set("LEN", length);
  }
  report(a, "VALID", kReading, code);
}

void writeRecordBlock(Sfb<53>& a) {
  RecordTarget target = targetOf(a);
  std::vector<std::uint8_t> data;
  if (target.code == 0) target.code = recordBytes(a, a.any("RECORD"), data);
  const std::int32_t length = a.integer("LEN");
  if (target.code == 0 && (length < 1 || length > static_cast<std::int32_t>(data.size())))
    target.code = kWrongLength;
  std::uint32_t code = proceed(a, target, a.flag("REQ"));
  if (code == 0) {
    data.resize(static_cast<std::size_t>(length));
    code = writeTo(a, target, data);
  }
  report(a, "DONE", kWriting, code);
}

// The interrupt of the OB that calls. MODE 0: who it was; 1: everything; 2: only if it was F_ID.
// TINFO gets the start information, AINFO the module's four bytes.
void receiveInterrupt(Sfb<54>& a) {
  constexpr std::uint32_t kInformation = 4;
  const auto& level = a.machine().levels.back();
  const std::uint8_t* start = level.start.data();
  const std::uint32_t id = loadWord(start + 6) | (start[5] == kOutputArea ? kOutputId : 0u);
  const std::int32_t mode = a.integer("MODE");
  const bool wanted = isModuleInterrupt(level.ob) && (mode != 2 || a.value("F_ID") == id);
  a.set("STATUS", 0);
  a.set("NEW", wanted);
  a.set("ID", wanted ? id : 0);
  a.set("LEN", wanted ? kInformation : 0);
  if (!wanted || mode == 0) return;
  store(a, "TINFO", start, static_cast<std::uint32_t>(level.start.size()));
  const auto most = static_cast<std::uint32_t>(std::max(a.integer("MLEN"), 0));
  store(a, "AINFO", start + 8, most == 0 ? kInformation : std::min(most, kInformation));
}

}  // namespace merker::system
