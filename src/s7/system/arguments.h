// The parameters of one call: by reference behind the call (FC, SFC), or in the instance (SFB).
// Descriptors of type POINTER and ANY are followed (S7-IND-11, -12).
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cpu/cpu.h"
#include "cpu/memory_access.h"
#include "system/alarms.h"
#include "system/any_pointer.h"
#include "system/basic_communication.h"
#include "system/communication.h"
#include "system/function.h"
#include "system/jobs.h"
#include "system/modules.h"
#include "technology/counting.h"

namespace merker::positioning {
class Positioning;
}
namespace merker::serial {
class Coupling;
}

namespace merker::system {

class Connections;
class SendReceive;

// Bytes in the CPU's memory, or why they cannot be reached.
struct Region {
  std::uint8_t* data = nullptr;
  std::uint32_t length = 0;
  cpu::ErrorCode error = cpu::ErrorCode::None;
  explicit operator bool() const { return error == cpu::ErrorCode::None; }
};

// The `bytes` bytes that `where` points to; L and V are those of the block that runs.
Region regionOf(cpu::Machine& machine, const AnyPointer& where, std::uint32_t bytes,
                cpu::Access access);

// What calls share besides the CPU.
struct Context {
  Modules* modules = nullptr;                // null: none
  technology::Counting* counting = nullptr;  // null: none
  positioning::Positioning* positioning = nullptr;
  serial::Coupling* serial = nullptr;  // null: none
  std::optional<std::uint32_t> serialAddress{};
  std::shared_ptr<serial::Coupling> absentSerial{};  // what calls without a sub-module leave
  Jobs jobs;
  Alarms alarms;
  Communication communication{};
  std::shared_ptr<Connections> connections;  // configured ones
  std::shared_ptr<SendReceive> sendReceive;  // those of a CP
  BasicCommunication partners{};
};

// Of a parameter: its width, and for an SFB where it lies in the instance.
struct ParameterPlace {
  BitAddress address = 0;
  Width width = Width::Bit;
};

// A call and the row of the function that answers it.
struct Invocation {
  const cpu::SystemCall& call;
  const Function& function;
  const std::vector<ParameterPlace>& places;  // of its parameters
  Context& context;
};

// The parameters by their numbers in the row; Call (call.h) knows them by name.
class Arguments {
 public:
  explicit Arguments(const Invocation& invocation)
      : call_(invocation.call),
        function_(invocation.function),
        places_(invocation.places),
        context_(invocation.context) {}

  cpu::Cpu& cpu() { return call_.cpu; }
  cpu::Machine& machine() { return call_.machine; }
  Modules* modules() { return context_.modules; }
  technology::Counting* counting() { return context_.counting; }
  positioning::Positioning* positioning() { return context_.positioning; }
  serial::Coupling* serial() { return context_.serial; }
  std::optional<std::uint32_t> serialAddress() const { return context_.serialAddress; }
  std::shared_ptr<serial::Coupling>& absentSerial() { return context_.absentSerial; }
  Jobs& jobs() { return context_.jobs; }
  Alarms& alarms() { return context_.alarms; }
  const Communication& communication() const { return context_.communication; }
  Connections& connections() { return *context_.connections; }
  SendReceive& sendReceive() { return *context_.sendReceive; }
  BasicCommunication& partners() { return context_.partners; }
  std::uint16_t functionNumber() const { return function_.number; }
  // SFB: whether the instance is long enough for this parameter.
  bool has(std::size_t i);

  // Elementary values by the number of the parameter in its row.
  std::uint32_t value(std::size_t i);
  bool flag(std::size_t i) { return value(i) != 0; }
  std::int32_t integer(std::size_t i) { return static_cast<std::int16_t>(value(i)); }
  std::int32_t longInteger(std::size_t i) { return static_cast<std::int32_t>(value(i)); }
  float real(std::size_t i) { return std::bit_cast<float>(value(i)); }
  void set(std::size_t i, std::uint32_t value);
  void setReal(std::size_t i, float value) { set(i, std::bit_cast<std::uint32_t>(value)); }

  // DT and STRING: the bytes that the POINTER in the caller's local data names.
  Region composite(std::size_t i, std::uint32_t bytes, cpu::Access access);
  AnyPointer any(std::size_t i);
  // POINTER: 6 bytes, number of a data block and an area pointer.
  AnyPointer pointer(std::size_t i);
  // A STRUCT that is written: the ANY must name all of its bytes (S7-SFC-01: length error). Code of
  // STEP 7 hands over a POINTER, which names no length.
  Region structure(std::size_t i, std::uint32_t bytes);
  // The `bytes` bytes that `where` points to.
  Region region(const AnyPointer& where, std::uint32_t bytes, cpu::Access access);

  // RET_VAL of a function that reports errors with it; 8xyy makes BIE 0.
  void status(std::uint32_t code);
  // 8xyy for a parameter (S7-SFC-01).
  void parameterError(std::size_t i, std::uint32_t code);
  void parameterError(std::size_t i, cpu::ErrorCode code) {
    parameterError(i, static_cast<std::uint32_t>(code));
  }
  // For functions that return a value: BIE only.
  void fail() { good_ = false; }
  bool good() const { return good_; }

 private:
  struct Where {
    Area area = Area::None;
    BitAddress address = 0;
  };
  Where placeOf(std::size_t i) const;
  std::optional<std::size_t> returnParameter() const;
  void note(const cpu::SyncError& error) { good_ = good_ && !error; }

  const cpu::SystemCall& call_;
  const Function& function_;
  const std::vector<ParameterPlace>& places_;
  Context& context_;
  bool good_ = true;
};

}  // namespace merker::system
