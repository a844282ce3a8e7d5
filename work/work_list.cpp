#include "work/work_list.hpp"

#include "work/journal.hpp"
#include "work/ranks.hpp"

namespace plumbline::work {

std::vector<std::string> results(const WorkList& list, Journal* journal,
                                 const std::function<void()>& advance) {
  std::vector<std::string> all(list.items.size());
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string* kept = journal ? journal->find(list.items[i]) : nullptr;
    if (kept != nullptr && list.stands(i, *kept)) {
      all[i] = *kept;
      advance();
    } else {
      left.push_back(i);
    }
  }
  share(list.task, left.size(),
        {[&](std::size_t i) { return list.items[left[i]]; },
         [&](std::size_t i, std::string result) {
           if (journal) journal->add(list.items[left[i]], result);
           all[left[i]] = std::move(result);
           advance();
         }});
  return all;
}

}  // namespace plumbline::work
