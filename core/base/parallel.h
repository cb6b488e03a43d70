// parallel.h: many like pieces of work, shared out to a few threads.
#pragma once
#include <cstddef>
#include <functional>

#include "core/base/progress.h"

namespace neph {

/// Does one piece. `worker` is below the number of workers; no two pieces run with the same one at
/// once. `progress` says whether to go on.
using Piece = std::function<void(std::size_t piece, std::size_t worker, const Progress& progress)>;

/// The threads that this machine runs at once, at most `most` and at least one.
std::size_t workerCount(std::size_t most);

/// Does `pieces` pieces with `workers` threads, of which this one is the first. Throws what the
/// first failing piece threw, or Cancelled; pieces not begun by then are left. `progress` is
/// called on this thread alone.
void shareOut(std::size_t pieces, std::size_t workers, const Piece& work,
              const Progress& progress = {});

}  // namespace neph
