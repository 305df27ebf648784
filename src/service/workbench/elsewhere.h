// Requests that may take longer than a slice: they are answered by a worker, which looks at copies
// only. What the PLC's thread still has to do comes afterwards.
#pragma once

#include "workbench/method.h"

namespace merker::workbench {

// An answer is at most so long.
constexpr std::size_t kLargestAnswer = 8 << 20;

// Its text, with files named as the project names them. P1308 for one that is too long.
Answer written(Answer answer, const ProjectFolder& folder);

// What a worker gets: the fields of the request, the project folder, whether somebody still waits.
struct Aside {
  const Fields& fields;
  const ProjectFolder& folder;
  const std::stop_token& stop;

  Answer wrong() const { return fields.problems(); }
};

// The answer of the request is made of what the task has left, when it is done.
Answer later(Work task, std::function<Answer(const Call&)> then);

// `work` makes something, in the thread of this worker; `then` makes the answer of it.
template <typename T>
Answer elsewhere(const Call& call, const Worker& worker, std::function<T(const Aside&)> work,
                 std::function<Answer(const Call&, T&)> then) {
  auto result = std::make_shared<std::optional<T>>();
  auto task =
      std::make_shared<Task>(call.id, [result, work = std::move(work), request = call.request,
                                       folder = call.shared.folder](const std::stop_token& stop) {
        Problems problems;
        const Fields fields(*request, problems);
        result->emplace(work({fields, folder, stop}));
      });
  worker(task);
  return later(std::move(task), [result, then = std::move(then)](const Call& now) mutable {
    Answer answer = then(now, **result);
    now.shared.discard(std::move(result));
    return answer;
  });
}

// `work` makes the answer; its text is written there, too.
Answer elsewhere(const Call& call, const Worker& worker, std::function<Answer(const Aside&)> work);
// The same, of work that changes files of the project: the folder is looked at afterwards.
Answer changingFiles(const Call& call, std::function<Answer(const Aside&)> work);

}  // namespace merker::workbench
