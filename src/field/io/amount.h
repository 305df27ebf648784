// Lengths of time and electrical amounts as merker.toml and scenarios write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "catalogue/measuring_range.h"
#include "clock/instant.h"

namespace merker::io {

// "0.1ms", "150ms", "2s", "1m"; nothing if it is none.
std::optional<Duration> parseLength(std::string_view text);
std::string formatLength(Duration length);  // "0.1ms", "150ms", "2s"

// "5.5V", "80mV", "18mA", "120Ohm", "-20.5degC" (also Ω, °C, C): in the unit of the quantity.
std::optional<double> parseAmount(std::string_view text, Quantity quantity);
std::string formatAmount(double amount, Quantity quantity);  // "5.5V"

// "7.5m"
std::optional<double> parseMetres(std::string_view text);

}  // namespace merker::io
