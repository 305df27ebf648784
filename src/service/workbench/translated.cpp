#include "workbench/translated.h"

#include "cpu/cpu.h"

namespace merker::workbench {
namespace {

// As long as this is the same, what was made for it fits.
struct Loaded {
  ProgramRef program;
  station::Engine engine;
  bool operator==(const Loaded&) const = default;
};

Loaded loaded(const Call& call) {
  return {call.blockCpu().cpu().program(), call.blockCpu().engine()};
}

Answer translated(const Call& call, station::Engine engine, ProgramRef program, ProgramRef before,
                  std::function<Answer(const Call&, Translations&)> then) {
  return elsewhere<Translations>(
      call, call.shared.work,
      [engine, program = std::move(program), before = std::move(before),
       &model = call.blockCpu().model()](const Aside& aside) {
        return std::make_shared<station::Translations>(model, engine, program, before.get(),
                                                       aside.stop);
      },
      std::move(then));
}

}  // namespace

// Another browser may be quicker: once more then, for what the CPU has now.
Answer supplied(const Call& call, ProgramRef program, std::function<Answer(const Call&)> then) {
  const Loaded now = loaded(call);
  return translated(call, now.engine, program, now.program,
                    [now, program, then](const Call& here, Translations& made) {
                      if (loaded(here) != now) return supplied(here, program, then);
                      here.blockCpu().supply(made);
                      return then(here);
                    });
}

Answer translatedFor(const Call& call, station::Engine engine,
                     std::function<Answer(const Call&, const station::Translations&)> then) {
  const Loaded now = loaded(call);
  return translated(call, engine, now.program, nullptr,
                    [now, engine, then](const Call& here, Translations& made) {
                      if (loaded(here) != now) return translatedFor(here, engine, then);
                      return then(here, *made);
                    });
}

}  // namespace merker::workbench
