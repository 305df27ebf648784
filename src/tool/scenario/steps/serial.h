// serial X27 send BYTES: what the partner at the other end of the serial line does, and what
// happens to the line (docs/formats/scenario.md).
#pragma once

#include <string>

#include "scenario/steps/bare.h"
#include "serial/coupling.h"

namespace merker::simulator::steps {

struct Serial {
  static constexpr std::string_view kWords = "serial";

  enum class Does : std::uint8_t {
    Send,
    Answer,
    NoAnswers,
    Partner,
    JobSend,
    JobFetch,
    Memory,
    Cut,
    Connect,
    Swap,
    Straight,
    Noise,
    Disturb,
    Forget
  };
  Does does = Does::Send;
  std::string port;
  Position portPosition;
  serial::Bytes bytes, answer;
  Duration after;
  serial::LinkJob job;
  serial::Coupling::End end = serial::Coupling::End::Cpu;  // who hears it; Disturb: who sends it
  serial::Fault fault;
  std::uint64_t character = 1;
  // Partner
  serial::Partner::Speaks speaks = serial::Partner::Speaks::Characters;
  bool blockCheck = true;
  std::optional<bool> highPriority;
  std::optional<std::uint32_t> baud;
  std::optional<serial::Frame> frame;

  bool parse(const StepLine& line);
  void resolve(const StepBinding& binding);
  bool perform(StepRun& run) const;

 private:
  bool parseAnswer(const StepLine& line, std::string_view text);
  bool parsePartner(const StepLine& line, std::string_view text);
  bool parseJob(const StepLine& line, std::string_view text);
  bool parseMemory(const StepLine& line, std::string_view text);
  bool parseDisturb(const StepLine& line, std::string_view text);
  bool parseEnd(const StepLine& line, std::string_view text);
  void speak(serial::Coupling& coupling, Instant now) const;
  bool begin(StepRun& run, serial::Coupling& coupling) const;
  bool act(StepRun& run, serial::Coupling& coupling) const;
};

// Whether the project has this interface; else a problem.
bool hasSerialPort(const StepBinding& binding, const std::string& port, const Position& position);
// At the time of the PLC; null if it has none.
serial::Coupling* couplingOf(controller::Controller& plc);

}  // namespace merker::simulator::steps
