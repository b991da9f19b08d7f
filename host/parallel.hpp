// SPDX-License-Identifier: Apache-2.0
// Work that all processors share.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gonio {

/// Calls work(0) to work(count - 1), each once, on all processors. Throws what the first of them
/// that failed threw.
template <class Work>
void in_parallel(std::size_t count, const Work& work)
{
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex guard;
    const auto take = [&] {
        try {
            for (std::size_t k = next++; k < count; k = next++) work(k);
        } catch (...) {
            const std::scoped_lock lock(guard);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::jthread> others;
    for (unsigned k = 1; k < std::min<std::size_t>(std::thread::hardware_concurrency(), count); ++k)
        others.emplace_back(take);
    take();
    others.clear();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace gonio
