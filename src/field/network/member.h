// One station of a network as a PLC: whoever moves it moves all, and a reference to an operand of
// another station reaches that one.
#pragma once

#include "network/network.h"
#include "plc/capability.h"

namespace merker::network {

class Member final : public controller::Controller {
 public:
  Member(Network& network, std::size_t number) : network_(network), number_(number) {}

  Network& network() const { return network_; }
  controller::Controller& itself() override { return network_.itself(number_); }
  const controller::Controller& itself() const override { return network_.itself(number_); }

  std::string modelName() const override { return itself().modelName(); }
  controller::Mode mode() const override { return itself().mode(); }
  bool stoppedByFault() const override { return itself().stoppedByFault(); }
  std::string stopReason() const override { return itself().stopReason(); }
  bool powered() const override { return itself().powered(); }
  bool hasColdRestart() const override { return itself().hasColdRestart(); }
  bool start() override { return itself().start(); }
  bool warmRestart() override { return itself().warmRestart(); }
  bool coldRestart() override { return itself().coldRestart(); }
  void stop() override { itself().stop(); }
  void powerOff() override { itself().powerOff(); }
  void powerOn(bool buffered) override { itself().powerOn(buffered); }
  void memoryReset() override { itself().memoryReset(); }
  std::string fault(std::string_view subject, std::string_view kind, bool on) override {
    return itself().fault(subject, kind, on);
  }
  bool batteryFails(bool fails) override { return itself().batteryFails(fails); }

  Instant now() const override { return itself().now(); }
  std::uint64_t cycles() const override { return itself().cycles(); }
  std::uint64_t instructions() const override { return itself().instructions(); }
  void advanceTo(Instant t) override { network_.advanceTo(t); }
  using Controller::settle;
  bool settle(Duration longest) override { return network_.settle(number_, longest); }
  void advanceCycles(std::uint64_t count) override { network_.advanceCycles(number_, count); }
  bool advanceToCheckpoint(Instant limit) override {
    return network_.advanceToCheckpoint(number_, limit);
  }
  // On the thread that moves the station.
  void onCycle(std::function<void(Controller&)> observer) override {
    itself().onCycle(std::move(observer));
  }

  std::optional<std::uint32_t> read(const address::Reference& reference) const override;
  bool write(const address::Reference& reference, std::uint32_t value) override;
  bool force(const address::Reference& reference, std::uint32_t value) override;
  void unforce() override { itself().unforce(); }
  std::optional<std::vector<std::uint8_t>> readBytes(
      const address::Reference& reference) const override;
  bool writeBytes(const address::Reference& reference,
                  std::span<const std::uint8_t> bytes) override;
  std::string whyMissing(const address::Reference& reference) const override;
  std::string whyRefused(const address::Reference& reference) const override;

  const std::vector<controller::DiagnosticEntry>& diagnostics() const override {
    return itself().diagnostics();
  }
  const std::vector<controller::CheckResult>& checkResults() const override {
    return itself().checkResults();
  }
  controller::ExecutedLines executedLines() const override { return itself().executedLines(); }

 private:
  controller::Controller& owner(const address::Reference& reference) const;

  Network& network_;
  std::size_t number_;
};

}  // namespace merker::network
