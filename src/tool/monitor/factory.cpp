// Which machine has which monitor.
#include "monitor/control_monitor.h"
#include "monitor/station_monitor.h"

namespace merker::monitor {

std::unique_ptr<Monitor> monitorOf(controller::Controller& plc, const source::SymbolTable& symbols,
                                   simulator::Resolver resolver) {
  if (auto* control = dynamic_cast<cnc::Cnc*>(&plc))
    return std::make_unique<ControlMonitor>(*control, symbols, std::move(resolver));
  return std::make_unique<StationMonitor>(dynamic_cast<station::Station&>(plc), symbols,
                                          std::move(resolver));
}

}  // namespace merker::monitor
