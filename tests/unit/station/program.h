// A station with a program written in AWL.
#pragma once

#include <string>
#include <string_view>

#include "station/station.h"

namespace merker::station::test {

class Plc {
 public:
  // Without "ORGANIZATION_BLOCK" the text is the body of OB 1.
  explicit Plc(std::string_view awl, const CpuModel& model = defaultCpuModel());
  Plc(std::string_view awl, const CpuModel& model, CpuParameters parameters);
  Plc(std::string_view awl, const CpuModel& model, io::Configuration hardware);

  Station& operator*() { return station_; }
  Station* operator->() { return &station_; }
  std::uint32_t read(std::string_view operand);
  void write(std::string_view operand, std::uint32_t value);
  bool force(std::string_view operand, std::uint32_t value);
  // And on to the end of the cycle, where values are looked at.
  void run(Duration time) {
    station_.advanceTo(station_.now() + time);
    station_.settle();
  }
  void start() { station_.warmRestart(); }
  // Restarts and runs that many cycles.
  void cycles(std::uint64_t count);
  unsigned lastEvent() const;
  bool hasEvent(unsigned event) const;
  std::size_t countEvents(unsigned event) const;

  address::Reference reference(std::string_view operand) const;

 private:
  std::shared_ptr<const block::Program> program_;
  const CpuModel* model_;
  Station station_;
};

// An OB whose own variables begin behind its start information.
std::string ob(int number, std::string_view body);

std::shared_ptr<const block::Program> compileAwl(std::string_view awl, const CpuModel& model);

}  // namespace merker::station::test
