#include "tags/fuxa.h"

#include <nlohmann/json.hpp>

#include "tags/address.h"
#include "tags/names.h"

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

Json tagJson(const Tag& tag, const std::string& identifier, const std::string& name) {
  return {{"id", identifier},
          {"name", name},
          {"type", fuxaType(tag.type)},
          {"address", addressOf(tag)},
          {"description", tag.comment},
          {"daq", {{"enabled", false}, {"interval", 60}, {"changed", false}, {"restored", false}}}};
}

}  // namespace

// A CPU 31x stands in rack 0, slot 2.
Output fuxa(const std::vector<Tag>& tags, const FormatOptions& options) {
  Output output;
  UniqueNames unique;
  Json::object_t list;  // its operator[] and emplace() look through all of it
  for (const Tag& tag : tags) {
    if (!known(tag)) {
      output.left.push_back(fullName(tag));
      continue;
    }
    // Identifiers stay the same when the list is made again.
    const std::string name = unique(fullName(tag)), identifier = "t_" + name;
    list.push_back({identifier, tagJson(tag, identifier, name)});
  }
  const Json device{{"id", "d_" + options.device},
                    {"name", options.device},
                    {"enabled", true},
                    {"type", "SiemensS7"},
                    {"polling", 1000},
                    {"property", {{"address", options.address}, {"rack", 0}, {"slot", 2}}},
                    {"tags", std::move(list)}};
  output.text = Json::array({device}).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  return output;
}

}  // namespace merker::tags
