#pragma once
/// \file
/// The reference values as work that many share.

#include "support/work/work_list.hpp"
#include "verify/reference/loaded.hpp"
#include "verify/reference/set.hpp"
#include "verify/reference/structures.hpp"

namespace plumbline::verify {

/// What another process is told: to compute and certify what is published about one chain.
extern const work::Task reference_task;

/// An item a chain, straight ones before loaded ones.
work::WorkList reference_work(const ReferenceWish& wish);

struct ReferenceValues {
  std::vector<ReferenceEntry> entries;
  LoadedEntries loaded;
  StructureEntries structures;
};

/// \param results  of the items of this work, in their order
ReferenceValues reference_values(const ReferenceWish& wish, const std::vector<std::string>& results);

}  // namespace plumbline::verify
