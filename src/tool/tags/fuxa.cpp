#include "tags/fuxa.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tags/address.h"

namespace merker::tags {
namespace {

using Json = nlohmann::ordered_json;

// Its driver knows inputs, outputs, flags and data blocks, each by the address of STEP 7 without
// blanks: "DB1.DBW4", "I0.0".
bool known(const Tag& tag) {
  const bool area = tag.area == TagArea::Input || tag.area == TagArea::Output ||
                    tag.area == TagArea::Flag || tag.area == TagArea::Data;
  return area && !fuxaType(tag.type).empty();
}

std::string addressOf(const Tag& tag) {
  std::string text = step7Address(tag, Mnemonics::International);
  std::erase(text, ' ');
  return text;
}

// Tags have identifiers that stay the same when the list is made again.
std::string identifier(const Tag& tag) { return fmt::format("t_{}", fullName(tag)); }

Json tagJson(const Tag& tag) {
  return {{"id", identifier(tag)},
          {"name", fullName(tag)},
          {"type", fuxaType(tag.type)},
          {"address", addressOf(tag)},
          {"description", tag.comment},
          {"daq", {{"enabled", false}, {"interval", 60}, {"changed", false}, {"restored", false}}}};
}

}  // namespace

// A CPU 31x stands in rack 0, slot 2.
Output fuxa(const std::vector<Tag>& tags, const FormatOptions& options) {
  Output output;
  Json list = Json::object();
  for (const Tag& tag : tags)
    if (known(tag))
      list[identifier(tag)] = tagJson(tag);
    else
      output.left.push_back(fullName(tag));
  const Json device{{"id", "d_" + options.device},
                    {"name", options.device},
                    {"enabled", true},
                    {"type", "SiemensS7"},
                    {"polling", 1000},
                    {"property", {{"address", options.address}, {"rack", "0"}, {"slot", "2"}}},
                    {"tags", list}};
  output.text = Json::array({device}).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  return output;
}

}  // namespace merker::tags
