// SFB 63 SEND_RK, SFB 64 FETCH_RK, SFB 65 SERVE_RK (technology manual 6.5.2; PTP-SFB63 to -SFB65).
#include <algorithm>

#include "base/bytes.h"
#include "system/serial_block.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kSyncBytes = 240;

struct SyncBlock {
  cpu::OpenBlock block;
  bool usable = false;  // else it was a programming error
};

// Missing, 0 or too short: as any access to a data block (PTP-OPEN-25).
SyncBlock openSync(Arguments& a, std::uint32_t number) {
  SyncBlock sync{a.machine().dataBlocks.open(number)};
  sync.usable = sync.block.number != 0 && sync.block.writable >= kSyncBytes;
  if (sync.usable) return sync;
  if (sync.block.number == 0)
    a.cpu().failSystemCall({.code = cpu::ErrorCode::DbMissing, .detail = number});
  else
    a.cpu().failSystemCall({.code = sync.block.writable == 0 ? cpu::ErrorCode::ProtectedDb
                                                             : cpu::ErrorCode::LengthWrite,
                            .area = Area::DataBlock,
                            .width = Width::Byte,
                            .detail = kSyncBytes - 1});
  return sync;
}

// Signature, address and owners of the jobs (PTP-SFB63-13); nobody reads them but people.
void mark(const SyncBlock& sync, std::uint32_t address, std::uint16_t offset, unsigned owner) {
  constexpr std::uint16_t kSignature = 0x5054;
  storeWord(sync.block.data, kSignature);
  storeWord(sync.block.data + 2, static_cast<std::uint16_t>(address));
  storeWord(sync.block.data + offset, static_cast<std::uint16_t>(owner));
}

// One block for all calls (PTP-SFB63-12).
bool same(serial::Coupling::Blocks& blocks, std::uint32_t sync) {
  if (blocks.syncBlock == 0) blocks.syncBlock = sync;
  return blocks.syncBlock == sync;
}

template <typename A>
serial::LinkRequest requestOf(A& a) {
  return {.cpu = a.integer("R_CPU"),
          .type = static_cast<char>(a.value("R_TYPE")),
          .block = a.integer("R_DBNO"),
          .offset = a.integer("R_OFFSET") & ~1,  // even in data blocks (PTP-SFB63-06)
          .flagByte = a.integer("R_CF_BYT"),
          .flagBit = a.integer("R_CF_BIT"),
          .length = a.integer("LEN")};
}

// `number`: of the SFB.
template <typename A>
void runJob(A& a, serial::LinkJobBlock& block, const AnyPointer& data, cpu::Access access,
            unsigned number) {
  constexpr std::uint16_t kActive = 6;
  const SyncBlock sync = openSync(a, a.value("SYNC_DB"));
  if (!sync.usable) return a.fail();
  serial::Control control = serialControl(a, "REQ", true);
  control.permitted = control.permitted && same(couplingOf(a).blocks(), a.value("SYNC_DB"));
  serial::LinkRequest request = requestOf(a);
  if (request.type != 'D' && request.type != 'X') request.offset = a.integer("R_OFFSET");
  const serial::Place place = serialPlace(a, data, control.request, access);
  ProgramBlocks blocks(a.machine(), access);
  showSerial(a, "DONE", block.call(control, request, place, blocks, a.machine().clock));
  mark(sync, a.value("LADDR"), kActive, block.running() ? number : 0);
}

// With NDR; in all other calls they have their start values (PTP-SFB65-05).
void showJob(Sfb<65>& a, const std::optional<serial::LinkJob>& job) {
  a.set("L_TYPE", job ? static_cast<std::uint32_t>(job->type) : ' ');
  a.set("L_DBNO", job ? job->block : 0);
  a.set("L_OFFSET", job ? job->offset : 0);
  a.set("L_CF_BYT", job ? job->flag.byte : 0);
  a.set("L_CF_BIT", job ? job->flag.bit : 0);
  a.set("LEN", job ? job->length : 0);
}

}  // namespace

void sendComputerLink(Sfb<63>& a) {
  runJob(a, couplingOf(a).blocks().sendLink, a.any("SD_1"), cpu::Access::Read, 63);
}

void fetchComputerLink(Sfb<64>& a) {
  runJob(a, couplingOf(a).blocks().fetchLink, a.any("RD_1"), cpu::Access::Write, 64);
}

void serveComputerLink(Sfb<65>& a) {
  constexpr std::uint16_t kPassive = 8;
  const SyncBlock sync = openSync(a, a.value("SYNC_DB"));
  if (!sync.usable) return a.fail();
  serial::Control control = serialControl(a, "EN_R", true);
  control.permitted = control.permitted && same(couplingOf(a).blocks(), a.value("SYNC_DB"));
  ProgramMemory memory(a.machine());
  const auto served = couplingOf(a).blocks().serve.call(control, memory, a.machine().clock);
  showJob(a, served.job);
  showSerial(a, "NDR", served.answer);
  const serial::Rk512* link = couplingOf(a).interface().link();
  mark(sync, a.value("LADDR"), kPassive, link != nullptr && link->serving() ? 65 : 0);
}

}  // namespace merker::system
