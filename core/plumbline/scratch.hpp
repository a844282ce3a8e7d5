#pragma once
/// \file
/// Arrays for intermediate results that are made again and again. A fresh page from the operating system
/// costs more than all the arithmetic on its contents, so each thread keeps its last few blocks for the next
/// ones.

#include <array>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

namespace plumbline {

/// The blocks that a thread has given back.
class SpareBlocks {
 public:
  SpareBlocks() = default;
  SpareBlocks(const SpareBlocks&) = delete;
  SpareBlocks& operator=(const SpareBlocks&) = delete;
  ~SpareBlocks() {
    for (const Block& block : spares_) std::free(block.start);
  }

  static SpareBlocks& of_this_thread() {
    thread_local SpareBlocks spares;
    return spares;
  }

  /// A block of at least so many bytes, its first 64 with its size.
  void* take(std::size_t bytes) {
    for (Block& spare : spares_) {
      if (spare.bytes >= bytes && spare.bytes / 4 <= bytes) return std::exchange(spare, {}).start;
    }
    void* const start = std::aligned_alloc(header, header + (bytes + header - 1) / header * header);
    if (start == nullptr) throw std::bad_alloc();
    ::new (start) std::size_t(bytes);
    return start;
  }
  void give_back(void* start) {
    const Block block{start, *static_cast<std::size_t*>(start)};
    std::free(std::exchange(spares_[next_++ % spares_.size()], block).start);
  }

  static constexpr std::size_t header = 64;

 private:
  struct Block {
    void* start = nullptr;
    std::size_t bytes = 0;
  };
  std::array<Block, 8> spares_;
  std::size_t next_ = 0;
};

/// Allocates from the spare blocks, and gives new elements no value where their type allows it.
template <class T>
struct ScratchAllocator {
  using value_type = T;
  ScratchAllocator() = default;
  template <class U>
  ScratchAllocator(const ScratchAllocator<U>& /*other*/) {}  // NOLINT(google-explicit-constructor): rebinding
  bool operator==(const ScratchAllocator&) const = default;

  T* allocate(std::size_t count) {
    void* const block = SpareBlocks::of_this_thread().take(count * sizeof(T));
    return reinterpret_cast<T*>(static_cast<char*>(block) + SpareBlocks::header);
  }
  void deallocate(T* start, std::size_t /*count*/) {
    SpareBlocks::of_this_thread().give_back(reinterpret_cast<char*>(start) - SpareBlocks::header);
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(arguments) == 0) {
      ::new (static_cast<void*>(place)) U;
    } else {
      ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
  }
};

template <class T>
using Scratch = std::vector<T, ScratchAllocator<T>>;

}  // namespace plumbline
