// The modules of a rack as system functions ask for them.
#pragma once

#include "io/rack.h"
#include "profibus/exchange.h"
#include "system/modules.h"

namespace merker::station {

class Modules : public system::Modules {
 public:
  Modules(const io::Rack& rack, profibus::Exchange& exchange) : rack_(rack), exchange_(exchange) {}

  std::vector<system::ModuleInfo> all() const override;
  system::RecordResult readRecord(const system::ModulePlace& place, std::uint8_t number,
                                  std::vector<std::uint8_t>& data) override;
  system::RecordResult writeRecord(const system::ModulePlace& place, std::uint8_t number,
                                   std::span<const std::uint8_t> data) override;
  std::vector<std::uint8_t> configuredRecords(const system::ModulePlace& place) const override;
  std::optional<std::vector<std::uint8_t>> configuredRecord(const system::ModulePlace& place,
                                                            std::uint8_t number) const override;
  std::optional<std::vector<std::uint8_t>> slaveDiagnosis(std::uint32_t address) const override;
  std::uint32_t command(const SlaveCommand& command, Instant now) override;

 private:
  const io::Module* find(const system::ModulePlace& place) const;
  bool answers(const io::Module& module) const;

  const io::Rack& rack_;
  profibus::Exchange& exchange_;
};

}  // namespace merker::station
