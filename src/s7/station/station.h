// One PLC put together: CPU, engine, system services, periphery. A value built by arguments; no
// globals, so any number of stations lives in one process. Everything outside (scenarios, command
// line, servers) works through this.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "address/reference.h"
#include "block/block.h"
#include "catalogue/block_library.h"
#include "catalogue/communication.h"
#include "catalogue/cpu_model.h"
#include "catalogue/cpu_parameters.h"
#include "clock/instant.h"
#include "cpu/events_by_hand.h"
#include "cpu/led_panel.h"
#include "cpu/ram_to_rom.h"
#include "cpu/switch_panel.h"
#include "network/node.h"
#include "plant/field.h"
#include "plc/buffered_memory.h"
#include "plc/card_slot.h"
#include "plc/hot_restart.h"
#include "plc/machine_code.h"
#include "plc/ob1_alone.h"
#include "plc/operand_memory.h"
#include "plc/quiet_cycles.h"
#include "positioning/axis_values.h"
#include "serial/serial_port.h"
#include "station/block_cpu.h"

namespace merker::station {

using controller::CheckFailure;
using controller::CheckResult;
using controller::DiagnosticEntry;
using controller::Mode;

struct Options {
  const CpuModel* model = &defaultCpuModel();
  std::optional<CpuParameters> parameters{};  // without: the model's defaults
  std::optional<CommunicationParameters> communication{};
  Libraries libraries = standardLibraries();
  // Without it: docs/compatibility.md, "Without a hardware configuration".
  std::optional<io::Configuration> hardware{};
  plant::Configuration plants{};  // only with a hardware configuration
  std::shared_ptr<const block::Program> program;
  std::int64_t startOfClock =
      0;                  // milliseconds since 1990-01-01 that the CPU's clock shows at Instant 0
  bool coverage = false;  // count how often each instruction runs
  Engine engine = Engine::Interpreter;
};

class Station final : public controller::Controller,
                      public controller::BufferedMemory,
                      public controller::CardSlot,
                      public controller::HotRestart,
                      public controller::MachineCode,
                      public controller::Ob1Alone,
                      public controller::OperandMemory,
                      public controller::QuietCycles,
                      public network::Connectable,
                      public plant::Field,
                      public positioning::AxisOwner,
                      public serial::SerialPort,
                      public cpu::EventsByHand,
                      public cpu::LedPanel,
                      public cpu::RamToRom,
                      public cpu::SwitchPanel,
                      public BlockCpu {
 public:
  explicit Station(Options options);
  ~Station() override;
  Station(Station&&) noexcept;
  Station& operator=(Station&&) noexcept;

  // From now on another station is at the other end of X27; it starts, and the two move through
  // time together (PTP-LINE-03). Both have a serial interface.
  void couple(std::unique_ptr<Station> partner);
  controller::Controller* partner() override;

  // From now on the CPU is a node of an MPI subnet.
  void join(network::Node& node, const network::GlobalData& globalData) override;
  void joinDp(network::Node& node) override;
  void joinWires(network::Node& node, std::size_t partner, bool plant) override;
  void connect(const network::ConnectionEnd& end) override;
  bool maySend() const override;

  const CpuModel& model() const override;
  std::string modelName() const override;
  bool hasColdRestart() const override;
  std::string whyMissing(const address::Reference& reference) const override;
  std::string whyRefused(const address::Reference& reference) const override;
  // In a data block with READ_ONLY, of this station or its partner.
  bool isReadOnly(const address::Reference& reference) const;
  controller::ExecutedLines executedLines() const override;
  const block::Program& program() const override;
  std::shared_ptr<const block::Program> loaded() const override;

  bool setEngine(Engine engine) override;
  Engine engine() const override;
  bool setCompiled(bool on) override;
  void compileWhenItPays(bool elsewhere) override;
  bool compiled() const override { return engine() == Engine::Compiled; }
  void translateNow() override {}  // it has been: setEngine() translates
  std::size_t compiledBytes() const override;
  bool setEngine(Engine engine, const Translations& made) override;
  void supply(std::shared_ptr<Translations> made) override;

  // operating states (S7-STATE)
  Mode mode() const override;
  bool stoppedByFault() const override;  // STOP for another reason than a wish (switch, SFC 46)
  std::string stopReason()
      const override;  // as the diagnostic buffer names it; empty while not in STOP
  // The mode switch (S7-CPU-31); from STOP to RUN or RUN-P it starts the CPU.
  void setSwitch(cpu::SwitchPosition position) override;
  cpu::SwitchPosition switchPosition() const override;
  cpu::Leds leds() const override;
  void memoryReset() override;
  // Restarts put a switch that stands at STOP to RUN-P.
  bool warmRestart() override;  // OB 100, then OB 1; false if refused (no OB 1 …)
  bool start() override { return warmRestart(); }
  bool hasHotRestart() const override;
  bool hotRestart() override;   // OB 101, then on from where STOP came; false if the model has none
  bool coldRestart() override;  // false if the model has none
  bool powered() const override;
  void stop() override;  // mode switch to STOP
  bool halt();           // test operation: in front of the next instruction
  bool resume();         // leaves HALT
  void powerOff() override;
  void powerOn(bool buffered = true) override;  // false: battery empty or card out, RAM is lost
  void setBattery(bool low);                    // OB 81
  bool batteryFails(bool fails) override;
  void removeCard() override;
  void trigger(const cpu::Trigger& event) override;
  // Retentive memory (S7-MEM-02), as it is now; events that `data` has already are not copied
  // again.
  void retentive(block::RetentiveData& data) const;
  // For a new station: it is then switched off and has this in its memory; powerOn() goes on.
  void restore(const block::RetentiveData& data);
  const block::RetentiveData& kept() override;
  // The program is the new one already.
  bool switchOn(const block::RetentiveData& data, const controller::Renewal& renewal) override;
  void take(const cpu::Snapshot& from, std::shared_ptr<const block::Program> program) override;

  // time; nothing moves outside these calls
  Instant now() const override;
  std::uint64_t cycles() const override;
  std::uint64_t instructions() const override;
  // Runs up to t exactly, also into the middle of a cycle; in STOP only time moves.
  void advanceTo(Instant t) override;
  // On to the end of the cycle that runs now: there values are looked at from outside.
  using Controller::settle;
  bool settle(Duration longest) override;
  // Fewer if the CPU goes to STOP or a cycle does not come within 60 s.
  void advanceCycles(std::uint64_t count) override;
  // Runs to the next cycle checkpoint, at most to `limit`; true if it came to a checkpoint. The
  // change from STARTUP to RUN, before the first cycle, counts as one. In STOP time moves to
  // `limit` (false). Scenarios look at values after each cycle with it.
  bool advanceToCheckpoint(Instant limit) override;
  // Runs OB 1 once, back to back, without the operating system's share of the cycle and without
  // cycle monitoring: for measurements. False if it did not end within `most`; the next call goes
  // on with it then.
  bool runOb1(Duration most = Duration::seconds(60)) override;

  // values (bits as 0/1). Reading an input shows its process image; `write` to an input sets its
  // terminal, from where the image takes it at the next cycle; other areas are written at once.
  // PE is the input terminals, PA the output side. A force acts at once and holds until unforced.
  // Timer and counter: Width::Bit is the status bit, any other width the coded value as LC loads it
  // (S5TIME, BCD).
  std::optional<std::uint32_t> read(const address::Reference& reference) const override;
  bool write(const address::Reference& reference, std::uint32_t value) override;
  bool force(const address::Reference& reference, std::uint32_t value) override;
  void unforce() override;
  // The bytes of a DATE_AND_TIME or STRING (Reference::bytes), as they lie in memory.
  std::optional<std::vector<std::uint8_t>> readBytes(
      const address::Reference& reference) const override;
  bool writeBytes(const address::Reference& reference,
                  std::span<const std::uint8_t> bytes) override;
  void copyOperands(controller::OperandImage& image) const override;

  // The modules and their terminals, with station.now() as the time; null without a hardware
  // configuration. Changes reach the CPU at its next instruction boundary.
  io::Rack* rack() override;
  const io::Rack* rack() const override;
  // The plants wired to them, moved by the station's time; null without a hardware configuration.
  plant::Plants* plants() override;
  const plant::Plants* plants() const override;
  const positioning::Channel* axis() const override;
  serial::Coupling* serial() override;

  const std::vector<DiagnosticEntry>& diagnostics() const override;
  const std::vector<CheckResult>& checkResults() const override;
  // With Options::coverage: how often each instruction ran, by block and byte offset of its code;
  // those that never ran may be missing.
  std::map<BlockId, std::map<std::uint32_t, std::uint64_t>> executed() const;

  // "Copy RAM to ROM", in STOP: the actual values of data blocks become those of load memory
  // (S7-MEM-04); program() then has them. The reason why not, as text.
  std::string copyRamToRom(std::string_view password = {}) override;
  // Blocks changed, added or deleted while the CPU works (S7-CYCLE-05): they count from the next
  // cycle checkpoint on. The reason why not, as text; empty if it was accepted.
  std::string download(std::shared_ptr<const block::Program> program,
                       std::string_view password = {}) override;
  // Whether programming devices may read or write (S7-MEM-05, S7-SIM-11).
  bool mayRead(std::string_view password = {}) const;
  bool mayWrite(std::string_view password = {}) const;

  // The CPU itself, for the monitor: stacks, probes, forces.
  cpu::Cpu& cpu() override;
  system::SzlList systemStatus(std::uint32_t list, std::uint32_t index) override;
  const cpu::Cpu& cpu() const override;
  system::Alarms& alarms() override;
  system::Communication& communication() override;
  system::Connections& connections() override;
  system::SendReceive& sendReceive() override;

  // Called after each change of simulated time at a cycle checkpoint: traces look at values here.
  void onCycle(std::function<void(controller::Controller&)> observer) override;
  void onChange(std::function<void(controller::Controller&)> observer) override;

  void passQuietCycles(Instant limit, Instant enough) override;
  void passOverQuietCycles(bool on) override;
  std::uint64_t cyclesPassedOver() const override;
  std::vector<Reason> whyComputed() const override;

 private:
  struct Parts;
  void moveTo(Instant t);
  bool nobodyLooks() const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace merker::station
