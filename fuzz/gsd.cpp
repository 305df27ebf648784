// GSD files in any encoding.
#include "gsd/configuration.h"
#include "gsd/parameters.h"
#include "gsd/read.h"
#include "harness.h"

using namespace merker;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text(data, size);
  const source::SourceFile file = gsd::decode("a.gsd", std::string(bytes));
  const gsd::Reading reading = gsd::read(file);
  for (const gsd::Remark& remark : reading.remarks)
    fuzz::require(remark.line <= file.lineCount(), "a remark is in the file");
  for (const gsd::Module& module : reading.device.modules) {
    const gsd::Areas areas = gsd::readIdentifiers(module.configuration);
    fuzz::require(areas.areas.size() <= module.configuration.size(), "an identifier has a byte");
    (void)gsd::standardParameters(module.parameters, reading.device);
  }
  return 0;
}
