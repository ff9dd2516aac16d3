// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/workers.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace sightline {

void run_parts(int count, int threads, const std::function<void(int)>& part) {
    if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    threads = std::min(threads, count);
    if (threads <= 1) {
        for (int i = 0; i < count; ++i) part(i);
        return;
    }
    std::atomic<int> next = 0;
    std::exception_ptr failed;
    std::mutex failing;
    const auto work = [&] {
        try {
            for (int i; (i = next++) < count;) part(i);
        } catch (...) {
            const std::lock_guard lock(failing);
            if (!failed) failed = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> others;
        try {
            for (int i = 1; i < threads; ++i) others.emplace_back(work);
        } catch (const std::system_error&) {
        }
        work();
    }
    if (failed) std::rethrow_exception(failed);
}

}  // namespace sightline
