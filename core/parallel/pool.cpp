#include "core/parallel/pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace whorl {
namespace {

/// Bands a thread: enough to even out rows of unequal cost, few enough to keep rows together in a cache.
constexpr int bands_per_thread = 4;
/// Below this a band is not worth waking a thread for.
constexpr int min_rows_per_band = 4;
/// How long a thread watches for the next loop before it sleeps. Waking takes 20 to 50 µs, longer than most
/// loops over a grid; a solver starts the next one within a few.
constexpr auto patience = std::chrono::microseconds(20);

/// Watches until `ready()` holds or patience ends.
template <class Ready>
void watch(Ready&& ready) {
    const auto end = std::chrono::steady_clock::now() + patience;
    do {
        for (int k = 0; k < 32; ++k) {
            if (ready()) return;
#ifdef __SSE2__
            _mm_pause();
#endif
        }
    } while (std::chrono::steady_clock::now() < end);
}

}  // namespace

void flush_denormals() {
#ifdef __SSE2__
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

struct Pool::Shared {
    std::mutex mutex;
    std::condition_variable wake;
    std::condition_variable done;
    std::vector<std::thread> threads;
    bool stopping = false;
    bool open = false;                    ///< whether threads may still join the round
    std::atomic<std::uint64_t> round{0};  ///< counts calls of run; a thread joins each at most once
    std::atomic<int> working{0};          ///< threads that have joined and are not done

    Call call = nullptr;
    void* work = nullptr;
    int rows = 0;
    int band = 0;
    std::atomic<int> next{0};

    void take_bands(int thread) {
        for (;;) {
            const int first = next.fetch_add(band, std::memory_order_relaxed);
            if (first >= rows) return;
            call(work, first, std::min(first + band, rows), thread);
        }
    }

    void serve(int thread) {
        flush_denormals();
        std::uint64_t seen = 0;
        std::unique_lock lock(mutex);
        for (;;) {
            lock.unlock();
            watch([&] { return round.load(std::memory_order_relaxed) != seen; });
            lock.lock();
            wake.wait(lock, [&] { return stopping || round.load(std::memory_order_relaxed) != seen; });
            if (stopping) return;
            seen = round.load(std::memory_order_relaxed);
            if (!open) continue;  // too late: the others have done it all
            working.fetch_add(1, std::memory_order_relaxed);
            lock.unlock();
            take_bands(thread);
            lock.lock();
            if (working.fetch_sub(1, std::memory_order_relaxed) == 1) done.notify_one();
        }
    }
};

Pool::Pool(int threads) : shared_(std::make_unique<Shared>()) {
    if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    for (int k = 1; k < threads; ++k) shared_->threads.emplace_back([s = shared_.get(), k] { s->serve(k); });
}

Pool::~Pool() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->stopping = true;
    }
    shared_->wake.notify_all();
    for (std::thread& thread : shared_->threads) thread.join();
}

int Pool::threads() const {
    return static_cast<int>(shared_->threads.size()) + 1;
}

void Pool::run(int rows, Call call, void* work) {
    if (rows <= 0) return;
    const int helpers = static_cast<int>(shared_->threads.size());
    const int band = std::max(min_rows_per_band, rows / ((helpers + 1) * bands_per_thread));
    if (helpers == 0 || rows <= band) {
        call(work, 0, rows, 0);
        return;
    }
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->call = call;
        shared_->work = work;
        shared_->rows = rows;
        shared_->band = band;
        shared_->next.store(0, std::memory_order_relaxed);
        shared_->open = true;
        shared_->round.fetch_add(1, std::memory_order_relaxed);
    }
    shared_->wake.notify_all();
    shared_->take_bands(0);
    const auto all_done = [&] { return shared_->working.load(std::memory_order_relaxed) == 0; };
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->open = false;  // whoever has not joined yet need not be waited for
    }
    watch(all_done);
    std::unique_lock lock(shared_->mutex);
    shared_->done.wait(lock, all_done);
}

}  // namespace whorl
