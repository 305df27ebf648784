#include "tags/format.h"

#include "tags/csv.h"
#include "tags/fuxa.h"
#include "tags/ignition.h"
#include "tags/kepware.h"
#include "tags/node_red.h"

namespace merker::tags {
namespace {

constexpr Format kFormats[] = {
    {"csv", "a table for any tool, with the addresses of STEP 7", &csv},
    {"fuxa", "FUXA: a device with its tags (Connections, Import)", &fuxa},
    {"node-red", "node-red-contrib-s7: variables of an S7 endpoint (Import)", &nodeRed},
    {"ignition", "Ignition: tags in folders (Tag Browser, Import Tags)", &ignition},
    {"kepware", "Kepware: tags of a Siemens TCP/IP Ethernet device (Import CSV)", &kepware},
};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* findFormat(std::string_view name) {
  for (const Format& format : kFormats)
    if (format.name == name) return &format;
  return nullptr;
}

}  // namespace merker::tags
