// SFB 60 SEND_PTP, SFB 61 RCV_PTP, SFB 62 RES_RCVB (technology manual 6.5.1; PTP-SFB60 to -SFB62).
#include "system/serial_block.h"

namespace merker::system {

serial::Coupling& couplingOf(Arguments& a) {
  if (a.serial() != nullptr) return *a.serial();
  auto& absent = a.absentSerial();
  if (!absent) absent = std::make_shared<serial::Coupling>(serial::Parameters{});
  return *absent;
}

bool serialPermitted(Arguments& a, std::uint32_t address, bool computerLink) {
  return a.serial() != nullptr && a.serialAddress() == address &&
         (a.serial()->parameters().protocol == serial::Protocol::ComputerLink) == computerLink;
}

std::uint32_t serialInstance(Arguments& a) {
  const cpu::Registers& r = a.machine().registers;
  return static_cast<std::uint32_t>(r.di.number) << 16 | (r.ar2 >> 3 & 0xFFFF);
}

void serialChanged(Arguments& a) {
  couplingOf(a).advance(a.machine().clock);
  if (couplingOf(a).next() != Instant::never()) a.machine().interrupt();
}

serial::Place serialPlace(Arguments& a, const AnyPointer& where, bool used, cpu::Access access) {
  const Area area = pointerArea(where.pointer);
  const bool given = where.syntax == AnyPointer{}.syntax;
  if (used && given && area != Area::DataBlock && area != Area::Instance)
    a.cpu().failSystemCall(
        {.code = access == cpu::Access::Read ? cpu::ErrorCode::AreaRead : cpu::ErrorCode::AreaWrite,
         .area = area,
         .width = Width::Byte,
         .detail = (where.pointer & 0xFFFFFF) / 8});
  return {where.db, (where.pointer & 0xFFFFFF) / 8};
}

void sendPointToPoint(Sfb<60>& a) {
  constexpr auto kRead = cpu::Access::Read;
  const serial::Control control = serialControl(a, "REQ", false);
  const serial::Place source = serialPlace(a, a.any("SD_1"), control.request, kRead);
  const ProgramBlocks blocks(a.machine(), kRead);
  showSerial(a, "DONE",
             couplingOf(a).blocks().send.call(control, source, a.integer("LEN"), blocks,
                                              a.machine().clock));
}

void receivePointToPoint(Sfb<61>& a) {
  constexpr auto kWrite = cpu::Access::Write;
  const serial::Control control = serialControl(a, "EN_R", false);
  const serial::Place target = serialPlace(a, a.any("RD_1"), control.request, kWrite);
  ProgramBlocks blocks(a.machine(), kWrite);
  const auto received = couplingOf(a).blocks().receive.call(control, target, blocks);
  a.set("LEN", static_cast<std::uint32_t>(received.length));
  showSerial(a, "NDR", received.answer);
}

void clearReceiveBuffer(Sfb<62>& a) {
  const serial::Control control = serialControl(a, "REQ", false);
  showSerial(a, "DONE", couplingOf(a).blocks().clear.call(control));
}

}  // namespace merker::system
