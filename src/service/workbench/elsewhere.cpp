#include "workbench/elsewhere.h"

namespace merker::workbench {

Answer written(Answer answer, const ProjectFolder& folder) {
  if (!answer)
    for (Json& problem : answer.json()) relate(problem, folder);
  std::string text = dump(answer.json());
  const bool good = static_cast<bool>(answer);
  if (text.size() <= kLargestAnswer) return Answer::written(good, std::move(text));
  constexpr std::size_t kMega = 1 << 20;
  const Problems tooLong = refused(ProblemCode::P1308, "the answer",
                                   fmt::format("it would have {} MB; at most {} MB are possible",
                                               text.size() / kMega + 1, kLargestAnswer / kMega));
  return Answer::written(false, dump(toJson(tooLong)));
}

Answer later(Work task, std::function<Answer(const Call&)> then) {
  return Answer::later(std::make_shared<Later>(Later{std::move(task), std::move(then)}));
}

Answer elsewhere(const Call& call, const Worker& worker, std::function<Answer(const Aside&)> work) {
  return elsewhere<Answer>(
      call, worker,
      [work = std::move(work)](const Aside& aside) { return written(work(aside), aside.folder); },
      [](const Call&, Answer& answer) { return std::move(answer); });
}

namespace {

struct Changed {
  Answer answer;
  Listing files;
};

}  // namespace

Answer changingFiles(const Call& call, std::function<Answer(const Aside&)> work) {
  const std::uint64_t number = call.shared.nextLook();
  return elsewhere<Changed>(
      call, call.shared.clerk,
      [work = std::move(work)](const Aside& aside) {
        Answer answer = written(work(aside), aside.folder);
        return Changed{std::move(answer), aside.folder.list()};
      },
      [number](const Call& now, Changed& changed) {
        now.shared.take(number, std::move(changed.files));
        return std::move(changed.answer);
      });
}

}  // namespace merker::workbench
