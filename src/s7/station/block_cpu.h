// A CPU whose blocks a programming device loads one by one, and whose whole state it takes and
// gives back (S7-MGR, S7-SIM-13).
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "block/block.h"
#include "catalogue/cpu_model.h"
#include "plc/capability.h"
#include "station/engine.h"

namespace merker::cpu {
class Cpu;
struct Snapshot;
}  // namespace merker::cpu

namespace merker::system {
class Alarms;
class Connections;
class SendReceive;
struct Communication;
struct SzlList;
}  // namespace merker::system

namespace merker::station {

class Translations;

class BlockCpu : public controller::Capability {
 public:
  static constexpr std::string_view kName = "memory for single blocks";

  virtual const CpuModel& model() const = 0;
  virtual const block::Program& program() const = 0;
  // The same to be kept: whoever loads blocks makes a new one, this one never changes.
  virtual std::shared_ptr<const block::Program> loaded() const = 0;
  virtual cpu::Cpu& cpu() = 0;
  virtual const cpu::Cpu& cpu() const = 0;
  // A list of the system status, as SFC 51 gives it.
  virtual system::SzlList systemStatus(std::uint32_t list, std::uint32_t index) = 0;
  // Block-related messages, for display devices that log on.
  virtual system::Alarms& alarms() = 0;
  // What the system status list says of connections.
  virtual system::Communication& communication() = 0;
  // Configured connections, for whoever carries them.
  virtual system::Connections& connections() = 0;
  // Those of a CP 343-1, the same.
  virtual system::SendReceive& sendReceive() = 0;
  // In RUN at the next cycle checkpoint, all blocks at once. The reason if the CPU refuses.
  virtual std::string download(std::shared_ptr<const block::Program> program,
                               std::string_view password) = 0;
  // The CPU as it was when this was taken (cpu::Cpu::snapshot), of a station with the same model
  // and configuration. Plants are no part of it: what they drive stays as they drive it.
  virtual void take(const cpu::Snapshot& from, std::shared_ptr<const block::Program> program) = 0;

  // At any time between two calls: the program goes on where it stands. False: there is no compiler
  // for this processor.
  virtual bool setEngine(Engine engine) = 0;
  virtual Engine engine() const = 0;
  // The same with blocks that were translated before. False: they are not what was wanted.
  virtual bool setEngine(Engine engine, const Translations& made) = 0;
  // The blocks that a download or take() brings next, translated before.
  virtual void supply(std::shared_ptr<Translations> made) = 0;
};

}  // namespace merker::station
