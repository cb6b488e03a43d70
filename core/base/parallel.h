// parallel.h: many similar pieces of work, distributed over a few threads.
#pragma once
#include <cstddef>
#include <functional>

#include "core/base/progress.h"

namespace neph {

/// Does one piece. `worker` is below the number of workers; no two pieces run with the same worker
/// at the same time. `progress` says whether to continue.
using Piece = std::function<void(std::size_t piece, std::size_t worker, const Progress& progress)>;

/// Number of threads that this machine runs at once, at most `most` and at least one.
std::size_t workerCount(std::size_t most);

/// Does `pieces` pieces with `workers` threads, the calling thread included. Throws what the first
/// failing piece threw, or Cancelled; pieces not started by then are skipped. `progress` is called
/// on the calling thread only.
void shareOut(std::size_t pieces, std::size_t workers, const Piece& work,
              const Progress& progress = {});

}  // namespace neph
