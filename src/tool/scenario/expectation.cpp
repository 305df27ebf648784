#include "scenario/expectation.h"

namespace merker::simulator {

using controller::Controller;

namespace {

template <typename E>
concept HasNeeds = controller::IsCapability<typename E::Needs>;

}  // namespace

bool speaksOfState(const AnyExpectation& expectation) {
  return std::visit([]<IsExpectation E>(const E&) { return E::kSpeaksOfState; }, expectation);
}

std::string_view missing(const AnyExpectation& expectation, const Controller& plc) {
  return std::visit(
      [&]<IsExpectation E>(const E&) -> std::string_view {
        if constexpr (HasNeeds<E>)
          return controller::capability<typename E::Needs>(plc) == nullptr ? E::Needs::kName : "";
        else
          return {};
      },
      expectation);
}

bool holds(const AnyExpectation& expectation, Controller& plc) {
  return std::visit([&](const IsExpectation auto& one) { return one.holds(plc); }, expectation);
}

std::optional<Instant> staysUntil(const AnyExpectation& expectation, const Controller& plc) {
  return std::visit(
      [&](const IsExpectation auto& one) -> std::optional<Instant> {
        if constexpr (requires { one.staysUntil(plc); })
          return one.staysUntil(plc);
        else
          return std::nullopt;
      },
      expectation);
}

std::string actual(const AnyExpectation& expectation, Controller& plc) {
  return std::visit([&](const IsExpectation auto& one) { return one.actual(plc); }, expectation);
}

}  // namespace merker::simulator
