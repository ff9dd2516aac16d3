// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/workers.h"

#if SIGHTLINE_THREADS
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

namespace sightline {

void run_parts(int count, [[maybe_unused]] int threads, const std::function<void(int)>& part) {
#if SIGHTLINE_THREADS
    if (threads != 1 && count > 1) {
        // Isolated: a thread that waits for the last part must not begin another task, which may want what this one
        // holds.
        const auto all = [&] {
            tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, count, part, tbb::simple_partitioner()); });
        };
        // An arena of its own wakes its threads anew each time, which takes longer than most tasks here.
        if (threads > 0 && threads < tbb::info::default_concurrency())
            tbb::task_arena(threads).execute(all);
        else
            all();
        return;
    }
#endif
    for (int i = 0; i < count; ++i) part(i);
}

}  // namespace sightline
