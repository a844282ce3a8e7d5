#pragma once
/// \file
/// Arrays for intermediate results that are made again and again. A fresh page from the operating system
/// costs more than all the arithmetic on its contents, so each thread keeps its last few blocks for the next
/// ones; and a few elements need no block at all.

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>

namespace plumbline::detail {

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

/// An array of fixed size, in place or in a spare block. New elements have no value where their type allows
/// it.
template <class T>
class Scratch {
 public:
  explicit Scratch(std::size_t size) : size_(size) {
    void* const room =
        size <= few ? static_cast<void*>(in_place_)
                    : static_cast<char*>(SpareBlocks::of_this_thread().take(size * sizeof(T))) + header;
    start_ = static_cast<T*>(room);
    std::uninitialized_default_construct_n(start_, size);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::destroy_n(start_, size_);
    if (size_ > few) SpareBlocks::of_this_thread().give_back(reinterpret_cast<char*>(start_) - header);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const T* begin() const { return start_; }
  [[nodiscard]] const T* end() const { return start_ + size_; }
  T& operator[](std::size_t i) { return start_[i]; }
  const T& operator[](std::size_t i) const { return start_[i]; }

 private:
  static constexpr std::size_t few = 16, header = SpareBlocks::header;
  std::size_t size_;
  T* start_;
  alignas(header) std::byte in_place_[few * sizeof(T)];
};

}  // namespace plumbline::detail
