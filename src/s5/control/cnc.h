// One SINUMERIK 810/820 GA3: PLC, function macros and the NC data behind them. A value of virtual
// time built by arguments; any number of them live in one process.
#pragma once

#include <memory>
#include <string>

#include "nc/function_macros.h"
#include "plc/buffered_memory.h"
#include "plc/checked_start.h"
#include "plc/machine_code.h"
#include "plc/ob1_alone.h"
#include "plc/operand_memory.h"
#include "plc/quiet_cycles.h"
#include "plc/stop_screens.h"
#include "softplc/plc.h"
#include "softplc/sinumerik_model.h"

namespace merker::cnc {

// Sampling time: a machine datum of the NC that the PLC reads, too (7.3).
constexpr unsigned kSamplingDatum = 155;

struct MachineDatum {
  unsigned number = 0;  // word 0 … 9, 155, 1000 … 1007, byte 2000 … 2010
  std::uint16_t value = 0;
};

// The control on the other side of the coupling area (FB 190).
struct CouplingOptions {
  std::string partner;  // its project folder, as the project names it
  Position named;
  nc::Side side = nc::Side::Control;  // of this control
};

struct Options {
  const SinumerikModel* model = &defaultSinumerikModel();
  sinumerik::Options plc{};  // its `macros` are those of this control
  // What differs from the standard machine data.
  std::vector<MachineDatum> machineData{};
  nc::MacroOptions macros{};
  nc::Control control{};                                      // data of the NC at the start
  sinumerik::BitMapping bits = sinumerik::BitMapping::Table;  // of MD 2003
  std::optional<CouplingOptions> coupling{};
  bool compiled = false;  // run as machine code of this computer what can be
  // Where the project names the bits of the user alarms and messages, for problems.
  Position alarmsNamed{}, messagesNamed{};
};

class Cnc final : public controller::Controller,
                  public controller::BufferedMemory,
                  public controller::CheckedStart,
                  public controller::MachineCode,
                  public controller::Ob1Alone,
                  public controller::OperandMemory,
                  public controller::QuietCycles,
                  public controller::StopScreens {
 public:
  explicit Cnc(Options options);
  ~Cnc() override;
  Cnc(const Cnc&) = delete;
  Cnc& operator=(const Cnc&) = delete;

  sinumerik::Plc& plc();
  const sinumerik::Plc& plc() const;
  nc::Control& control();
  // From now on the two are coupled and move through time together: `partner` follows this one.
  void couple(std::unique_ptr<Cnc> partner, nc::Side side);
  nc::CouplingArea* couplingArea();  // null: there is none
  // Of the partner, too.
  bool setCompiled(bool on) override;
  void compileWhenItPays(bool elsewhere) override;
  bool compiled() const override;
  void translateNow() override;
  std::size_t compiledBytes() const override;
  static bool canCompile();
  bool runOb1(Duration most) override;
  // Test functions over the probes of plc(): HALT, in which a coupled partner stands, too, and a
  // probe of the partner holds both. Time moves as in plc.h.
  bool hold();
  bool resume();
  void runTo(Instant t);
  void runToCheckpoint(Instant t);

  std::string modelName() const override;
  controller::Mode mode() const override;
  bool stoppedByFault() const override;
  std::string stopReason() const override;
  bool powered() const override;
  bool hasColdRestart() const override { return true; }
  bool start() override;        // AG-Start of the programmer: Neustart
  bool warmRestart() override;  // Wiederanlauf; refused where MD 2003 bit 3 does not allow it
  bool coldRestart() override;  // Neustart
  bool startFailed() const override;
  void stop() override;
  void powerOff() override;
  void powerOn(bool buffered) override;
  // Urlöschen and loading of the program: everything as it was built, only time goes on.
  void memoryReset() override;
  std::string fault(std::string_view subject, std::string_view kind, bool on) override;
  bool batteryFails(bool fails) override;
  const block::RetentiveData& kept() override;
  // Blocks that the card has anew are loaded over those that were kept.
  bool switchOn(const block::RetentiveData& data, const controller::Renewal& renewal) override;
  controller::Controller* partner() override;

  Instant now() const override;
  std::uint64_t cycles() const override;
  std::uint64_t instructions() const override;
  void advanceTo(Instant t) override;
  using Controller::settle;
  bool settle(Duration longest) override;
  void advanceCycles(std::uint64_t count) override;
  bool advanceToCheckpoint(Instant limit) override;
  void onCycle(std::function<void(controller::Controller&)> observer) override;
  void onChange(std::function<void(controller::Controller&)> observer) override;
  void passQuietCycles(Instant limit, Instant enough) override;
  void passOverQuietCycles(bool on) override;
  std::uint64_t cyclesPassedOver() const override;
  std::vector<Reason> whyComputed() const override;

  std::optional<std::uint32_t> read(const address::Reference& reference) const override;
  bool write(const address::Reference& reference, std::uint32_t value) override;
  bool force(const address::Reference& reference, std::uint32_t value) override;
  void unforce() override;
  bool forced() const;  // anything, also of the partner
  std::string whyMissing(const address::Reference& reference) const override;
  std::string whyRefused(const address::Reference& reference) const override;
  // Whether the NC takes these digits for a datum.
  bool takes(const address::Reference& datum, std::string_view digits) const;
  std::optional<std::string> stackField(std::string_view stack,
                                        std::string_view field) const override;
  std::string stackFields(std::string_view stack) const override;
  std::string stopDetails() const override;
  // Data of the NC as digits with a point (nc/datum.h).
  std::optional<std::vector<std::uint8_t>> readBytes(const address::Reference& r) const override;
  bool writeBytes(const address::Reference& r, std::span<const std::uint8_t> digits) override;
  // Data blocks as bytes, the left one of each word first.
  void copyOperands(controller::OperandImage& image) const override;

  const std::vector<controller::DiagnosticEntry>& diagnostics() const override;
  const std::vector<controller::CheckResult>& checkResults() const override;
  controller::ExecutedLines executedLines() const override;

 private:
  struct Parts;
  void watch();
  void decideOnQuietCycles();
  void meet();
  void standTogether();
  void connect();
  std::unique_ptr<Parts> parts_;
};

}  // namespace merker::cnc
