// The sub-module 2.1 of a compact CPU, between its coupling and the rack.
#pragma once

#include <memory>

#include "io/rack.h"
#include "serial/coupling.h"

namespace merker::station {

class SerialModule {
 public:
  // The rack must outlive it. A project that does not name the sub-module has none.
  explicit SerialModule(io::Rack& rack);

  serial::Coupling* coupling() { return coupling_.get(); }
  std::uint32_t address() const { return address_; }

  void start(Instant now);  // the CPU starts, or stops
  void stop(Instant now);
  void supply(bool on, Instant now);
  Instant next() const;
  void advance(Instant now);

 private:
  bool put() const;  // the rack has a line break

  io::Rack& rack_;
  std::uint32_t module_ = 0, address_ = 0;
  std::unique_ptr<serial::Coupling> coupling_;
  bool broken_ = false;  // as the rack was told
};

}  // namespace merker::station
