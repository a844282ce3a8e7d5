#include "app/command.hpp"
#include "app/tasks.hpp"
#include "support/work/ranks.hpp"

int main(int argc, char** argv) {
  using namespace plumbline;
  const work::Ranks ranks;
  if (ranks.first()) return app::run(*app::whole_command(), argc, argv);
  ranks.work(app::tasks());
  return 0;
}
