// 28h and 29h: services that are named, with an argument ("P_PROGRAM" is the user program), and
// stop.
#include <optional>
#include <string_view>

#include "base/bytes.h"
#include "s7comm/block_name.h"
#include "s7comm/services.h"

namespace merker::s7comm {
namespace {

constexpr std::string_view kProgram = "P_PROGRAM";

// What Snap7 and STEP 7 look at behind the function.
constexpr std::uint8_t kCannot = 0x02, kAlreadyRuns = 0x03, kAlreadyStopped = 0x07;

// A length of one octet and so many characters, which end the parameters.
std::string_view lastText(View bytes) {
  if (bytes.empty() || bytes.size() - 1 != bytes[0]) return {};
  return {reinterpret_cast<const char*>(bytes.data()) + 1, bytes[0]};
}

struct Invocation {
  std::string_view argument, name;
};

// Function, 6 octets, FD, length of the argument, argument, name.
std::optional<Invocation> invocationOf(View p) {
  constexpr std::size_t kArgument = 10;
  if (p.size() < kArgument) return std::nullopt;
  const std::size_t length = loadWord(&p[8]);
  if (p.size() - kArgument < length) return std::nullopt;
  const View argument = p.subspan(kArgument, length);
  return Invocation{{reinterpret_cast<const char*>(argument.data()), argument.size()},
                    lastText(p.subspan(kArgument + length))};
}

// With the function and why, as CPUs answer (8402h 29 07 in STOP, D209h 28 02 of a missing block).
void refuse(const Job& job, Error error, std::uint8_t why) {
  const std::uint8_t answer[] = {job.function, why};
  job.answer(answer, {}, error);
}

void control(const Job& job, Control wish) {
  job.plc().control(wish, job.password(), [begun = job.begun(), wish](Controlled how) {
    if (how == Controlled::Protected) {
      begun.refuse(Error::NeedsPassword);
      return begun.ended();
    }
    const std::uint8_t already = wish == Control::Stop ? kAlreadyStopped : kAlreadyRuns;
    if (how == Controlled::Done)
      begun.answer(View(&begun.function, 1));
    else if (how == Controlled::Already)
      refuse(begun, Error::WrongObjectState, already);
    else
      refuse(begun, Error::CannotBeDone, kCannot);
    begun.ended();
  });
}

struct ControlService {
  std::string_view name, argument;
  Control wish;
};

constexpr ControlService kControlServices[] = {
    {kProgram, "", Control::WarmRestart},
    {kProgram, "C ", Control::ColdRestart},
    {"_MODU", "EP", Control::CopyRamToRom},
    {"_GARB", "", Control::Compress},
};

struct BlockService {
  std::string_view name;
  void (BlockStore::*order)(const std::vector<BlockName>&, const std::string& password,
                            BlockStore::Done);
};

constexpr BlockService kBlockServices[] = {
    {"_INSE", &BlockStore::link},
    {"_INS2", &BlockStore::link},
    {"_DELE", &BlockStore::remove},
};

// How many, 0, their names. Nothing: there is none, or one that is no name.
std::vector<BlockName> namesOf(std::string_view argument) {
  constexpr std::size_t kNamesBegin = 2, kNameLength = 8;
  const View octets(reinterpret_cast<const std::uint8_t*>(argument.data()), argument.size());
  if (octets.size() < kNamesBegin || octets.size() != kNamesBegin + octets[0] * kNameLength)
    return {};
  std::vector<BlockName> names;
  for (std::size_t at = kNamesBegin; at < octets.size(); at += kNameLength) {
    const auto name = blockNameOf(octets.subspan(at, kNameLength));
    if (!name) return {};
    names.push_back(*name);
  }
  return names;
}

void order(const Job& job, const BlockService& service, std::string_view argument) {
  const std::vector<BlockName> names = namesOf(argument);
  if (names.empty()) return job.refuse(Error::WrongBlockName);
  (job.plc().*service.order)(names, job.password(), [begun = job.begun()](Error error) {
    error == Error::None ? begun.answer(View(&begun.function, 1)) : refuse(begun, error, kCannot);
    begun.ended();
  });
}

}  // namespace

void serveProgramInvocation(const Job& job) {
  const auto invocation = invocationOf(job.parameters);
  if (!invocation) return job.refuse(Error::WrongPduSize);
  const auto& [argument, name] = *invocation;
  for (const ControlService& one : kControlServices)
    if (name == one.name && argument == one.argument) return control(job, one.wish);
  for (const BlockService& one : kBlockServices)
    if (name == one.name) return order(job, one, argument);
  job.refuse(Error::FunctionNotAvailable);
}

// Function, 5 octets, name.
void serveStop(const Job& job) {
  constexpr std::size_t kName = 6;
  if (job.parameters.size() <= kName) return job.refuse(Error::WrongPduSize);
  if (lastText(job.parameters.subspan(kName)) != kProgram)
    return job.refuse(Error::FunctionNotAvailable);
  control(job, Control::Stop);
}

}  // namespace merker::s7comm
