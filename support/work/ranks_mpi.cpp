// The processes of MPI. Only the main thread of a rank calls MPI. Nobody waits in a call of it, for there a
// rank would turn at full speed and take the processor from those that work: they look, and sleep a little.
#include <mpi.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <map>
#include <plumbline/base/error.hpp>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/work/ranks.hpp"
#include "support/work/threads.hpp"
#include "support/work/turns.hpp"

namespace plumbline::work {
namespace {

/// What a launcher tells the processes that it starts: Open MPI, PMIx (Slurm), MPICH and its kin.
constexpr std::array<const char*, 3> launcher_words{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};

bool by_launcher = false;
std::vector<int> idle;  ///< ranks that wait for an item: all but the first, between one work and the next

/// A message is an item (name of the task, zero, item), its result, why there is none, or that work is over.
enum class Word { item, result, failure, home };

struct Message {
  int rank;
  Word word;
  std::string text;
};

void send(const Message& message) {
  if (message.text.size() > std::size_t{1} << 30)
    throw Error("an item's result", "more than 1 GiB", "what one message holds");
  MPI_Send(message.text.data(), static_cast<int>(message.text.size()), MPI_CHAR, message.rank,
           static_cast<int>(message.word), MPI_COMM_WORLD);
}

/// Looks, and where nothing is there sleeps, ever longer: 10 us to 1 ms.
Message receive() {
  MPI_Status status{};
  int there = 0;
  auto nap = std::chrono::microseconds(10);
  for (;;) {
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there != 0) break;
    std::this_thread::sleep_for(nap);
    nap = std::min(2 * nap, std::chrono::microseconds(1000));
  }
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  Message message{status.MPI_SOURCE, static_cast<Word>(status.MPI_TAG),
                  std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.text.data(), size, MPI_CHAR, message.rank, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

/// Gives items to whoever is idle and takes what they come to, until nobody is at work any more.
void serve(const Task& task, Turns& turns) {
  std::map<int, std::size_t> busy;
  for (;;) {
    while (!idle.empty()) {
      const auto turn = turns.next();
      if (!turn) break;
      send({idle.back(), Word::item, task.name + std::string(1, '\0') + turn->item});
      busy[idle.back()] = turn->number;
      idle.pop_back();
    }
    if (busy.empty()) return;
    const Message answer = receive();
    const std::size_t number = busy.extract(answer.rank).mapped();
    idle.push_back(answer.rank);
    if (answer.word == Word::result)
      turns.done(number, answer.text);
    else
      turns.failed(number, std::make_exception_ptr(std::runtime_error(answer.text)));
  }
}

Message answer_to(const Message& question, std::span<const Task> tasks) {
  const std::size_t name_size = question.text.find('\0');
  const std::string name = question.text.substr(0, name_size);
  try {
    for (const Task& task : tasks)
      if (task.name == name) return {0, Word::result, task.result(question.text.substr(name_size + 1))};
    return {0, Word::failure, "rank: found no task " + name + ", expected the same program on every rank"};
  } catch (const std::exception& error) {
    return {0, Word::failure, error.what()};
  }
}

}  // namespace

Ranks::Ranks() {
  for (const char* word : launcher_words) by_launcher = by_launcher || std::getenv(word) != nullptr;
  if (!by_launcher) return;
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  for (const char* word : launcher_words) unsetenv(word);  // programs that a rank starts are no ranks
  if (first())
    for (int rank = 1; rank < ranks(); ++rank) idle.push_back(rank);
}

Ranks::~Ranks() {
  if (!by_launcher) return;
  for (const int rank : idle) send({rank, Word::home, ""});
  MPI_Finalize();
}

bool Ranks::first() const {
  int rank = 0;
  if (by_launcher) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank == 0;
}

void Ranks::work(std::span<const Task> tasks) const {
  for (Message question = receive(); question.word != Word::home; question = receive())
    send(answer_to(question, tasks));
}

int ranks() {
  int number = 1;
  if (by_launcher) MPI_Comm_size(MPI_COMM_WORLD, &number);
  return number;
}

bool launched() {
  return by_launcher;
}

void share(const Task& task, std::size_t count, const Exchange& exchange) {
  if (ranks() == 1) return share_among_threads(task, count, exchange);
  Turns turns(count, exchange);
  {
    const std::jthread here([&] { turns.work_through(task); });
    serve(task, turns);
  }
  turns.end();
}

}  // namespace plumbline::work
