#include "support/work/work_list.hpp"

#include "support/work/journal.hpp"
#include "support/work/ranks.hpp"

namespace plumbline::work {

void do_all(const WorkList& list, Journal* journal, const Take& take) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::string* kept = journal ? journal->find(list.items[i]) : nullptr;
    if (kept != nullptr && list.stands(i, *kept))
      take(i, *kept);
    else
      left.push_back(i);
  }
  share(list.task, left.size(),
        {[&](std::size_t i) { return list.items[left[i]]; },
         [&](std::size_t i, const std::string& result) {
           if (journal) journal->add(list.items[left[i]], result);
           take(left[i], result);
         }});
}

std::vector<std::string> results(const WorkList& list, Journal* journal,
                                 const std::function<void()>& advance) {
  std::vector<std::string> all(list.items.size());
  do_all(list, journal, [&](std::size_t i, const std::string& result) {
    all[i] = result;
    advance();
  });
  return all;
}

}  // namespace plumbline::work
