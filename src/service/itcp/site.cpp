#include "itcp/site.h"

#include <fmt/format.h>

#include <utility>

#include "itcp/cpu_page.h"

namespace merker::itcp {
namespace {

constexpr unsigned kNotFound = 404;
constexpr std::string_view kCpuPage = "cpu.html", kCpuJson = "cpu.json", kFirst = "index.html";

}  // namespace

Site::Site(served::Exchange& plc, std::string folder)
    : plc_(plc), folder_(std::move(folder)), values_(std::make_shared<PageValues>(plc)) {}

void Site::page(const std::string& target, Done done) {
  const auto path = pathOf(target);
  if (path == kCpuPage || path == kCpuJson) return cpu(path == kCpuJson, std::move(done));
  if (auto found = path ? pageFile(folder_, *path) : std::nullopt)
    return file(std::move(*found), std::move(done));
  if (path == kFirst) return cpu(false, std::move(done));
  done({.status = kNotFound, .bytes = "There is no such page; /cpu.html shows the CPU.\n"});
}

void Site::facts(FactsDone done) {
  if (facts_) return done(*facts_);
  waiting_.push_back(std::move(done));
  if (waiting_.size() > 1) return;
  plc_.order([weak = weak_from_this()](const monitor::Monitor* monitor) -> served::Exchange::Call {
    CpuFacts found;
    found.mode = "no answer";
    if (monitor != nullptr) found = factsOf(*monitor);
    return [weak, found = std::move(found)] {
      const auto self = weak.lock();
      if (!self) return;
      self->facts_ = found;
      for (const FactsDone& one : std::exchange(self->waiting_, {})) one(found);
    };
  });
}

void Site::cpu(bool asJson, Done done) {
  facts([asJson, done = std::move(done)](const CpuFacts& facts) {
    done({.type = asJson ? "application/json" : "text/html; charset=utf-8",
          .bytes = asJson ? cpuJson(facts) : cpuPage(facts)});
  });
}

void Site::file(PageFile file, Done done) {
  const std::string type(file.type);
  if (file.escape == Escape::None) return done({.type = type, .bytes = std::move(file.bytes)});
  const auto bytes = std::make_shared<const std::string>(std::move(file.bytes));
  PageTemplate page = split(*bytes);
  std::vector<std::string> names = page.names;
  values_->read(std::move(names), [bytes, type, escape = file.escape, page = std::move(page),
                                   done = std::move(done)](const std::vector<PageValue>& values) {
    done({.type = type, .bytes = fill(page, values, escape)});
  });
}

}  // namespace merker::itcp
