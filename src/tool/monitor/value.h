// The value of any operand: bits, or the content of a DATE_AND_TIME or STRING.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "monitor/display_format.h"
#include "plc/controller.h"
#include "scenario/term.h"

namespace merker::monitor {

struct Value {
  std::uint32_t bits = 0;
  std::string content;  // of a DATE_AND_TIME or STRING (scenario/long_value.h)
  bool operator==(const Value&) const = default;
};

// Nothing, or false, if there is no such operand.
std::optional<Value> read(const controller::Controller& plc, const address::Reference& reference);
bool write(controller::Controller& plc, const address::Reference& reference, const Value& value);

// The problem if this operand cannot be shown so: P1209.
std::optional<Problem> checkFormat(const address::Reference& reference, DisplayFormat format);
std::string show(const address::Reference& reference, const Value& value, DisplayFormat format);
// As the user types it: parseValue, or the constant of a DATE_AND_TIME or STRING (P0960, P0961).
Result<Value> parse(const address::Reference& reference, std::string_view text,
                    DisplayFormat format);

// The same with the constants of the machine's language: KF, KH, KT … of STEP 5.
Result<Value> parse(const address::Reference& reference, std::string_view text,
                    DisplayFormat format, const simulator::Resolver::Constants& constants);

}  // namespace merker::monitor
